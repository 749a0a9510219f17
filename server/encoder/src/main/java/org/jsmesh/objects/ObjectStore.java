package org.jsmesh.objects;

import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.Optional;

/**
 * Objects by key: a folder of files, or a part of a bucket. An object is written whole or not at all; who reads it gets
 * all of one version. Keys are names with slashes between them; none is empty, {@code .} or {@code ..}, or begins with
 * a dot in a folder, where such files are not objects. Thread-safe.
 */
public interface ObjectStore extends AutoCloseable {
    /** {@return where the objects are, for people and for {@link ObjectStores#open}} */
    String address();

    /**
     * Looks for an object.
     *
     * @param key of the object
     * @return what is known of it; empty when there is none
     * @throws IllegalArgumentException when the key is none, see {@link ObjectKeys#check}
     * @throws IOException when that cannot be found out
     */
    Optional<StoredObject> find(String key) throws IOException;

    /**
     * Opens an object from its first byte.
     *
     * @param key of the object
     * @return its bytes, to be closed; all of one version
     * @throws IllegalArgumentException when the key is none, see {@link ObjectKeys#check}
     * @throws java.nio.file.NoSuchFileException when there is none
     * @throws IOException when it cannot be read
     */
    InputStream open(String key) throws IOException;

    /**
     * Reads a part of one version of an object.
     *
     * @param object as it was found
     * @param offset of the first byte from the start of the object
     * @param into as many bytes as remain in it are read, all of which must be in the object
     * @throws IllegalArgumentException when its key is none, see {@link ObjectKeys#check}
     * @throws ObjectConflictException when there is another version by now, or none
     * @throws IOException when it cannot be read
     */
    void read(StoredObject object, long offset, ByteBuffer into) throws IOException;

    /**
     * Writes an object, whole or not at all.
     *
     * @param upload key, content, and the condition under which it is written
     * @return the object that is there now
     * @throws IllegalArgumentException when its key is none, see {@link ObjectKeys#check}
     * @throws ObjectConflictException when the condition does not hold; nothing has changed then
     * @throws IOException when it cannot be written
     */
    StoredObject put(Upload upload) throws IOException;

    /**
     * Removes an object.
     *
     * @param key of the object; without effect where there is none
     * @throws IllegalArgumentException when the key is none, see {@link ObjectKeys#check}
     * @throws IOException when it cannot be removed
     */
    void delete(String key) throws IOException;

    /**
     * Goes through objects in the order of their keys' UTF-8 bytes. Those that come or go meanwhile may be met or not.
     *
     * @param prefix that keys begin with, cut anywhere; empty for all
     * @param after begins behind this key, whether or not it is there; empty for the beginning
     * @param visitor is told of each
     * @throws IOException when they cannot be listed, or from the visitor
     */
    void list(String prefix, String after, Visitor visitor) throws IOException;

    /** Is told of objects. */
    @FunctionalInterface
    interface Visitor {
        /**
         * Takes one.
         *
         * @param object the next in order
         * @return false to be told of no other
         * @throws IOException ends the listing
         */
        boolean visit(StoredObject object) throws IOException;

        /**
         * Is told of what this process cannot open, as the locale cannot hold its name: a file, or a folder with all in
         * it. That comes in no order.
         *
         * @param key of it; that of a folder ends with a slash
         * @param reason with what to do
         * @throws IOException the reason, unless this is overridden: who misses an object takes it for removed
         */
        default void unreadable(String key, IOException reason) throws IOException {
            throw reason;
        }

        /**
         * Is told of what no store opens, as its name {@linkplain ObjectKeys#check is no key}, such as {@code a//b} in
         * a bucket. Other programs can have written it. Names that end with a slash, by which consoles show folders,
         * are passed over without a word.
         *
         * @param name of it, behind the address of the store
         * @param reason with what to do
         * @throws IOException ends the listing; unless this is overridden, nothing happens: this library writes no such
         *     object
         */
        default void unnameable(String name, IOException reason) throws IOException {}
    }

    /**
     * An address under which anybody can read the object for a while, without rights of their own.
     *
     * @param key of the object, which need not exist
     * @param lifetime how long it works
     * @return the address; empty where there is no such thing, as in folders, or where it cannot be made now
     * @throws IllegalArgumentException when the key is none, see {@link ObjectKeys#check}
     */
    default Optional<URI> signedAddress(String key, Duration lifetime) {
        ObjectKeys.check(key);
        return Optional.empty();
    }

    @Override
    void close() throws IOException;
}
