package org.jsmesh.mesh.io;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.io.zip.Unpacker;
import org.jsmesh.mesh.io.zip.ZipArchive;

/** Reads model files of every format but glTF, which the encoder module adds. */
public final class ModelReader {
    private static final String GIVE = "Give a PLY, OBJ, STL, OFF, Hoppe .m, GLB, glTF or 3MF file";
    private static final String UNPACK = "Unpack it first, or read it with the encoder module (ModelFiles)";

    private ModelReader() {}

    /**
     * Reads a model file. Its content tells its format. Polygons are cut into triangles. Unreferenced vertices stay.
     *
     * @param fileName for messages, and as a hint where the content leaves the format open
     * @param content the whole file
     * @param resources finds material libraries and images
     * @return the mesh, its format, and what was changed or skipped
     * @throws ModelFormatException when the content is no model or a damaged one
     * @throws IOException when a resource cannot be read
     */
    public static ModelFile read(String fileName, byte[] content, ResourceResolver resources) throws IOException {
        ModelFormat format = formatOf(fileName, content);
        List<Note> notes = new ArrayList<>();
        Mesh mesh = switch (format) {
            case PLY -> new PlyReader(fileName, content, resources, notes).read();
            case OBJ -> new ObjReader(fileName, content, resources, notes).read();
            case STL -> {
                StlReader reader = new StlReader(fileName, content, notes);
                yield FormatSniffer.isTextStl(content) ? reader.readText() : reader.readBinary();
            }
            case OFF -> new OffReader(fileName, content, notes).read();
            case HOPPE_M -> new HoppeReader(fileName, content, notes).read();
            case THREE_MF -> new ThreeMfReader(fileName, content, notes).read();
            case GLB ->
                throw new ModelFormatException(
                        fileName,
                        "",
                        "glTF is not read here",
                        "Read it with the encoder module (ModelFiles), or convert it to PLY or OBJ");
        };
        return new ModelFile(mesh, format, notes);
    }

    /**
     * Tells the format of a file by its content.
     *
     * @param fileName for messages, and as a hint where the content leaves the format open
     * @param content the whole file
     * @return the format; the one that the name promises where the content is not recognized
     * @throws ModelFormatException when it is unknown
     */
    public static ModelFormat formatOf(String fileName, byte[] content) throws ModelFormatException {
        String wide = FormatSniffer.wideText(content);
        if (wide != null)
            throw unknown(fileName, "the text is " + wide, "Save it as UTF-8 or ASCII in an editor, or export it anew");
        ModelFormat format = FormatSniffer.sniff(fileName, content);
        if (format != null) return format;
        if (content.length == 0) throw unknown(fileName, "the file is empty", GIVE);
        if (Unpacker.isGzip(content)) throw unknown(fileName, "the content is compressed with gzip", UNPACK);
        if (ZipArchive.isZip(content)) throw unknown(fileName, "the content is a ZIP archive", UNPACK);
        throw unknown(fileName, "the content is of no known format", GIVE);
    }

    private static ModelFormatException unknown(String fileName, String reason, String remedy) {
        return new ModelFormatException(fileName, "", reason, remedy);
    }
}
