package org.jsmesh.session;

import java.io.IOException;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.Proof;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.session.cache.KeptArchive;

/**
 * Takes the bytes of one archive in file order, from any number of answers. Decodes and hashes them, and checks that
 * they belong to the same archive.
 */
final class ReceivedArchive {
    private final MeshStream stream;
    private final String name;
    private final ArrivedBytes arrived;
    private final MessageDigest digest = sha256();
    private long bytes;
    private long archiveBytes = -1;
    private String entityTag;
    private KeptArchive kept;

    /** @param arrived is given every byte, or null */
    ReceivedArchive(String name, MeshStream stream, ArrivedBytes arrived) {
        this.name = name;
        this.arrived = arrived;
        this.stream = stream;
    }

    /** Bytes held, partial batches included. */
    long bytes() {
        return bytes;
    }

    /** Strong entity tag of the archive, or null. */
    String entityTag() {
        return entityTag;
    }

    /** Null until header and index have arrived. */
    ArchiveHeader header() {
        return stream.header();
    }

    /** Null until header and index have arrived. */
    BatchIndex index() {
        return stream.header() == null ? null : stream.header().batches();
    }

    int batches() {
        return stream.batches();
    }

    boolean isComplete() {
        return stream.isComplete();
    }

    Mesh mesh() {
        return stream.mesh();
    }

    /** Checks that an answer belongs to the archive that was begun. */
    void join(ArchiveBody.Head head) throws ArchiveChangedException {
        if (head.entityTag() != null) {
            if (entityTag != null && !entityTag.equals(head.entityTag())) {
                throw changed("its entity tag was " + entityTag + " and is " + head.entityTag());
            }
            entityTag = head.entityTag();
        }
        if (head.archiveBytes() >= 0) {
            if (archiveBytes >= 0 && archiveBytes != head.archiveBytes()) {
                throw changed("it had " + archiveBytes + " bytes and has " + head.archiveBytes());
            }
            archiveBytes = head.archiveBytes();
        }
    }

    /**
     * Takes what earlier sessions have kept, and keeps what comes.
     *
     * @throws MalformedStreamException when the kept bytes are not what the format allows; they are dropped
     */
    void restore(KeptArchive from) throws IOException {
        kept = from;
        from.restore((array, length) -> feed(array, 0, length));
    }

    /** Ends with what is kept. */
    void close() {
        if (kept != null) kept.close();
        kept = null;
    }

    private ArchiveChangedException changed(String how) {
        if (kept != null) kept.forget();
        return new ArchiveChangedException(name, how);
    }

    /**
     * Takes the next bytes.
     *
     * @throws MalformedStreamException when they are not what the format allows
     */
    void take(byte[] array, int offset, int length) throws MalformedStreamException {
        feed(array, offset, length);
        if (kept != null) kept.append(array, offset, length);
    }

    private void feed(byte[] array, int offset, int length) throws MalformedStreamException {
        try {
            decode(array, offset, length);
        } catch (MalformedStreamException e) {
            if (kept != null) kept.forget();
            throw e;
        }
    }

    private void decode(byte[] array, int offset, int length) throws MalformedStreamException {
        digest.update(array, offset, length);
        if (arrived != null) arrived.append(array, offset, length);
        bytes += length;
        boolean first = stream.header() == null;
        stream.feed(array, offset, length);
        if (first && stream.header() != null && archiveBytes > index().archiveBytes()) {
            throw new MalformedStreamException(
                    bytes,
                    name + ": the file has " + archiveBytes + " bytes, its index promises " + index().archiveBytes());
        }
    }

    /**
     * Checks, when an answer ended, that the file does not end before its index does.
     *
     * @param whole the answer was the whole file
     */
    void checkEnd(boolean whole) throws MalformedStreamException {
        if (stream.isComplete()) return;
        if (whole || archiveBytes >= 0 && bytes >= archiveBytes) {
            String promised = index() == null
                    ? "before its index is complete"
                    : "though its index promises " + index().archiveBytes() + " bytes";
            throw new MalformedStreamException(bytes, name + ": the archive is cut off: it ends " + promised);
        }
    }

    /** Hash of the bytes held. */
    byte[] prefixHash() {
        try {
            return ((MessageDigest) digest.clone()).digest();
        } catch (CloneNotSupportedException e) {
            throw new IllegalStateException("SHA-256 of the JDK can be cloned", e);
        }
    }

    /** The mesh, and how its hashes compare with those that header, manifest and address promise. */
    SessionResult verify(ArchiveSource source) throws IOException {
        Mesh mesh = stream.original();
        Proof proof = stream.prove(mesh);
        String meshHash = proof.meshSha256();
        String archiveHash = HexFormat.of().formatHex(prefixHash());
        String difference = null;
        if (!proof.isOriginal()) {
            difference = proof.difference();
        } else if (source.meshSha256() != null && !meshHash.equals(source.meshSha256())) {
            difference = "SHA-256 of the mesh is " + meshHash + ", the manifest promises " + source.meshSha256();
        } else if (source.modelSha256() != null && !proof.modelSha256().equals(source.modelSha256())) {
            difference = "SHA-256 of the model is " + proof.modelSha256() + ", the manifest promises "
                    + source.modelSha256();
        } else if (source.archiveSha256() != null && !archiveHash.equals(source.archiveSha256())) {
            difference =
                    "SHA-256 of the archive is " + archiveHash + ", its address promises " + source.archiveSha256();
        }
        if (difference != null && kept != null) kept.forget();
        return new SessionResult(mesh, meshHash, archiveHash, difference);
    }

    static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every JDK has SHA-256", e);
        }
    }
}
