package org.jsmesh.mesh.io;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.jsmesh.mesh.Note;

/**
 * The text in front of a PLY file (G. Turk, The PLY Polygon File Format, 1994): its encoding, and elements with their
 * properties in order.
 *
 * @param textures file names of {@code comment TextureFile} lines
 * @param dataOffset of the first byte behind the line {@code end_header}
 * @param dataLine line number there
 */
record PlyHeader(Encoding encoding, List<Element> elements, List<String> textures, long dataOffset, int dataLine) {
    enum Encoding {
        ASCII,
        LITTLE_ENDIAN,
        BIG_ENDIAN
    }

    /** @param countType of the length of a list, or null for a scalar */
    record Property(String name, PlyType type, PlyType countType) {
        boolean isList() {
            return countType != null;
        }
    }

    record Element(String name, int count, List<Property> properties) {
        /** Position of the first property of that name, or −1. */
        int indexOf(String property) {
            for (int i = 0; i < properties.size(); i++) {
                if (properties.get(i).name.equals(property)) return i;
            }
            return -1;
        }

        /** The bytes of a row, or −1 when there is a list in it. */
        long bytesOfScalars() {
            long bytes = 0;
            for (Property property : properties) {
                if (property.isList()) return -1;
                bytes += property.type.bytes();
            }
            return bytes;
        }
    }

    /** Or null. */
    Element element(String name) {
        for (Element e : elements) {
            if (e.name.equals(name)) return e;
        }
        return null;
    }

    /** @param scanner at the start of the content; it stays in the line {@code end_header} */
    static PlyHeader parse(TextScanner scanner, ByteSource content, List<Note> notes) throws IOException {
        if (!scanner.nextOnLine() || !scanner.tokenIs("ply"))
            throw scanner.error("no line \"ply\" in front", "Give a PLY file");
        Encoding encoding = null;
        List<Element> elements = new ArrayList<>();
        List<String> textures = new ArrayList<>();
        Set<String> names = new HashSet<>();
        List<String> unknown = new ArrayList<>();
        while (true) {
            if (!scanner.nextLine())
                throw scanner.error("the header has no end_header", "The file is cut off; get it again");
            if (!scanner.nextOnLine()) continue;
            switch (scanner.token()) {
                case "format" -> encoding = encoding(scanner);
                case "comment" -> texture(scanner, textures);
                case "obj_info" -> {}
                case "element" -> {
                    Element element = element(scanner);
                    if (!names.add("element " + element.name)) throw repeated(scanner, "element " + element.name);
                    elements.add(element);
                }
                case "property" -> {
                    if (elements.isEmpty()) throw scanner.error("a property before any element", "Correct the header");
                    Element element = elements.get(elements.size() - 1);
                    element.properties.add(property(scanner));
                }
                case "end_header" -> {
                    if (encoding == null)
                        throw scanner.error("the header names no format", "Add a line such as \"format ascii 1.0\"");
                    if (!unknown.isEmpty())
                        notes.add(Notes.unread(
                                Notes.count(unknown.size(), "header line") + " of no known kind skipped: "
                                        + Notes.names(unknown) + ".",
                                unknown));
                    scanner.restOfLine();
                    PlyHeader header = new PlyHeader(encoding, elements, textures, 0, scanner.line() + 1);
                    return header.withDataOffset(PlyStart.of(content, scanner.offset(), header));
                }
                default -> unknown.add(scanner.token());
            }
        }
    }

    PlyHeader withDataOffset(long offset) {
        return new PlyHeader(encoding, elements, textures, offset, dataLine);
    }

    private static Encoding encoding(TextScanner scanner) throws ModelFormatException {
        String word = scanner.nextOnLine() ? scanner.token() : "";
        return switch (word) {
            case "ascii" -> Encoding.ASCII;
            case "binary_little_endian" -> Encoding.LITTLE_ENDIAN;
            case "binary_big_endian" -> Encoding.BIG_ENDIAN;
            default ->
                throw scanner.error(
                        "unknown format " + TokenScanner.quote(word),
                        "Use ascii, binary_little_endian or binary_big_endian");
        };
    }

    private static void texture(TextScanner scanner, List<String> textures) {
        if (!scanner.nextOnLine() || !scanner.tokenIs("TextureFile")) return;
        String path = scanner.restOfLine();
        if (!path.isEmpty()) textures.add(path);
    }

    private static Element element(TextScanner scanner) throws ModelFormatException {
        if (!scanner.nextOnLine()) throw scanner.error("an element without a name", "Correct the header");
        String name = scanner.token();
        scanner.checkCount("elements " + TokenScanner.quote(name));
        int count = scanner.intOnLine("the number of element " + TokenScanner.quote(name));
        if (count < 0)
            throw scanner.error(
                    "element " + TokenScanner.quote(name) + " has the number " + count, "Correct the header");
        return new Element(name, count, new ArrayList<>());
    }

    private static Property property(TextScanner scanner) throws ModelFormatException {
        PlyType type = null;
        PlyType countType = null;
        if (scanner.nextOnLine() && scanner.tokenIs("list")) {
            countType = type(scanner, scanner.nextOnLine());
            if (!countType.isInteger())
                throw scanner.error("a list length of type " + scanner.quote(), "Use an integer type");
            type = type(scanner, scanner.nextOnLine());
        } else {
            type = type(scanner, true);
        }
        if (!scanner.nextOnLine()) throw scanner.error("a property without a name", "Correct the header");
        return new Property(scanner.token(), type, countType);
    }

    private static PlyType type(TextScanner scanner, boolean found) throws ModelFormatException {
        PlyType type = found ? PlyType.named(scanner.token()) : null;
        if (type == null)
            throw scanner.error(
                    "a property of unknown type " + scanner.quote(),
                    "Use a type from char to double, or from int8 to float64");
        return type;
    }

    private static ModelFormatException repeated(TextScanner scanner, String what) {
        return scanner.error(Notes.shown(what) + " appears twice", "Rename or remove one");
    }
}
