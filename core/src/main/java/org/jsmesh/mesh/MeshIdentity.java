package org.jsmesh.mesh;

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

    /** In front of the hash of a mesh in double precision, where others have the number of faces. */
    private static final int DOUBLE = -64;

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
        HashedNumbers sha = new HashedNumbers(hash);
        boolean wide = isDouble(mesh);
        if (wide) sha.updateInt(DOUBLE);
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
        int distinct = hashTuples(sha, mesh, wide, channels, ranks);
        int[] materialRanks = hashMaterials(sha, mesh);
        FaceRows faces = new FaceRows(mesh, ranks, materialRanks);
        faces.describe(sha);
        hashFaces(sha, mesh, ranks, faces, distinct);
        sha.flush();
        return Sha256.toHex(hash.digest());
    }

    /** Is there a coordinate of a face that float32 does not hold? */
    private static boolean isDouble(Mesh mesh) {
        if (!mesh.isDouble()) return false;
        for (int wedge : mesh.faceWedges()) {
            int vertex = mesh.wedgeVertices()[wedge];
            for (int a = 0; a < 3; a++) if (!DoublePositions.isFloat(mesh.coordinate(vertex, a))) return true;
        }
        return false;
    }

    /**
     * Hashes the distinct corner tuples that faces use, finds the rank of each wedge and returns how many ranks there
     * are.
     */
    private static int hashTuples(HashedNumbers sha, Mesh mesh, boolean wide, List<Channel> channels, int[] ranks) {
        int width = PositionBits.words(wide);
        for (Channel c : channels) width += c.words() + 1;
        boolean[] used = new boolean[mesh.wedges()];
        for (int w : mesh.faceWedges()) used[w] = true;
        int[] wedgeOf = new int[mesh.wedges()];
        int count = 0;
        for (int w = 0; w < used.length; w++) if (used[w]) wedgeOf[count++] = w;
        int[] rows = new int[Sizes.of(width, count, "different corners of " + width + " numbers")];
        for (int i = 0; i < count; i++) fillRow(rows, i * width, mesh, wide, channels, wedgeOf[i]);
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

    private static void fillRow(int[] rows, int at, Mesh mesh, boolean wide, List<Channel> channels, int wedge) {
        at = PositionBits.put(rows, at, mesh, mesh.wedgeVertices()[wedge], wide);
        for (Channel c : channels) {
            boolean absent = c.isAbsent(wedge);
            rows[at++] = absent ? 0 : 1;
            for (int k = 0; k < c.words(); k++) rows[at++] = absent ? 0 : c.values()[c.words() * wedge + k];
        }
    }

    /** Hashes the distinct materials that faces use, sorted by their text, and returns the rank of each. */
    private static int[] hashMaterials(HashedNumbers sha, Mesh mesh) {
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
            byte[] bytes = Utf8.bytes(text);
            sha.updateInt(bytes.length);
            sha.update(bytes);
        }
        int[] ranks = new int[used.length];
        for (int m = 0; m < used.length; m++)
            ranks[m] = used[m] ? texts.indexOf(text(mesh.materials().get(m))) : -1;
        return ranks;
    }

    /**
     * A material as text: name, parameters with their bits in hexadecimal, texture references, definition of glTF;
     * fields end in a line feed.
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
        if (m.isGltf()) s.append(m.gltf()).append('\n');
        return s.toString();
    }

    /** Faces lie in buckets of their smallest rank, a few in each. */
    private static void hashFaces(HashedNumbers sha, Mesh mesh, int[] ranks, FaceRows faces, int distinct) {
        int[] wedges = mesh.faceWedges();
        Buckets buckets = new Buckets(distinct);
        for (int i = 0; i < wedges.length; i += 3) buckets.count(smallest(ranks, wedges, i));
        buckets.lay();
        for (int f = 0; f < mesh.faces(); f++) buckets.add(smallest(ranks, wedges, 3 * f), f);
        int width = faces.width();
        int[] rows = new int[width * 16];
        int[] order = new int[16];
        for (int rank = 0; rank < distinct; rank++) {
            int start = buckets.start(rank);
            int count = buckets.end(rank) - start;
            if (count > order.length) {
                int room = Math.max(count, Math.min(2 * count, Sizes.MOST / width));
                rows = new int[Sizes.of(width, room, "faces about a corner")];
                order = new int[room];
            }
            for (int i = 0; i < count; i++) faces.fill(rows, width * i, buckets.items()[start + i]);
            RowSorter.order(rows, width, count, order);
            for (int i = 0; i < count; i++) for (int k = 0; k < width; k++) sha.updateInt(rows[width * order[i] + k]);
        }
    }

    private static int smallest(int[] ranks, int[] wedges, int i) {
        return Math.min(ranks[wedges[i]], Math.min(ranks[wedges[i + 1]], ranks[wedges[i + 2]]));
    }
}
