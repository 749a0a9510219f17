package org.jsmesh.store;

import java.util.List;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.files.ModelBounds;

/**
 * What a catalogue tells of an archive. It stays in memory for every model that was asked for, while the archive itself
 * may be closed meanwhile.
 *
 * @param sha256 of the archive's bytes, in lower-case hexadecimal
 * @param meshSha256 identity of the mesh
 * @param bytes of the archive
 * @param faces of the original
 * @param vertices of the original
 * @param baseFaces of the base mesh
 * @param baseBytes of header, index and base
 * @param materials number of them
 * @param textures number of images
 * @param hasPoster whether a picture is in the archive
 * @param bounds of the original: least x, y, z, then greatest, as floats or doubles
 */
public record ArchiveFacts(
        String sha256,
        String meshSha256,
        long bytes,
        int faces,
        int vertices,
        int baseFaces,
        long baseBytes,
        int materials,
        int textures,
        boolean hasPoster,
        List<Number> bounds) {
    /**
     * Copies the bounds.
     *
     * @param sha256 see {@link #sha256()}
     * @param meshSha256 see {@link #meshSha256()}
     * @param bytes see {@link #bytes()}
     * @param faces see {@link #faces()}
     * @param vertices see {@link #vertices()}
     * @param baseFaces see {@link #baseFaces()}
     * @param baseBytes see {@link #baseBytes()}
     * @param materials see {@link #materials()}
     * @param textures see {@link #textures()}
     * @param hasPoster see {@link #hasPoster()}
     * @param bounds see {@link #bounds()}
     */
    public ArchiveFacts {
        bounds = List.copyOf(bounds);
    }

    static ArchiveFacts of(Archive archive) {
        ArchiveHeader header = archive.header();
        return new ArchiveFacts(
                archive.sha256(),
                header.meshSha256(),
                archive.bytes(),
                header.faces(),
                header.vertices(),
                header.batches().faces(0),
                header.batches().bytes(0),
                header.materials().size(),
                header.images().size(),
                header.batches().poster() >= 0,
                ModelBounds.of(header));
    }
}
