package org.jsmesh.files.gltf.packed;

/**
 * Mode TRIANGLES (KHR_meshopt_compression, appendix A, mode 1): a code byte per triangle, which says what it shares
 * with the edges and vertices of those before, then what the codes need beside, then a table of frequent codes.
 */
final class TriangleStream {
    private static final int HEADER = 0xE1;
    private static final int TABLE_BYTES = 16;
    /** Of a half byte: nothing is shared, the index itself is stored. */
    private static final int STORED = 15;

    private final PackedBytes data;
    private final IndexOutput indices;
    private final RecentValues edgeStarts = new RecentValues();
    private final RecentValues edgeEnds = new RecentValues();
    private final RecentValues vertices = new RecentValues();
    /** The lowest index that was not used yet. */
    private int next;
    /** The index that was stored last. */
    private int last;

    private TriangleStream(PackedBytes data, IndexOutput indices) {
        this.data = data;
        this.indices = indices;
    }

    static byte[] decode(PackedBytes in, int count, int stride) throws PackedException {
        if (count % 3 != 0) throw new PackedException(count + " indices are not whole triangles");
        in.requireHeader(HEADER);
        int table = in.takeTail(TABLE_BYTES);
        requireTable(in.bytes, table);
        int triangles = count / 3;
        if (triangles > in.remaining()) {
            throw new PackedException("the packed data is too short for " + triangles + " triangles");
        }
        int codes = in.take(triangles);
        IndexOutput indices = new IndexOutput(count, stride);
        TriangleStream stream = new TriangleStream(in, indices);
        for (int i = 0; i < triangles; i++) {
            int code = in.bytes[codes + i] & 0xFF;
            int low = code & 15;
            if (code >> 4 < 15) stream.besideEdge(code >> 4, low);
            else if (low < 14) stream.apart(false, in.bytes[table + low] & 0xFF);
            else stream.explicit(low == STORED);
        }
        in.requireEnd();
        return indices.values();
    }

    private static void requireTable(byte[] bytes, int table) throws PackedException {
        boolean right = bytes[table + 14] == 0 && bytes[table + 15] == 0;
        for (int i = table; i < table + TABLE_BYTES; i++) right &= (bytes[i] >> 4 & 15) != 15 && (bytes[i] & 15) != 15;
        if (!right) throw new PackedException("the table of triangle codes is damaged");
    }

    /** A triangle on a recent edge. */
    private void besideEdge(int age, int third) throws PackedException {
        int a = edgeStarts.get(age);
        int b = edgeEnds.get(age);
        int c;
        switch (third) {
            case 0 -> c = next++;
            case 13 -> c = --last;
            case 14 -> c = ++last;
            case STORED -> c = stored();
            default -> c = vertices.get(third);
        }
        if (third == 0 || third > 12) vertices.add(c);
        addEdge(c, b);
        addEdge(a, c);
        put(a, b, c);
    }

    private void explicit(boolean storedFirst) throws PackedException {
        int rest = data.next();
        if (rest == 0) next = 0;
        apart(storedFirst, rest);
    }

    /** A triangle on no recent edge; the halves of {@code rest} say where its second and third vertex come from. */
    private void apart(boolean storedFirst, int rest) throws PackedException {
        int second = rest >> 4;
        int third = rest & 15;
        int a = storedFirst ? stored() : next++;
        int b = vertex(second);
        int c = vertex(third);
        vertices.add(a);
        if (second == 0 || second == STORED) vertices.add(b);
        if (third == 0 || third == STORED) vertices.add(c);
        addEdge(b, a);
        addEdge(c, b);
        addEdge(a, c);
        put(a, b, c);
    }

    private int vertex(int code) throws PackedException {
        if (code == 0) return next++;
        return code == STORED ? stored() : vertices.get(code - 1);
    }

    private int stored() throws PackedException {
        int packed = data.varint();
        last += packed >>> 1 ^ -(packed & 1);
        return last;
    }

    private void addEdge(int from, int to) {
        edgeStarts.add(from);
        edgeEnds.add(to);
    }

    private void put(int a, int b, int c) {
        indices.put(a);
        indices.put(b);
        indices.put(c);
    }
}
