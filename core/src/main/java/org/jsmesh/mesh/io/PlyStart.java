package org.jsmesh.mesh.io;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Finds the first byte behind the header of a PLY file. A header ends with LF, CR LF or a lone CR, and its last line
 * may end otherwise than the others: an LF behind a CR ends the line or is the first byte of the data. Where both can
 * be, that start is right which leaves nothing over behind the last element.
 */
final class PlyStart {
    private final byte[] content;
    private final PlyHeader header;

    private PlyStart(byte[] content, PlyHeader header) {
        this.content = content;
        this.header = header;
    }

    /** @param at the end of the text of the line {@code end_header} */
    static int of(byte[] content, int at, PlyHeader header) {
        if (at == content.length) return at;
        boolean pair = content[at] == '\r' && at + 1 < content.length && content[at + 1] == '\n';
        if (!pair) return at + 1;
        if (header.encoding() == PlyHeader.Encoding.ASCII) return at + 2;
        PlyStart start = new PlyStart(content, header);
        int likely = start.linesEndWithCarriageReturn() ? at + 1 : at + 2;
        int other = 2 * at + 3 - likely;
        return start.leavesNothing(likely) || !start.leavesNothing(other) ? likely : other;
    }

    private boolean linesEndWithCarriageReturn() {
        int first = 0;
        while (content[first] != '\r' && content[first] != '\n') first++;
        return content[first] == '\r' && content[first + 1] != '\n';
    }

    private boolean leavesNothing(int from) {
        ByteOrder order =
                header.encoding() == PlyHeader.Encoding.LITTLE_ENDIAN ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN;
        ByteBuffer data = ByteBuffer.wrap(content).order(order);
        long at = from;
        for (PlyHeader.Element element : header.elements()) {
            long fixed = element.bytesOfScalars();
            if (fixed >= 0) {
                at += fixed * element.count();
                continue;
            }
            for (int row = 0; row < element.count() && at >= 0; row++) at = behindRow(data, at, element);
            if (at < 0) return false;
        }
        return at == content.length;
    }

    /** −1 when the row does not end within the file. */
    private static long behindRow(ByteBuffer data, long from, PlyHeader.Element element) {
        long at = from;
        for (PlyHeader.Property property : element.properties()) {
            int bytes = property.type().bytes();
            if (property.isList()) {
                PlyType countType = property.countType();
                if (at + countType.bytes() > data.capacity()) return -1;
                double count = countType.get(data.position((int) at));
                if (count < 0) return -1;
                at += countType.bytes() + (long) count * bytes;
            } else {
                at += bytes;
            }
            if (at > data.capacity()) return -1;
        }
        return at;
    }
}
