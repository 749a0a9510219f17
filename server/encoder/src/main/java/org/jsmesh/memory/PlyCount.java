package org.jsmesh.memory;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Set;

/** Counts by the header of a PLY file. */
final class PlyCount {
    private static final Set<String> PLACE = Set.of("x", "y", "z");
    private static final int LEAST_FACE_BYTES = 4; // in text: "3 1 2 3" and a line's end would be 8

    private PlyCount() {}

    static ModelCount of(Sampled file) throws IOException {
        String header = new String(file.start(), StandardCharsets.ISO_8859_1);
        long vertices = 0;
        long faces = 0;
        long strips = 0;
        int vertexValues = 0;
        int faceValues = 0;
        String element = "";
        for (String line : header.split("\r\n|\r|\n")) {
            String[] words = line.strip().split("\\s+");
            if (words[0].equals("end_header")) break;
            if (words[0].equals("element") && words.length > 2) {
                element = words[1];
                long count = number(words[2]);
                switch (element) {
                    case "vertex" -> vertices = count;
                    case "face" -> faces = count;
                    case "tristrips" -> strips = count;
                    default -> {}
                }
            } else if (words[0].equals("property") && words.length > 2) {
                String name = words[words.length - 1];
                boolean list = words[1].equals("list");
                if (element.equals("vertex") && !list && !PLACE.contains(name)) vertexValues++;
                if (element.equals("face") && (name.equals("texcoord") || !list)) faceValues += list ? 2 : 1;
            }
        }
        long most = file.length() / LEAST_FACE_BYTES; // whatever a header claims
        double triangles = Math.min(faces, most) * sides(file, header, faces, vertices);
        if (strips > 0) triangles += 2.0 * Math.min(vertices, most);
        // A header that claims more than there is belongs to a file that is cut; reading it will tell.
        boolean isWhole = (double) vertices * 3 + (double) faces * LEAST_FACE_BYTES <= file.length();
        return new ModelCount(
                triangles,
                isWhole ? faces : 0,
                Math.min(vertices, most),
                vertexValues + faceValues,
                file.length(),
                0,
                vertexValues == 0,
                false);
    }

    private static long number(String word) {
        try {
            return Math.max(0, Long.parseLong(word));
        } catch (NumberFormatException e) {
            return 0;
        }
    }

    /** Triangles for each face: 1, unless there are so many bytes left that faces have more corners. */
    private static double sides(Sampled file, String header, long faces, long vertices) {
        if (faces == 0) return 1;
        int row = 0;
        int faceRow = 0;
        int index = 4;
        int count = 1;
        String element = "";
        for (String line : header.split("\r\n|\r|\n")) {
            String[] words = line.strip().split("\\s+");
            if (words[0].equals("end_header")) break;
            if (words[0].equals("format") && words.length > 1 && words[1].equals("ascii")) return 1;
            if (words[0].equals("element") && words.length > 1) element = words[1];
            if (!words[0].equals("property") || words.length < 3) continue;
            boolean list = words[1].equals("list");
            if (element.equals("vertex") && !list) row += bytes(words[1]);
            if (element.equals("face") && !list) faceRow += bytes(words[1]);
            if (element.equals("face") && list && words.length > 4 && words[4].startsWith("vertex_ind")) {
                count = bytes(words[2]);
                index = bytes(words[3]);
            }
        }
        int end = header.indexOf("end_header");
        double left = file.length() - (end < 0 ? 0 : end + 11) - (double) row * vertices;
        double corners = (left / faces - faceRow - count) / index;
        return Math.max(1, Math.min(4, corners - 2));
    }

    private static int bytes(String type) {
        return switch (type) {
            case "char", "uchar", "int8", "uint8" -> 1;
            case "short", "ushort", "int16", "uint16" -> 2;
            case "double", "float64" -> 8;
            default -> 4;
        };
    }
}
