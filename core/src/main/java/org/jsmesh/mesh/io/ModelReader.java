package org.jsmesh.mesh.io;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.TooLargeException;
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
        return read(fileName, ByteSource.of(content), resources);
    }

    /**
     * Reads a model file that need not be in memory: of PLY, OBJ and STL only a small part is at a time, and they may
     * have any size; files of other formats are read into memory. The mesh is the same.
     *
     * @param fileName for messages, and as a hint where the content leaves the format open
     * @param content the whole file; PLY, OBJ and STL are read to their end once, or again where a header leaves it
     *     open, and their first bytes some more times
     * @param resources finds material libraries and images
     * @return the mesh, its format, and what was changed or skipped
     * @throws ModelFormatException when the content is no model or a damaged one, or more than fits into memory
     * @throws IOException when the content or a resource cannot be read
     */
    public static ModelFile read(String fileName, ByteSource content, ResourceResolver resources) throws IOException {
        ByteSource opened = OpenedSource.of(content);
        try {
            return readOpened(fileName, opened, resources);
        } catch (TooLargeException e) {
            throw new ModelFormatException(fileName, "", e.reason(), TooLargeException.REMEDY);
        } catch (UncheckedIOException e) {
            throw e.getCause();
        } finally {
            OpenedSource.close(opened);
        }
    }

    private static ModelFile readOpened(String fileName, ByteSource content, ResourceResolver resources)
            throws IOException {
        byte[] head = FormatSniffer.head(content);
        ModelFormat format = formatOf(fileName, head, content);
        List<Note> notes = new ArrayList<>();
        Mesh mesh = switch (format) {
            case PLY -> new PlyReader(fileName, content, resources, notes).read();
            case OBJ -> new ObjReader(fileName, content, resources, notes).read();
            case STL -> {
                StlReader reader = new StlReader(fileName, content, notes);
                yield FormatSniffer.isTextStl(head, content.length()) ? reader.readText() : reader.readBinary();
            }
            case OFF -> new OffReader(fileName, WholeFile.of(fileName, content), notes).read();
            case HOPPE_M -> new HoppeReader(fileName, WholeFile.of(fileName, content), notes).read();
            case THREE_MF -> new ThreeMfReader(fileName, WholeFile.of(fileName, content), notes).read();
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
        try {
            return formatOf(fileName, ByteSource.of(content));
        } catch (ModelFormatException e) {
            throw e;
        } catch (IOException e) {
            throw new IllegalStateException(e); // nothing else can be wrong with an array
        }
    }

    /**
     * Tells the format of a file by its content, of which it reads the first bytes, or all of a ZIP archive.
     *
     * @param fileName for messages, and as a hint where the content leaves the format open
     * @param content the whole file
     * @return the format; the one that the name promises where the content is not recognized
     * @throws ModelFormatException when it is unknown
     * @throws IOException when the content cannot be read
     */
    public static ModelFormat formatOf(String fileName, ByteSource content) throws IOException {
        ByteSource opened = OpenedSource.of(content);
        try {
            return formatOf(fileName, FormatSniffer.head(opened), opened);
        } catch (TooLargeException e) {
            throw unknown(fileName, "the content is of no known format", GIVE);
        } catch (UncheckedIOException e) {
            throw e.getCause();
        } finally {
            OpenedSource.close(opened);
        }
    }

    private static ModelFormat formatOf(String fileName, byte[] head, ByteSource content) throws IOException {
        String wide = FormatSniffer.wideText(head, content.length());
        if (wide != null)
            throw unknown(fileName, "the text is " + wide, "Save it as UTF-8 or ASCII in an editor, or export it anew");
        ModelFormat format = FormatSniffer.sniff(fileName, head, content);
        if (format != null) return format;
        if (head.length == 0) throw unknown(fileName, "the file is empty", GIVE);
        if (Unpacker.isGzip(head)) throw unknown(fileName, "the content is compressed with gzip", UNPACK);
        if (ZipArchive.isZip(head)) throw unknown(fileName, "the content is a ZIP archive", UNPACK);
        throw unknown(fileName, "the content is of no known format", GIVE);
    }

    private static ModelFormatException unknown(String fileName, String reason, String remedy) {
        return new ModelFormatException(fileName, "", reason, remedy);
    }
}
