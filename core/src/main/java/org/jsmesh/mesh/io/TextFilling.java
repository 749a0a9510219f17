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
        int end = end(bytes);
        return end == bytes.length ? bytes : Arrays.copyOf(bytes, end);
    }

    private static int end(byte[] bytes) {
        int end = bytes.length;
        while (end > 0 && (bytes[end - 1] == 0 || bytes[end - 1] == 0x1A)) end--;
        return end;
    }

    /** Where it begins. */
    static long end(ByteSource content) throws IOException {
        if (content instanceof ByteSource.Held held) return end(held.content());
        for (long end = content.length(); end > 0; ) {
            int count = (int) Math.min(end, PORTION);
            byte[] last = new byte[count];
            try (InputStream in = content.from(end - count)) {
                for (int at = 0, read; at < count && (read = in.read(last, at, count - at)) >= 0; ) at += read;
            }
            int text = end(last);
            if (text > 0) return end - count + text;
            end -= count;
        }
        return 0;
    }
}
