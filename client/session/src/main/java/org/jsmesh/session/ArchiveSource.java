package org.jsmesh.session;

import java.io.IOException;
import java.net.URI;
import java.util.function.BooleanSupplier;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.plan.BatchRequest;

/** Where the bytes of an archive come from. Used by the session's thread alone. */
interface ArchiveSource {
    /**
     * Finds out where the archive is, if the address alone does not say so. Called before each request; does something
     * once.
     *
     * @param cancelled asked while waiting
     */
    default void locate(BooleanSupplier cancelled) throws IOException {}

    /**
     * Asks for bytes.
     *
     * @param fromByte first byte
     * @param endByte byte after the last one, or −1 for all that follow
     * @param entityTag that the archive must still have, or null
     */
    ArchiveBody open(long fromByte, long endByte, String entityTag);

    /** Asks the server to plan the batches itself. Only where {@link #isPlanning()}. */
    default ArchiveBody openPlanned(BatchRequest request) {
        throw new UnsupportedOperationException("this source does not plan");
    }

    /** True when the server turns bandwidth and wait into batches. */
    default boolean isPlanning() {
        return false;
    }

    /**
     * True when bytes cost no more than reading them: a round then asks for everything, and its deadline alone says
     * where it stops.
     */
    default boolean isLocal() {
        return false;
    }

    /** The index as far as it is known before the archive's own has arrived: sizes alone; or null. */
    default BatchIndex promisedIndex() {
        return null;
    }

    /** SHA-256 that the archive's bytes must have, lower-case hexadecimal, or null. */
    default String archiveSha256() {
        return null;
    }

    /** SHA-256 that the mesh must have beside what the archive says itself, or null. */
    default String meshSha256() {
        return null;
    }

    /** Where the archive is, once it is located; null for what needs no keeping. */
    default URI address() {
        return null;
    }

    /**
     * Looks, after an answer that the archive is not there, whether its manifest names another one by now, which is the
     * source's from then on.
     *
     * @param cancelled asked while waiting
     */
    default boolean isRenewed(BooleanSupplier cancelled) throws IOException {
        return false;
    }

    /** The address, for messages. */
    String name();
}
