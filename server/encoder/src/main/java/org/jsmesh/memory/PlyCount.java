package org.jsmesh.memory;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Set;

/** Counts by the header of a PLY file. */
final class PlyCount {
    private static final Set<String> PLACE = Set.of("x", "y", "z");
    private static final Set<String> COLOUR = Set.of("red", "diffuse_red", "r");
    private static final int VALUE_TEXT = 3; // bytes: colours are numbers to 255
    private static final int LEAST_FACE_BYTES = 4; // in text: "3 1 2 3" and a line's end would be 8

    private final Sampled file;
    private boolean isText;
    private long vertices;
    private long faces;
    private long strips;
    private int vertexValues;
    private int faceValues;
    private int vertexBytes; // of a vertex in binary
    private int faceBytes; // of a face in binary, but its corners
    private int sizeBytes = 1; // of the number of corners
    private int cornerBytes = 4;
    private int faceLead; // values in front of its corners
    private boolean hasCorners;
    private boolean hasColours; // of faces
    private boolean hasCoordinates; // of corners

    private PlyCount(Sampled file) {
        this.file = file;
    }

    static ModelCount of(Sampled file) throws IOException {
        String header = new String(file.start(), StandardCharsets.ISO_8859_1);
        PlyCount count = new PlyCount(file);
        count.read(header);
        int end = header.indexOf("end_header");
        return count.model(end < 0 ? 0 : end + 11);
    }

    private void read(String header) {
        String element = "";
        for (String line : header.split("\r\n|\r|\n")) {
            String[] words = line.strip().split("\\s+");
            if (words[0].equals("end_header")) return;
            if (words.length < 2) continue;
            switch (words[0]) {
                case "format" -> isText = words[1].equals("ascii");
                case "element" -> {
                    element = words[1];
                    if (words.length > 2) element(element, number(words[2]));
                }
                case "property" -> {
                    if (words.length > 2) property(element, words);
                }
                default -> {}
            }
        }
    }

    private void element(String name, long count) {
        switch (name) {
            case "vertex" -> vertices = count;
            case "face" -> faces = count;
            case "tristrips" -> strips = count;
            default -> {}
        }
    }

    private void property(String element, String[] words) {
        String name = words[words.length - 1];
        boolean isList = words[1].equals("list");
        if (element.equals("vertex") && !isList) {
            vertexBytes += bytes(words[1]);
            if (!PLACE.contains(name)) vertexValues++;
        } else if (element.equals("face") && !isList) {
            faceBytes += bytes(words[1]);
            faceValues++;
            if (!hasCorners) faceLead++;
            hasColours |= COLOUR.contains(name);
        } else if (element.equals("face") && words.length > 4 && name.equals("texcoord")) {
            faceValues += 2;
            faceBytes += bytes(words[2]);
            cornerBytes += 2 * bytes(words[3]);
            hasCoordinates = true;
        } else if (element.equals("face") && words.length > 4 && name.startsWith("vertex_ind")) {
            sizeBytes = bytes(words[2]);
            cornerBytes += bytes(words[3]) - 4;
            hasCorners = true;
        }
    }

    private ModelCount model(int headerBytes) throws IOException {
        long most = file.length() / LEAST_FACE_BYTES; // whatever a header claims
        double triangles = Math.min(faces, most) * sides(headerBytes);
        if (strips > 0) triangles += 2.0 * Math.min(vertices, most);
        // A header that claims more than there is belongs to a file that is cut; reading it will tell.
        boolean isWhole = (double) vertices * 3 + (double) faces * LEAST_FACE_BYTES <= file.length();
        return new ModelCount(
                triangles,
                isWhole ? faces : 0,
                Math.min(vertices, most),
                hasColours || hasCoordinates ? 3 * triangles : 0,
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
    private double sides(int headerBytes) throws IOException {
        if (faces == 0) return 1;
        if (isText) {
            FaceLines lines = FaceLines.of(file, faceLead);
            if (lines.any() || hasCoordinates) return lines.sides();
            return FaceLines.guess(file, headerBytes, vertices, faces, VALUE_TEXT * faceValues);
        }
        double left = file.length() - headerBytes - (double) vertexBytes * vertices;
        double corners = (left / faces - faceBytes - sizeBytes) / cornerBytes;
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
