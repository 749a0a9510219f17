package org.jsmesh.session;

import java.io.IOException;
import java.net.URI;
import java.util.function.BooleanSupplier;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.plan.BatchRequest;

/** Where the bytes of an archive come from. Used by the session's thread alone. */
interface ArchiveSource {
    /**
     * Finds the archive, if the address alone does not say where it is. Called before each request; only the first call
     * does something.
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
     * True when bytes cost no more than reading them. A round then asks for everything, and only its deadline ends it.
     */
    default boolean isLocal() {
        return false;
    }

    /** The sizes of the batches as far as they are known before the archive's own index has arrived, or null. */
    default BatchIndex promisedIndex() {
        return null;
    }

    /** SHA-256 that the archive's bytes must have, lower-case hexadecimal, or null. */
    default String archiveSha256() {
        return null;
    }

    /** SHA-256 that the mesh must have, in addition to the one in the archive, or null. */
    default String meshSha256() {
        return null;
    }

    /** SHA-256 that mesh and images must have, in addition to those in the archive, or null. */
    default String modelSha256() {
        return null;
    }

    /** Address of the archive, once it is located; null for an archive that need not be kept. */
    default URI address() {
        return null;
    }

    /**
     * After an answer that the archive is not there, looks whether its manifest names another one by now. The source
     * then uses that one.
     *
     * @param cancelled asked while waiting
     */
    default boolean isRenewed(BooleanSupplier cancelled) throws IOException {
        return false;
    }

    /** The address, for messages. */
    String name();
}
