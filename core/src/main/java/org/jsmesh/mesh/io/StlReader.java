package org.jsmesh.mesh.io;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Note;

/**
 * Reads STL, ASCII and binary (3D Systems, StereoLithography Interface Specification, 1988). Vertices are welded by
 * exact bits. Facet normals follow from the vertices and are not kept.
 */
final class StlReader {
    static final int HEADER_BYTES = 80;
    static final int FACET_BYTES = 50;
    private static final int COUNT_END = HEADER_BYTES + 4;

    private final String file;
    private final byte[] content;
    private final List<Note> notes;

    StlReader(String file, byte[] content, List<Note> notes) {
        this.file = file;
        this.content = content;
        this.notes = notes;
    }

    /**
     * Whether the length of the file agrees with a binary file's count of facets. The word "solid" in front proves
     * nothing.
     */
    static boolean hasBinaryLength(byte[] content) {
        return content.length >= COUNT_END && COUNT_END + (long) FACET_BYTES * facets(content) == content.length;
    }

    private static long facets(byte[] content) {
        return ByteBuffer.wrap(content).order(ByteOrder.LITTLE_ENDIAN).getInt(HEADER_BYTES) & 0xFFFFFFFFL;
    }

    Mesh readBinary() throws ModelFormatException {
        if (content.length < COUNT_END)
            throw new ModelFormatException(
                    file, "", "only " + content.length + " bytes", "The file is cut off; get it again");
        long facets = facets(content);
        if (COUNT_END + FACET_BYTES * facets > content.length) {
            throw new ModelFormatException(
                    file,
                    "byte " + HEADER_BYTES,
                    facets + " facets need " + (COUNT_END + FACET_BYTES * facets) + " bytes but there are "
                            + content.length,
                    "The file is cut off; get it again");
        }
        ByteBuffer data = ByteBuffer.wrap(content).order(ByteOrder.LITTLE_ENDIAN);
        float[] positions = new float[(int) (9 * facets)];
        int attributes = 0;
        int firstAttribute = 0;
        for (int facet = 0; facet < facets; facet++) {
            int at = COUNT_END + FACET_BYTES * facet;
            for (int i = 0; i < 9; i++) {
                int offset = at + 12 + 4 * i;
                float value = data.getFloat(offset);
                if (Float.isNaN(value) || Float.isInfinite(value)) {
                    throw new ModelFormatException(
                            file,
                            "byte " + offset,
                            "xyz".charAt(i % 3) + " of vertex " + (i / 3 + 1) + " of facet " + facet + " is " + value
                                    + ", not a finite number",
                            "Repair or remove this facet");
                }
                positions[9 * facet + i] = value;
            }
            if (data.getShort(at + 48) != 0 && attributes++ == 0) firstAttribute = facet;
        }
        if (attributes > 0) {
            String text = "Attribute bytes of " + Notes.count(attributes, "facet") + " not kept.";
            notes.add(Note.dropped(text, attributes, "face " + firstAttribute));
        }
        long behind = content.length - COUNT_END - FACET_BYTES * facets;
        if (behind > 0) {
            String text = Notes.count(behind, "byte") + " behind the last facet skipped.";
            notes.add(Note.unread(text, (int) behind, "byte " + (content.length - behind)));
        }
        return mesh(positions, null);
    }

    Mesh readText() throws ModelFormatException {
        TextScanner scanner = new TextScanner(file, content, 0, false, false);
        IntList positions = new IntList();
        PolygonList polygons = new PolygonList();
        boolean open = false;
        int solids = 0;
        String firstSolid = "";
        while (scanner.next()) {
            String word = scanner.lowerCaseToken();
            switch (word) {
                case "solid" -> {
                    String name = scanner.restOfLine();
                    if (solids++ == 0) firstSolid = Notes.shown(name);
                }
                case "endsolid", "facet" -> scanner.restOfLine();
                case "outer", "endfacet" -> scanner.restOfLine();
                case "vertex" -> {
                    open = true;
                    polygons.corner(positions.size() / 3);
                    int vertex = polygons.corners();
                    for (int i = 0; i < 3; i++)
                        positions.add(
                                Float.floatToRawIntBits(scanner.floatOnLine("xyz".charAt(i) + " of vertex " + vertex)));
                }
                case "endloop" -> {
                    if (open) polygons.end(-1);
                    open = false;
                }
                default -> throw scanner.error(scanner.quote() + " where a facet should be", "Correct the file");
            }
        }
        if (open) throw scanner.error("the file ends within a facet", "The file is cut off; get it again");
        if (solids > 1) notes.add(Note.dropped(solids + " solids read as one mesh.", solids, firstSolid));
        float[] xyz = positions.toFloats();
        return mesh(xyz, polygons.triangulate(xyz, notes).corners());
    }

    /** @param corners vertex of each corner, or null when every three vertices are a facet */
    private static Mesh mesh(float[] positions, int[] corners) {
        int[] vertices = new int[positions.length / 3];
        for (int i = 0; i < vertices.length; i++) vertices[i] = i;
        return new MeshAssembler(positions, vertices, corners == null ? vertices : corners)
                .weld(true)
                .build();
    }
}
