package org.jsmesh.samples;

import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;

/** Text of an OBJ file: each distinct position, texture coordinate and normal is written once, with few decimals. */
final class ObjText {
    private final Map<String, Integer> positions = new LinkedHashMap<>();
    private final Map<String, Integer> coordinates = new LinkedHashMap<>();
    private final Map<String, Integer> normals = new LinkedHashMap<>();
    private final StringBuilder head = new StringBuilder();
    private final StringBuilder faces = new StringBuilder();

    ObjText(String comment, String materialFile) {
        head.append("# ")
                .append(comment)
                .append('\n')
                .append("mtllib ")
                .append(materialFile)
                .append('\n');
    }

    /** What follows belongs to this object and has this material. */
    void object(String name, String material) {
        faces.append("o ").append(name).append("\nusemtl ").append(material).append('\n');
    }

    int position(double... p) {
        return id(positions, p, 4);
    }

    int coordinate(double... uv) {
        return id(coordinates, uv, 4);
    }

    int normal(double... n) {
        return id(normals, n, 3);
    }

    /** A triangle of positions, with a coordinate or a normal per corner where these are not null. */
    void triangle(int[] p, int[] uv, int[] n) {
        faces.append('f');
        for (int i = 0; i < 3; i++) {
            faces.append(' ').append(p[i]);
            if (uv != null) faces.append('/').append(uv[i]);
            if (n != null) faces.append(uv == null ? "//" : "/").append(n[i]);
        }
        faces.append('\n');
    }

    byte[] toBytes() {
        StringBuilder text = new StringBuilder(head);
        positions.keySet().forEach(p -> text.append("v ").append(p).append('\n'));
        coordinates.keySet().forEach(uv -> text.append("vt ").append(uv).append('\n'));
        normals.keySet().forEach(n -> text.append("vn ").append(n).append('\n'));
        return text.append(faces).toString().getBytes(StandardCharsets.US_ASCII);
    }

    private static int id(Map<String, Integer> known, double[] values, int decimals) {
        StringBuilder line = new StringBuilder();
        for (double value : values) {
            if (!line.isEmpty()) line.append(' ');
            decimal(line, value, decimals);
        }
        return known.computeIfAbsent(line.toString(), l -> known.size() + 1);
    }

    /** The shortest text of the value rounded to so many decimals. */
    private static void decimal(StringBuilder out, double value, int decimals) {
        long scale = 1;
        for (int i = 0; i < decimals; i++) scale *= 10;
        long rounded = (long) StrictMath.rint(value * scale);
        if (rounded < 0) out.append('-');
        rounded = StrictMath.abs(rounded);
        out.append(rounded / scale);
        long rest = rounded % scale;
        if (rest == 0) return;
        out.append('.');
        for (scale /= 10; rest > 0; scale /= 10) {
            out.append(rest / scale);
            rest %= scale;
        }
    }
}
