package org.jsmesh.memory;

import java.io.IOException;
import java.util.Locale;

/**
 * What the header of a model says, or its samples suggest.
 *
 * @param faces triangles that it is likely to have
 * @param leastFaces triangles that it has at least, if it is whole
 * @param vertices places of corners that it stores
 * @param channels values of attributes of a corner
 * @param fileBytes of the file that are in memory while it is read
 * @param unpackedBytes of what is unpacked from it
 * @param soup whether each triangle has corners of its own until they are merged
 */
record ModelCount(
        double faces,
        double leastFaces,
        double vertices,
        int channels,
        long fileBytes,
        long unpackedBytes,
        boolean soup) {

    static ModelCount exact(double faces, double vertices, int channels, Sampled file) {
        return new ModelCount(faces, faces, vertices, channels, file.length(), 0, false);
    }

    ModelCount withPacked(long packedBytes) {
        return new ModelCount(
                faces, leastFaces, vertices, channels, packedBytes, Math.max(unpackedBytes, fileBytes), soup);
    }

    static ModelCount of(Sampled file) throws IOException {
        String name = file.name().toLowerCase(Locale.ROOT);
        if (file.startsWith("ply")) return PlyCount.of(file);
        if (file.startsWith("\u001f\u008b") || isGzip(file)) return PackedCount.ofGzip(file);
        if (file.startsWith("PK")) return PackedCount.ofZip(file);
        if (file.startsWith("glTF") || name.endsWith(".gltf")) return GltfCount.of(file);
        if (isBinaryStl(file)) return stl(file);
        return TextCount.of(file);
    }

    private static boolean isGzip(Sampled file) throws IOException {
        byte[] b = file.start();
        return b.length > 2 && (b[0] & 255) == 0x1f && (b[1] & 255) == 0x8b;
    }

    private static boolean isBinaryStl(Sampled file) throws IOException {
        byte[] start = file.start();
        if (start.length < 84) return false;
        if (file.length() == 84 + 50 * file.littleEndian(80)) return true;
        return file.name().toLowerCase(Locale.ROOT).endsWith(".stl") && !file.startsWith("solid");
    }

    private static ModelCount stl(Sampled file) {
        double faces = Math.max(0, (file.length() - 84) / 50);
        return new ModelCount(faces, faces, faces / 2, 0, file.length(), 0, true);
    }
}
