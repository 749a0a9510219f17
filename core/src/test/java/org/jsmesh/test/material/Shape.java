package org.jsmesh.test.material;

import java.util.ArrayList;
import java.util.List;

/** Triangles with attributes, named as glTF names them. Not changed: what is added comes with a copy. */
record Shape(List<Attribute> attributes, int[] indices) {
    private static final int AROUND = 40;
    private static final int DOWN = 20;

    /**
     * Values of one kind.
     *
     * @param width numbers per vertex
     * @param isShort stored as normalized unsigned short numbers, else as floats
     */
    record Attribute(String name, int width, boolean isShort, float[] values) {}

    int vertices() {
        return attributes.get(0).values().length / 3;
    }

    Shape with(String name, int width, float... values) {
        return with(new Attribute(name, width, false, values));
    }

    Shape withShorts(String name, int width, float... values) {
        return with(new Attribute(name, width, true, values));
    }

    /** The same values at every vertex. */
    Shape everywhere(String name, float... values) {
        float[] all = new float[vertices() * values.length];
        for (int i = 0; i < all.length; i++) all[i] = values[i % values.length];
        return with(name, values.length, all);
    }

    private Shape with(Attribute attribute) {
        List<Attribute> more = new ArrayList<>(attributes);
        more.removeIf(a -> a.name().equals(attribute.name()));
        more.add(attribute);
        return new Shape(more, indices);
    }

    /** Texture coordinates times a factor, around the middle of the image. */
    Shape repeated(String name, float factor) {
        float[] values = values("TEXCOORD_0").clone();
        for (int i = 0; i < values.length; i++) values[i] = .5f + factor * (values[i] - .5f);
        return with(name, 2, values);
    }

    /** Seen from behind. */
    Shape turned() {
        int[] others = indices.clone();
        for (int i = 0; i < others.length; i += 3) {
            others[i + 1] = indices[i + 2];
            others[i + 2] = indices[i + 1];
        }
        float[] normals = values("NORMAL").clone();
        for (int i = 0; i < normals.length; i++) normals[i] = -normals[i];
        return new Shape(new ArrayList<>(attributes), others).with("NORMAL", 3, normals);
    }

    float[] values(String name) {
        for (Attribute a : attributes) if (a.name().equals(name)) return a.values();
        throw new IllegalArgumentException("no " + name);
    }

    /** An upright rectangle that faces +z; the image covers it once. */
    static Shape rectangle(float left, float bottom, float right, float top, float z) {
        float[] positions = {left, bottom, z, right, bottom, z, right, top, z, left, top, z};
        return new Shape(List.of(), new int[] {0, 1, 2, 0, 2, 3})
                .with("POSITION", 3, positions)
                .everywhere("NORMAL", 0, 0, 1)
                .with("TEXCOORD_0", 2, 0, 1, 1, 1, 1, 0, 0, 0);
    }

    static Shape square() {
        return rectangle(-1, -1, 1, 1, 0);
    }

    /** A ball; the image goes around it once, with its top at the top. */
    static Shape sphere() {
        int columns = AROUND + 1;
        float[] positions = new float[3 * columns * (DOWN + 1)];
        float[] uvs = new float[positions.length / 3 * 2];
        int[] indices = new int[6 * AROUND * (DOWN - 1)];
        int at = 0;
        for (int i = 0; i < positions.length / 3; i++) {
            int row = i / columns;
            int column = i % columns;
            double down = Math.PI * row / DOWN;
            double around = 2 * Math.PI * (column % AROUND) / AROUND;
            double wide = row % DOWN == 0 ? 0 : Math.sin(down);
            positions[3 * i] = (float) (wide * Math.sin(around));
            positions[3 * i + 1] = (float) Math.cos(down);
            positions[3 * i + 2] = (float) (wide * Math.cos(around));
            uvs[2 * i] = (float) column / AROUND;
            uvs[2 * i + 1] = (float) row / DOWN;
            if (row == DOWN || column == AROUND) continue;
            if (row < DOWN - 1) at = triangle(indices, at, i, i + columns, i + columns + 1);
            if (row > 0) at = triangle(indices, at, i, i + columns + 1, i + 1);
        }
        return new Shape(List.of(), indices)
                .with("POSITION", 3, positions)
                .with("NORMAL", 3, positions)
                .with("TEXCOORD_0", 2, uvs);
    }

    private static int triangle(int[] indices, int at, int a, int b, int c) {
        indices[at] = a;
        indices[at + 1] = b;
        indices[at + 2] = c;
        return at + 3;
    }

    /** Tangents of a sphere that point down, a quarter turn away from those that its image gives. */
    Shape withTangentsDown() {
        float[] p = values("POSITION");
        float[] tangents = new float[p.length / 3 * 4];
        for (int i = 0; i < p.length / 3; i++) {
            double wide = Math.hypot(p[3 * i], p[3 * i + 2]);
            double x = wide < 1e-6 ? 1 : p[3 * i] / wide;
            double z = wide < 1e-6 ? 0 : p[3 * i + 2] / wide;
            tangents[4 * i] = (float) (p[3 * i + 1] * x);
            tangents[4 * i + 1] = (float) -wide;
            tangents[4 * i + 2] = (float) (p[3 * i + 1] * z);
            tangents[4 * i + 3] = 1;
        }
        return with("TANGENT", 4, tangents);
    }
}
