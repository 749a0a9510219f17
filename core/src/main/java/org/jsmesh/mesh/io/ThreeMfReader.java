package org.jsmesh.mesh.io;

import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.Sizes;
import org.jsmesh.mesh.io.threemf.ThreeMfException;
import org.jsmesh.mesh.io.threemf.ThreeMfMesh;
import org.jsmesh.mesh.io.threemf.ThreeMfPackage;
import org.jsmesh.mesh.io.zip.PackedException;
import org.jsmesh.mesh.io.zip.Unpacker;
import org.jsmesh.mesh.io.zip.ZipArchive;

/**
 * Reads 3MF: the objects of its build items, base materials, colours and textures of triangles, and the names of
 * objects by face. Vertices with colours or texture coordinates have them by corner, so nothing is welded.
 */
final class ThreeMfReader {
    private static final int OPAQUE = 0xFF;

    private final String file;
    private final byte[] content;
    private final List<Note> notes;

    ThreeMfReader(String file, byte[] content, List<Note> notes) {
        this.file = file;
        this.content = content;
        this.notes = notes;
    }

    static boolean isThreeMf(byte[] content) {
        if (!ZipArchive.isZip(content)) return false;
        try {
            return ThreeMfPackage.isThreeMf(new ZipArchive(content, new Unpacker(0)));
        } catch (PackedException e) {
            return false;
        }
    }

    Mesh read() throws ModelFormatException {
        ThreeMfMesh read;
        try {
            read = ThreeMfPackage.read(new ZipArchive(content, new Unpacker(Unpacker.MOST_BYTES)), notes);
        } catch (ThreeMfException e) {
            throw new ModelFormatException(file, e.place(), e.reason(), e.remedy());
        } catch (PackedException e) {
            throw new ModelFormatException(file, "", e.reason(), e.remedy());
        }
        int[] vertices = read.corners();
        int[] corners = new int[vertices.length];
        for (int i = 0; i < corners.length; i++) corners[i] = i;
        MeshAssembler assembler = read.isFloat()
                ? new MeshAssembler(floats(read.positions()), vertices, corners)
                : new MeshAssembler(read.positions(), vertices, corners);
        assembler.materials(read.faceMaterials(), read.materials(), read.textures());
        if (read.uv().length > 0)
            assembler.attribute(new CornerAttribute(
                    Channel.Semantic.TEXCOORD,
                    "uv",
                    2,
                    Channel.Type.FLOAT32,
                    MeshAssembler.bits(read.uv()),
                    read.cornerUv()));
        if (read.argb().length > 0) assembler.attribute(colours(read.argb(), read.cornerColours()));
        if (read.names().size() > 1)
            assembler.faceChannel(
                    new FaceChannel(FaceChannel.OBJECT, 1, Channel.Type.INT32, read.faceNames(), read.names()));
        return assembler.build();
    }

    private static float[] floats(double[] values) {
        float[] floats = new float[values.length];
        for (int i = 0; i < floats.length; i++) floats[i] = (float) values[i];
        return floats;
    }

    private static CornerAttribute colours(int[] argb, int[] rows) {
        int components = 3;
        for (int colour : argb) if (colour >>> 24 != OPAQUE) components = 4;
        int[] values = new int[Sizes.of(components, argb.length, "colours")];
        for (int i = 0; i < argb.length; i++) {
            for (int c = 0; c < components; c++)
                values[i * components + c] = argb[i] >> (c == 3 ? 24 : 16 - 8 * c) & OPAQUE;
        }
        return new CornerAttribute(Channel.Semantic.COLOUR, "colour", components, Channel.Type.UINT8, values, rows);
    }
}
