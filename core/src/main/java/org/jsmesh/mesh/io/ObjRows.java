package org.jsmesh.mesh.io;

import org.jsmesh.mesh.Channel;

/** The {@code vt} or {@code vn} lines of an OBJ file. Numbers that a line leaves out are 0. */
final class ObjRows {
    private static final int WIDTH = 3;

    private final String keyword;
    private final String number; // name of one in messages
    private final int least;
    private final int most;
    private final IntList values = new IntList();
    private boolean third;

    ObjRows(String keyword, int least, int most) {
        this.keyword = keyword;
        number = "a number of " + keyword;
        this.least = least;
        this.most = most;
    }

    int size() {
        return values.size() / WIDTH;
    }

    void read(TextScanner scanner) throws ModelFormatException {
        int count = 0;
        while (count < most && scanner.nextOnLine()) {
            int bits = Float.floatToRawIntBits(scanner.tokenAsFloat(number));
            values.add(bits);
            count++;
            if (count == WIDTH && bits != 0) third = true;
        }
        if (count < least) throw scanner.error(keyword + " has " + count + " numbers of " + least, "Complete the line");
        while (count++ < WIDTH) values.add(0);
    }

    /** Texture coordinates have two components unless a third one is not 0; null when there are no rows. */
    CornerAttribute attribute(Channel.Semantic semantic, String name, int[] cornerRows) {
        if (size() == 0) return null;
        int components = least == WIDTH || third ? WIDTH : 2;
        int[] rows = new int[size() * components];
        for (int i = 0; i < rows.length; i++) rows[i] = values.get(i / components * WIDTH + i % components);
        return new CornerAttribute(semantic, name, components, Channel.Type.FLOAT32, rows, cornerRows);
    }
}
