package org.jsmesh.mesh.io;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.Sizes;

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
    private final ByteSource content;
    private final List<Note> notes;

    StlReader(String file, ByteSource content, List<Note> notes) {
        this.file = file;
        this.content = content;
        this.notes = notes;
    }

    /**
     * Whether the length of the file agrees with a binary file's count of facets. The word "solid" in front proves
     * nothing.
     *
     * @param head the first bytes of the file
     */
    static boolean hasBinaryLength(byte[] head, long length) {
        return head.length >= COUNT_END && COUNT_END + FACET_BYTES * facets(head) == length;
    }

    private static long facets(byte[] head) {
        return ByteBuffer.wrap(head).order(ByteOrder.LITTLE_ENDIAN).getInt(HEADER_BYTES) & 0xFFFFFFFFL;
    }

    Mesh readBinary() throws IOException {
        BinaryBytes data = BinaryBytes.of(content, 0, ByteOrder.LITTLE_ENDIAN);
        if (!data.has(COUNT_END))
            throw new ModelFormatException(
                    file, "", "only " + content.length() + " bytes", "The file is cut off; get it again");
        byte[] head = new byte[COUNT_END];
        data.data().get(head);
        int facets = count(head);
        TupleIndex positions = new TupleIndex(3); // the bits of x, y, z
        int[] vertices = new int[Sizes.of(3, facets, "facets")];
        int[] words = new int[facets];
        int[] bits = new int[9];
        for (int facet = 0; facet < facets; facet++) {
            if (!data.has(FACET_BYTES))
                throw new ModelFormatException(
                        file, "byte " + data.offset(), "the file ends within a facet", "Get it again");
            ByteBuffer row = data.data();
            int at = row.position();
            for (int i = 0; i < 9; i++) {
                bits[i] = row.getInt(at + 12 + 4 * i);
                float value = Float.intBitsToFloat(bits[i]);
                if (Float.isNaN(value) || Float.isInfinite(value)) {
                    throw new ModelFormatException(
                            file,
                            "byte " + (data.offset() + 12 + 4 * i),
                            "xyz".charAt(i % 3) + " of vertex " + (i / 3 + 1) + " of facet " + facet + " is " + value
                                    + ", not a finite number",
                            "Repair or remove this facet");
                }
            }
            for (int i = 0; i < 3; i++) vertices[3 * facet + i] = positions.intern(bits, 3 * i);
            words[facet] = row.getShort(at + 48) & 0xFFFF;
            row.position(at + FACET_BYTES);
        }
        long behind = data.remaining();
        if (behind > 0) {
            String text = Notes.count(behind, "byte") + " behind the last facet skipped.";
            int count = (int) Math.min(Integer.MAX_VALUE, behind);
            notes.add(Note.unread(text, count, "byte " + (content.length() - behind)));
            data.skip(behind);
        }
        return mesh(positions, vertices, words, head);
    }

    /** How many facets to read: where the header's count is wrong, as many as the file has room for. */
    private int count(byte[] head) throws IOException {
        long counted = facets(head);
        long room = (content.length() - COUNT_END) / FACET_BYTES;
        boolean whole = COUNT_END + room * FACET_BYTES == content.length();
        if (counted > room && (!whole || room == 0)) {
            throw new ModelFormatException(
                    file,
                    "byte " + HEADER_BYTES,
                    counted + " facets need " + (COUNT_END + FACET_BYTES * counted) + " bytes but there are "
                            + content.length(),
                    "The file is cut off; get it again");
        }
        boolean more = counted < room && (whole || counted == 0) && areNumbers(counted, room);
        if (counted <= room && !more) return Sizes.of(counted, "facets");
        String text = "The header counts " + Notes.count(counted, "facet") + ", but the file holds " + room + ": "
                + (more ? "all are read." : "the count is wrong, or the file is cut off.");
        int difference = (int) Math.min(Integer.MAX_VALUE, Math.abs(counted - room));
        Note.Kind kind = more ? Note.Kind.REPAIRED : Note.Kind.DROPPED;
        notes.add(new Note(kind, text, difference, "byte " + HEADER_BYTES));
        return Sizes.of(room, "facets");
    }

    /** Whether what is behind the counted facets can be facets, too; zeros alone are padding. */
    private boolean areNumbers(long from, long to) {
        BinaryBytes data = BinaryBytes.of(content, COUNT_END + FACET_BYTES * from, ByteOrder.LITTLE_ENDIAN);
        boolean any = false;
        for (long facet = from; facet < to && data.has(FACET_BYTES); facet++) {
            int at = data.data().position();
            for (int i = 0; i < 12; i++) {
                float value = data.data().getFloat(at + 4 * i);
                if (!Float.isFinite(value) && i >= 3) return false;
                any |= value != 0;
            }
            data.data().position(at + FACET_BYTES);
        }
        return any;
    }

    private Mesh mesh(TupleIndex distinct, int[] vertices, int[] words, byte[] head) {
        int[] corners = new int[vertices.length];
        for (int i = 0; i < corners.length; i++) corners[i] = i;
        float[] positions = new float[3 * distinct.size()];
        for (int i = 0; i < positions.length; i++) positions[i] = Float.intBitsToFloat(distinct.value(i / 3, i % 3));
        MeshAssembler assembler = new MeshAssembler(positions, vertices, corners);
        StlColours colours = new StlColours(head, words, notes);
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
        TextScanner scanner = new TextScanner(file, content, content.length(), false, false);
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
