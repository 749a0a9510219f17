package org.jsmesh.mesh.io;

import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;

/** The NULs and the end-of-file character that some programs fill a text file up with. */
final class TextFilling {
    private static final int PORTION = 1 << 16;

    private TextFilling() {}

    /** The bytes in front of it. */
    static byte[] without(byte[] bytes) {
        int end = end(bytes, bytes.length);
        return end == bytes.length ? bytes : Arrays.copyOf(bytes, end);
    }

    private static int end(byte[] bytes, int length) {
        int end = length;
        while (end > 0 && (bytes[end - 1] == 0 || bytes[end - 1] == 0x1A)) end--;
        return end;
    }

    /** Where it begins. A packed source unpacks all bytes before a place anew, so there are two readings at most. */
    static long end(ByteSource content) throws IOException {
        if (content instanceof ByteSource.Held held) return end(held.content(), held.content().length);
        long last = Math.max(0, content.length() - PORTION);
        long end = end(content, last, content.length());
        return end > last || last == 0 ? end : end(content, 0, last);
    }

    /** The place behind the last byte of text between two places, or the first place. */
    private static long end(ByteSource content, long from, long to) throws IOException {
        long end = from;
        byte[] portion = new byte[(int) Math.min(PORTION, to - from)];
        try (InputStream in = content.from(from)) {
            long at = from;
            for (int count; at < to; at += count) {
                count = in.read(portion, 0, (int) Math.min(portion.length, to - at));
                if (count < 0) throw ByteWindow.cut();
                int text = end(portion, count);
                if (text > 0) end = at + text;
            }
        }
        return end;
    }
}
