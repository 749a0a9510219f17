package org.jsmesh.memory;

import java.io.IOException;
import java.util.Arrays;
import java.util.BitSet;

/**
 * Counts by the accessors of a glTF file, compressed ones included, and by how often the shown scene shows each mesh.
 */
final class GltfCount {
    /** Of a larger description nothing is known but its length: this runs in processes with little heap. */
    static final int MOST_DESCRIPTION = 4 << 20;

    private static final int CHUNK = 20;
    private static final int MOST_VISITS = 1_000_000;
    private static final int TRIANGLES = 4;
    private static final int TRIANGLE_FAN = 6;

    /** Bytes of a file for each triangle where the description cannot be read: indices, half a vertex with a normal. */
    private static final int LIKELY_BYTES = 24;

    private final GltfOutline outline;
    private final double[] shown; // how often, by mesh
    private boolean isSure = true;
    private double faces;
    private double leastFaces;
    private double vertices;
    private int channels;

    private GltfCount(GltfOutline outline) {
        this.outline = outline;
        shown = new double[outline.primitivesEnd.size()];
    }

    static ModelCount of(Sampled file) throws IOException {
        boolean binary = file.startsWith("glTF");
        long bytes = binary ? file.littleEndian(12) : file.length();
        byte[] text = new byte[0];
        if (bytes <= MOST_DESCRIPTION) text = file.read(binary ? CHUNK : 0, (int) bytes);
        if (bytes > 0 && text.length == bytes) {
            try {
                GltfCount count = new GltfCount(GltfOutline.of(text));
                count.count();
                // A length that its header contradicts is that of something else, or a claim.
                boolean isWhole = !binary || file.littleEndian(8) == file.length();
                return count.toModelCount(isWhole, file);
            } catch (IOException e) {
                // Reading it will tell.
            }
        }
        double faces = (double) file.length() / LIKELY_BYTES;
        return new ModelCount(faces, 0, faces, 0, 5, file.length(), 0, false, false);
    }

    private ModelCount toModelCount(boolean isWhole, Sampled file) {
        double least = isWhole && isSure ? leastFaces : 0;
        return new ModelCount(faces, least, vertices, 0, channels, file.length(), 0, false, outline.materials > 1);
    }

    private void count() throws IOException {
        if (outline.nodeMeshes.size() == 0) {
            isSure = false;
            Arrays.fill(shown, 1);
        } else {
            walk();
        }
        int primitive = 0;
        for (int mesh = 0; mesh < shown.length; mesh++) {
            for (; primitive < outline.primitivesEnd.get(mesh, 0); primitive++) count(primitive, shown[mesh]);
        }
    }

    /** As the reader of the scene goes. */
    private void walk() throws IOException {
        IntList open = roots();
        long visits = 0;
        while (open.size() > 0) {
            int node = open.removeLast();
            int mesh = outline.nodeMeshes.get(node, GltfOutline.HIDDEN);
            if (mesh == GltfOutline.HIDDEN) continue;
            int child = outline.childrenEnd.get(node - 1, 0);
            int end = outline.childrenEnd.get(node, 0);
            visits += 1 + end - child;
            if (visits > MOST_VISITS) {
                isSure = false; // more than a scene may have, or nodes below themselves
                return;
            }
            if (mesh >= 0 && mesh < shown.length) shown[mesh] += instances(node);
            for (; child < end; child++) open.add(outline.children.get(child, -1));
        }
    }

    /** Nodes of the shown scene; without scenes, all that are no children. */
    private IntList roots() throws IOException {
        IntList roots = new IntList();
        if (outline.rootsEnd.size() > 0) {
            int end = outline.rootsEnd.get(outline.scene, 0);
            for (int i = outline.rootsEnd.get(outline.scene - 1, 0); i < end; i++) roots.add(outline.roots.get(i, -1));
            return roots;
        }
        BitSet children = new BitSet();
        for (int i = 0; i < outline.children.size(); i++) {
            int child = outline.children.get(i, -1);
            if (child >= 0 && child < outline.nodeMeshes.size()) children.set(child);
        }
        for (int node = 0; node < outline.nodeMeshes.size(); node++) if (!children.get(node)) roots.add(node);
        return roots;
    }

    private int instances(int node) {
        int from = outline.instancesEnd.get(node - 1, 0);
        int end = outline.instancesEnd.get(node, 0);
        int least = from == end ? 1 : Integer.MAX_VALUE;
        for (int i = from; i < end; i++) least = Math.min(least, elements(outline.instances.get(i, -1)));
        return least;
    }

    private void count(int primitive, double times) {
        int mode = outline.modes.get(primitive, 0);
        if (mode < TRIANGLES || mode > TRIANGLE_FAN) return;
        int points = elements(outline.positions.get(primitive, -1));
        int index = outline.indices.get(primitive, -1);
        int corners = index < 0 ? points : elements(index);
        if (points == 0) return;
        int triangles = mode == TRIANGLES ? corners / 3 : Math.max(0, corners - 2);
        if (mode == TRIANGLES) leastFaces += times * triangles;
        faces += times * triangles;
        vertices += times * points;
        int values = 0;
        int end = outline.attributesEnd.get(primitive, 0);
        for (int i = outline.attributesEnd.get(primitive - 1, 0); i < end; i++)
            values += outline.accessorWidths.get(outline.attributes.get(i, -1), 1);
        if (times > 0) channels = Math.max(channels, values);
    }

    private int elements(int accessor) {
        return outline.accessorCounts.get(accessor, 0);
    }
}
