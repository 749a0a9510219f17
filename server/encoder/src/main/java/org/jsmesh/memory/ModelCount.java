package org.jsmesh.memory;

import java.io.IOException;
import java.util.Locale;

/**
 * What the header of a model says, or its samples suggest.
 *
 * @param faces triangles that it is likely to have
 * @param leastFaces triangles that it has at least, if it is whole
 * @param vertices that it stores; of STL files those that are likely to be there
 * @param wedges corners that differ in their place or their attributes, where they are likely to be more than the
 *     vertices: three a face where faces have attributes of their own; else 0
 * @param channels values of attributes of a corner
 * @param fileBytes of the file that are in memory while it is read
 * @param unpackedBytes of what is unpacked from it
 * @param isByPlace whether no two vertices are likely to have one place
 * @param hasMaterials whether faces differ in material
 */
record ModelCount(
        double faces,
        double leastFaces,
        double vertices,
        double wedges,
        int channels,
        long fileBytes,
        long unpackedBytes,
        boolean isByPlace,
        boolean hasMaterials) {

    /** So many colours of faces in a sample are those of parts. More are a picture, and are kept at the corners. */
    static final int PARTS = 8;

    /** A gzip file may be in an archive, and an archive in a gzip file; nothing is unpacked further. */
    private static final int MOST_LAYERS = 2;

    ModelCount withPacked(long packedBytes) {
        long unpacked = Math.max(unpackedBytes, fileBytes);
        return new ModelCount(
                faces, leastFaces, vertices, wedges, channels, packedBytes, unpacked, isByPlace, hasMaterials);
    }

    static ModelCount of(Sampled file) throws IOException {
        return of(file, MOST_LAYERS);
    }

    /** @param layers of packing that are looked into */
    static ModelCount of(Sampled file, int layers) throws IOException {
        String name = file.name().toLowerCase(Locale.ROOT);
        if (file.startsWith("ply") || file.startsWith(Sampled.BYTE_ORDER_MARK + "ply")) return PlyCount.of(file);
        if (layers > 0 && isGzip(file)) return PackedCount.ofGzip(file, layers - 1);
        if (layers > 0 && file.startsWith("PK")) return PackedCount.ofZip(file, layers - 1);
        if (file.startsWith("glTF") || name.endsWith(".gltf")) return GltfCount.of(file);
        if (StlCount.isBinary(file)) return StlCount.of(file);
        return TextCount.of(file);
    }

    private static boolean isGzip(Sampled file) throws IOException {
        byte[] b = file.start();
        return b.length > 2 && (b[0] & 255) == 0x1f && (b[1] & 255) == 0x8b;
    }
}
