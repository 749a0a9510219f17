package org.jsmesh.mesh.io;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteOrder;

/**
 * Finds the first byte behind the header of a PLY file. A header ends with LF, CR LF or a lone CR, and its last line
 * may end otherwise than the others: an LF behind a CR ends the line or is the first byte of the data. Where both can
 * be, that start is right which leaves nothing over behind the last element.
 */
final class PlyStart {
    private final ByteSource content;
    private final PlyHeader header;

    private PlyStart(ByteSource content, PlyHeader header) {
        this.content = content;
        this.header = header;
    }

    /** @param at the end of the text of the line {@code end_header} */
    static long of(ByteSource content, long at, PlyHeader header) throws IOException {
        if (at == content.length()) return at;
        if (!isPairAt(content, at)) return at + 1;
        if (header.encoding() == PlyHeader.Encoding.ASCII) return at + 2;
        PlyStart start = new PlyStart(content, header);
        long likely = start.linesEndWithCarriageReturn() ? at + 1 : at + 2;
        long other = 2 * at + 3 - likely;
        return start.leavesNothing(likely) || !start.leavesNothing(other) ? likely : other;
    }

    private static boolean isPairAt(ByteSource content, long at) throws IOException {
        try (InputStream in = content.from(at)) {
            return in.read() == '\r' && in.read() == '\n';
        }
    }

    private boolean linesEndWithCarriageReturn() throws IOException {
        try (InputStream in = content.from(0)) {
            int first = in.read();
            while (first >= 0 && first != '\r' && first != '\n') first = in.read();
            return first == '\r' && in.read() != '\n';
        }
    }

    private boolean leavesNothing(long from) {
        ByteOrder order =
                header.encoding() == PlyHeader.Encoding.LITTLE_ENDIAN ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN;
        BinaryBytes data = BinaryBytes.of(content, from, order);
        for (PlyHeader.Element element : header.elements()) {
            long fixed = element.bytesOfScalars();
            if (fixed >= 0) {
                if (fixed * element.count() > data.remaining() || !data.skip(fixed * element.count())) return false;
                continue;
            }
            for (int row = 0; row < element.count(); row++) if (!skipRow(data, element)) return false;
        }
        return data.remaining() == 0;
    }

    /** False when the row does not end within the file. */
    private static boolean skipRow(BinaryBytes data, PlyHeader.Element element) {
        for (PlyHeader.Property property : element.properties()) {
            int bytes = property.type().bytes();
            if (!property.isList()) {
                if (!data.skip(bytes)) return false;
                continue;
            }
            PlyType countType = property.countType();
            if (!data.has(countType.bytes())) return false;
            double count = countType.get(data.data());
            if (count < 0 || count * bytes > data.remaining() || !data.skip((long) count * bytes)) return false;
        }
        return true;
    }
}
