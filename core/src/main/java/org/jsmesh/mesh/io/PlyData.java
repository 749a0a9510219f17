package org.jsmesh.mesh.io;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.Sizes;
import org.jsmesh.mesh.TooLargeException;

/** The values behind a PLY header, one after the other, whatever their encoding. */
abstract class PlyData {
    /** @param scanner that has read the header; it is of no other use then */
    static PlyData of(String file, TextScanner scanner, PlyHeader header) {
        return header.encoding() == PlyHeader.Encoding.ASCII
                ? new Text(scanner, header)
                : new Binary(file, scanner, header);
    }

    /** The next value, exact but for integers beyond 2^53. May be NaN or infinite. */
    abstract double read(PlyType type) throws ModelFormatException;

    /** Reads a coordinate, sets it where it is finite, and returns it. */
    double readCoordinate(PlyType type, int index, Coordinates to) throws ModelFormatException {
        double value = read(type);
        if (Float.isFinite((float) value)) to.set(index, value);
        return value;
    }

    /** Passes over so many bytes of binary data; false when the data are text. */
    abstract boolean skips(long bytes) throws ModelFormatException;

    /** Bytes not read yet. */
    abstract long remaining();

    /** Fewest bytes that a value of this type takes. */
    abstract int leastBytes(PlyType type);

    abstract ModelFormatException error(String reason, String remedy);

    /** Tells of what is behind the last value. */
    abstract void noteRest(List<Note> notes);

    /** The length of a list, checked against what is left of the file. */
    int readCount(PlyHeader.Property list) throws ModelFormatException {
        double count = read(list.countType());
        if (!(count >= 0))
            throw error("list " + Notes.shown(list.name()) + " has the length " + count, "Repair the file");
        if (count * leastBytes(list.type()) > remaining() + 1.0) {
            throw error(
                    "list " + Notes.shown(list.name()) + " has the length " + (long) count + " but only " + remaining()
                            + " bytes are left",
                    "The file is cut off or damaged; get it again");
        }
        if (count > Sizes.MOST)
            throw new TooLargeException((long) count, "values in the list " + Notes.shown(list.name()), Sizes.MOST);
        return (int) count;
    }

    private static final class Binary extends PlyData {
        private final String file;
        private final BinaryBytes data;
        private final ByteBuffer next; // of the same

        Binary(String file, TextScanner scanner, PlyHeader header) {
            this.file = file;
            boolean little = header.encoding() == PlyHeader.Encoding.LITTLE_ENDIAN;
            data = scanner.binaryFrom(header.dataOffset(), little ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
            next = data.data();
        }

        @Override
        double read(PlyType type) throws ModelFormatException {
            if (next.remaining() < type.bytes() && !data.has(type.bytes()))
                throw error("the file ends within its data", "The file is cut off; get it again");
            return type.get(next);
        }

        @Override
        boolean skips(long bytes) throws ModelFormatException {
            if (!data.skip(bytes)) throw error("the file ends within its data", "The file is cut off; get it again");
            return true;
        }

        @Override
        long remaining() {
            return data.remaining();
        }

        @Override
        int leastBytes(PlyType type) {
            return type.bytes();
        }

        @Override
        ModelFormatException error(String reason, String remedy) {
            return new ModelFormatException(file, "byte " + data.offset(), reason, remedy);
        }

        @Override
        void noteRest(List<Note> notes) {
            long rest = data.remaining();
            if (rest == 0) return;
            String text = Notes.count(rest, "byte") + " behind the last element skipped.";
            notes.add(Note.unread(text, (int) Math.min(rest, Integer.MAX_VALUE), "byte " + data.offset()));
            data.skip(rest);
        }
    }

    private static final class Text extends PlyData {
        private final TextScanner scanner;

        Text(TextScanner scanner, PlyHeader header) {
            this.scanner = scanner;
            scanner.skipTo(header.dataOffset());
            scanner.countLinesFrom(header.dataLine());
        }

        @Override
        double read(PlyType type) throws ModelFormatException {
            if (!scanner.next()) throw error("the file ends within its data", "The file is cut off; get it again");
            if (type == PlyType.FLOAT) return scanner.tokenAsAnyFloat("a value");
            double value = scanner.tokenAsDouble("a value");
            if (type.isInteger() && (value != Math.rint(value) || !type.holds(value))) {
                throw error(
                        scanner.quote() + " is no value of type " + type.name().toLowerCase(java.util.Locale.ROOT),
                        "Correct the value or the type in the header");
            }
            return value;
        }

        @Override
        double readCoordinate(PlyType type, int index, Coordinates to) throws ModelFormatException {
            if (type != PlyType.FLOAT) return super.readCoordinate(type, index, to);
            if (!scanner.next()) throw error("the file ends within its data", "The file is cut off; get it again");
            return scanner.tokenAsAnyCoordinate("a value", index, to);
        }

        @Override
        boolean skips(long bytes) {
            return false;
        }

        @Override
        long remaining() {
            return scanner.remaining();
        }

        /** A digit and a separator; the last value of a file needs no separator. */
        @Override
        int leastBytes(PlyType type) {
            return 2;
        }

        @Override
        ModelFormatException error(String reason, String remedy) {
            return scanner.error(reason, remedy);
        }

        @Override
        void noteRest(List<Note> notes) {
            scanner.noteRest("element", notes);
        }
    }
}
