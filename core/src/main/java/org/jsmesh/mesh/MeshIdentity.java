package org.jsmesh.mesh;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * The identity of a mesh: SHA-256 over its distinct corner tuples, materials and faces, in an order that depends on
 * neither ids nor file order. The bytes are specified in {@code docs/format.md}.
 */
public final class MeshIdentity {
    private MeshIdentity() {}

    /** SHA-256, as the platform has it. */
    public interface Hash {
        /**
         * Hashes some bytes more.
         *
         * @param bytes an array that holds them
         * @param offset of the first of them
         * @param count number of bytes
         */
        void update(byte[] bytes, int offset, int count);

        /**
         * Ends the hash, which is used up then.
         *
         * @return 32 bytes
         */
        byte[] digest();
    }

    /** Collects what is hashed, four bytes a number, so that the hash is not called for each. */
    private static final class Numbers {
        private final Hash hash;
        private final byte[] buffer = new byte[1 << 12];
        private int filled;

        Numbers(Hash hash) {
            this.hash = hash;
        }

        void updateInt(int value) {
            if (filled == buffer.length) flush();
            buffer[filled] = (byte) value;
            buffer[filled + 1] = (byte) (value >>> 8);
            buffer[filled + 2] = (byte) (value >>> 16);
            buffer[filled + 3] = (byte) (value >>> 24);
            filled += 4;
        }

        void update(byte[] bytes) {
            flush();
            hash.update(bytes, 0, bytes.length);
        }

        void flush() {
            hash.update(buffer, 0, filled);
            filled = 0;
        }
    }

    /**
     * Hashes a mesh.
     *
     * @param mesh any mesh
     * @return 64 lower-case hexadecimal digits
     */
    public static String sha256(Mesh mesh) {
        return sha256(mesh, new Sha256());
    }

    /**
     * Hashes a mesh with another implementation of SHA-256.
     *
     * @param mesh any mesh
     * @param hash which has hashed nothing yet
     * @return 64 lower-case hexadecimal digits
     */
    public static String sha256(Mesh mesh, Hash hash) {
        Numbers sha = new Numbers(hash);
        List<Channel> channels = new ArrayList<>(mesh.channels());
        channels.sort(
                Comparator.comparingInt(c -> c.semantic().ordinal())); // stable: sets of one kind keep their order
        sha.updateInt(mesh.faces());
        sha.updateInt(channels.size());
        for (Channel c : channels) {
            sha.updateInt(c.semantic().ordinal());
            sha.updateInt(c.components());
            sha.updateInt(c.type().ordinal());
        }
        int[] ranks = new int[mesh.wedges()];
        int distinct = hashTuples(sha, mesh, channels, ranks);
        int[] materialRanks = hashMaterials(sha, mesh);
        hashFaces(sha, mesh, ranks, materialRanks, distinct);
        sha.flush();
        return Sha256.toHex(hash.digest());
    }

    /**
     * Hashes the distinct corner tuples that faces use, finds the rank of each wedge and returns how many ranks there
     * are.
     */
    private static int hashTuples(Numbers sha, Mesh mesh, List<Channel> channels, int[] ranks) {
        int width = 3;
        for (Channel c : channels) width += c.components() + 1;
        boolean[] used = new boolean[mesh.wedges()];
        for (int w : mesh.faceWedges()) used[w] = true;
        int[] wedgeOf = new int[mesh.wedges()];
        int count = 0;
        for (int w = 0; w < used.length; w++) if (used[w]) wedgeOf[count++] = w;
        int[] rows = new int[width * count];
        for (int i = 0; i < count; i++) fillRow(rows, i * width, mesh, channels, wedgeOf[i]);
        int[] order = RowSorter.order(rows, width, count);
        int distinct = 0;
        for (int i = 0; i < count; i++) {
            if (i == 0 || !RowSorter.equal(rows, width, order[i - 1], order[i])) distinct++;
            ranks[wedgeOf[order[i]]] = distinct - 1;
        }
        sha.updateInt(distinct);
        for (int i = 0; i < count; i++) {
            if (i > 0 && RowSorter.equal(rows, width, order[i - 1], order[i])) continue;
            for (int k = 0; k < width; k++) sha.updateInt(rows[order[i] * width + k]);
        }
        return distinct;
    }

    private static void fillRow(int[] rows, int at, Mesh mesh, List<Channel> channels, int wedge) {
        int vertex = mesh.wedgeVertices()[wedge];
        for (int a = 0; a < 3; a++) rows[at++] = Float.floatToRawIntBits(mesh.positions()[3 * vertex + a]);
        for (Channel c : channels) {
            boolean absent = c.isAbsent(wedge);
            rows[at++] = absent ? 0 : 1;
            for (int k = 0; k < c.components(); k++) rows[at++] = absent ? 0 : c.values()[c.components() * wedge + k];
        }
    }

    /** Hashes the distinct materials that faces use, sorted by their text, and returns the rank of each. */
    private static int[] hashMaterials(Numbers sha, Mesh mesh) {
        boolean[] used = new boolean[mesh.materials().size()];
        for (int m : mesh.faceMaterials()) if (m >= 0) used[m] = true;
        List<String> texts = new ArrayList<>();
        for (int m = 0; m < used.length; m++) {
            String text = used[m] ? text(mesh.materials().get(m)) : "";
            if (used[m] && !texts.contains(text)) texts.add(text);
        }
        texts.sort(Comparator.naturalOrder());
        sha.updateInt(texts.size());
        for (String text : texts) {
            byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
            sha.updateInt(bytes.length);
            sha.update(bytes);
        }
        int[] ranks = new int[used.length];
        for (int m = 0; m < used.length; m++)
            ranks[m] = used[m] ? texts.indexOf(text(mesh.materials().get(m))) : -1;
        return ranks;
    }

    /**
     * A material as text: name, parameters with their bits in hexadecimal, texture references; fields end in a line
     * feed.
     */
    private static String text(Material m) {
        StringBuilder s = new StringBuilder(m.name()).append('\n');
        for (Material.Parameter p : m.parameters()) {
            s.append(p.key());
            for (float v : p.values()) s.append(' ').append(Integer.toHexString(Float.floatToRawIntBits(v)));
            s.append('\n');
        }
        s.append('\n');
        for (Material.TextureReference t : m.textures())
            s.append(t.key()).append(' ').append(t.path()).append('\n');
        return s.toString();
    }

    /** Faces lie in buckets of their smallest rank, a few in each. */
    private static void hashFaces(Numbers sha, Mesh mesh, int[] ranks, int[] materialRanks, int distinct) {
        int faces = mesh.faces();
        int[] wedges = mesh.faceWedges();
        Buckets buckets = new Buckets(distinct);
        for (int i = 0; i < wedges.length; i += 3) buckets.count(smallest(ranks, wedges, i));
        buckets.lay();
        for (int f = 0; f < faces; f++) buckets.add(smallest(ranks, wedges, 3 * f), f);
        int[] rows = new int[4 * 16];
        int[] order = new int[16];
        for (int rank = 0; rank < distinct; rank++) {
            int start = buckets.start(rank);
            int count = buckets.end(rank) - start;
            if (count > order.length) {
                order = new int[2 * count];
                rows = new int[4 * order.length];
            }
            for (int i = 0; i < count; i++)
                fillFace(rows, 4 * i, mesh, buckets.items()[start + i], ranks, materialRanks);
            RowSorter.order(rows, 4, count, order);
            for (int i = 0; i < count; i++) for (int k = 0; k < 4; k++) sha.updateInt(rows[4 * order[i] + k]);
        }
    }

    private static int smallest(int[] ranks, int[] wedges, int i) {
        return Math.min(ranks[wedges[i]], Math.min(ranks[wedges[i + 1]], ranks[wedges[i + 2]]));
    }

    private static void fillFace(int[] rows, int at, Mesh mesh, int face, int[] ranks, int[] materialRanks) {
        int a = ranks[mesh.faceWedges()[3 * face]];
        int b = ranks[mesh.faceWedges()[3 * face + 1]];
        int c = ranks[mesh.faceWedges()[3 * face + 2]];
        while (b < a
                || c < a
                || c == a
                        && b != a) { // smallest first; if there are two smallest, the one that is followed by the other
            int t = a;
            a = b;
            b = c;
            c = t;
        }
        rows[at] = a;
        rows[at + 1] = b;
        rows[at + 2] = c;
        int m = mesh.faceMaterials()[face];
        rows[at + 3] = m < 0 ? -1 : materialRanks[m];
    }
}
