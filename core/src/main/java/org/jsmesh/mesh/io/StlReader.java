package org.jsmesh.mesh.io;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Note;

/**
 * Reads STL, ASCII and binary (3D Systems, StereoLithography Interface Specification, 1988). Vertices are welded by
 * exact bits. Facet normals follow from the vertices and are not kept. Attribute bytes that are colours become
 * materials, see {@link StlColours}; others become an attribute of faces.
 */
final class StlReader {
    static final int HEADER_BYTES = 80;

    /** Name of the attribute of faces that their attribute bytes are, when they are no colours. */
    static final String ATTRIBUTE = "attribute";

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
        int facets = count();
        ByteBuffer data = ByteBuffer.wrap(content).order(ByteOrder.LITTLE_ENDIAN);
        float[] positions = new float[9 * facets];
        int[] words = new int[facets];
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
            words[facet] = data.getShort(at + 48) & 0xFFFF;
        }
        long behind = content.length - COUNT_END - FACET_BYTES * (long) facets;
        if (behind > 0) {
            String text = Notes.count(behind, "byte") + " behind the last facet skipped.";
            notes.add(Note.unread(text, (int) behind, "byte " + (content.length - behind)));
        }
        return mesh(positions, words);
    }

    /** How many facets to read: where the header's count is wrong, as many as the file has room for. */
    private int count() throws ModelFormatException {
        long counted = facets(content);
        int room = (content.length - COUNT_END) / FACET_BYTES;
        boolean whole = COUNT_END + room * FACET_BYTES == content.length;
        if (counted > room && (!whole || room == 0)) {
            throw new ModelFormatException(
                    file,
                    "byte " + HEADER_BYTES,
                    counted + " facets need " + (COUNT_END + FACET_BYTES * counted) + " bytes but there are "
                            + content.length,
                    "The file is cut off; get it again");
        }
        boolean more = counted < room && (whole || counted == 0) && areNumbers((int) counted, room);
        if (counted <= room && !more) return (int) counted;
        String text = "The header counts " + Notes.count(counted, "facet") + ", but the file holds " + room + ": "
                + (more ? "all are read." : "the count is wrong, or the file is cut off.");
        int difference = (int) Math.min(Integer.MAX_VALUE, Math.abs(counted - room));
        Note.Kind kind = more ? Note.Kind.REPAIRED : Note.Kind.DROPPED;
        notes.add(new Note(kind, text, difference, "byte " + HEADER_BYTES));
        return room;
    }

    /** Whether what is behind the counted facets can be facets, too; zeros alone are padding. */
    private boolean areNumbers(int from, int to) {
        ByteBuffer data = ByteBuffer.wrap(content).order(ByteOrder.LITTLE_ENDIAN);
        boolean any = false;
        for (int facet = from; facet < to; facet++) {
            for (int i = 0; i < 12; i++) {
                float value = data.getFloat(COUNT_END + FACET_BYTES * facet + 4 * i);
                if (!Float.isFinite(value) && i >= 3) return false;
                any |= value != 0;
            }
        }
        return any;
    }

    private Mesh mesh(float[] positions, int[] words) {
        int[] corners = new int[positions.length / 3];
        for (int i = 0; i < corners.length; i++) corners[i] = i;
        MeshAssembler assembler = new MeshAssembler(positions, corners, corners).weld(true);
        StlColours colours = new StlColours(content, words, notes);
        if (colours.any()) colour(assembler, colours, words.length);
        if (colours.areOther())
            assembler.faceChannel(new FaceChannel(ATTRIBUTE, 1, Channel.Type.UINT16, words, List.of()));
        return assembler.build();
    }

    private void colour(MeshAssembler assembler, StlColours colours, int facets) {
        FaceColours faceColours = new FaceColours(notes);
        PolygonList polygons = new PolygonList();
        polygons.expect(facets);
        int[] ids = new int[facets];
        for (int facet = 0; facet < facets; facet++) {
            for (int i = 0; i < 3; i++) polygons.corner(3 * facet + i);
            ids[facet] = colours.add(facet, faceColours);
            polygons.end(ids[facet]);
        }
        faceColours.assign(assembler, polygons, ids, "colour");
    }

    Mesh readText() throws ModelFormatException {
        TextScanner scanner = new TextScanner(file, content, 0, false, false);
        Coordinates positions = new Coordinates(1 << 12);
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
                        scanner.coordinateOnLine("xyz".charAt(i) + " of vertex " + vertex, positions);
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
        int[] corners = polygons.triangulate(positions.offsets(), notes).corners();
        return positions.assembler(polygons.vertices(), corners).weld(true).build();
    }
}
