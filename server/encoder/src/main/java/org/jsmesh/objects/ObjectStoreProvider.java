package org.jsmesh.objects;

import java.io.IOException;
import java.time.Duration;

/** Opens stores of one kind of address. Found by {@link java.util.ServiceLoader}. */
public interface ObjectStoreProvider {
    /** {@return the scheme of the addresses, in lower case: {@code s3}} */
    String scheme();

    /**
     * Opens a store.
     *
     * @param address with this scheme; behind the scheme it is text, in which nothing is encoded
     * @return the store
     * @throws IllegalArgumentException when the address is not one of a store
     * @throws IOException when the store cannot be opened; what is in it need not be looked at
     */
    ObjectStore open(String address) throws IOException;

    /**
     * Opens a store that does not wait long.
     *
     * @param address with this scheme
     * @param patience how long an answer is waited for, with what is tried again; a kind of store that cannot be told
     *     need not heed it
     * @return the store
     * @throws IllegalArgumentException when the address is not one of a store
     * @throws IOException when the store cannot be opened; what is in it need not be looked at
     */
    default ObjectStore open(String address, Duration patience) throws IOException {
        return open(address);
    }
}
