package org.jsmesh.mesh;

import java.util.Arrays;

/**
 * Texts as UTF-8, as {@code String.getBytes} and {@code new String} have them. The converters of the class library for
 * any charset are most of what the page would have to load for it.
 */
public final class Utf8 {
    private static final char UNKNOWN = '\ufffd';

    private Utf8() {}

    /**
     * Writes a text.
     *
     * @param text any text
     * @return its bytes; a surrogate without its other half becomes a question mark
     */
    public static byte[] bytes(String text) {
        byte[] bytes = new byte[3 * text.length()];
        int n = 0;
        for (int i = 0; i < text.length(); i++) {
            int c = text.charAt(i);
            if (c >= 0xd800 && c < 0xe000) {
                int low = c < 0xdc00 && i + 1 < text.length() ? text.charAt(i + 1) : 0;
                if (low >= 0xdc00 && low < 0xe000) {
                    c = 0x10000 + (c - 0xd800 << 10) + (low - 0xdc00);
                    i++;
                } else {
                    c = '?';
                }
            }
            int more = c < 0x80 ? 0 : c < 0x800 ? 1 : c < 0x10000 ? 2 : 3; // bytes after the first one
            bytes[n++] = (byte) (more == 0 ? c : 0xff80 >> more | c >> 6 * more);
            while (more-- > 0) bytes[n++] = (byte) (0x80 | c >> 6 * more & 0x3f);
        }
        return Arrays.copyOf(bytes, n);
    }

    /**
     * Reads a text.
     *
     * @param bytes an array that holds it
     * @param offset of its first byte
     * @param length number of its bytes
     * @return the text; each part that is no UTF-8 becomes U+FFFD
     */
    public static String text(byte[] bytes, int offset, int length) {
        StringBuilder text = new StringBuilder();
        int end = offset + length;
        int at = offset;
        while (at < end) {
            int first = bytes[at++] & 0xff;
            int more =
                    first < 0x80 ? 0 : first < 0xc2 ? -1 : first < 0xe0 ? 1 : first < 0xf0 ? 2 : first < 0xf5 ? 3 : -1;
            int c = more <= 0 ? first : first & 0x3f >> more;
            // The second byte tells whether there is a shorter form, or no such character.
            int least = first == 0xe0 ? 0xa0 : first == 0xf0 ? 0x90 : 0x80;
            int most = first == 0xf4 ? 0x8f : 0xbf;
            for (; more > 0; more--) {
                int next = at < end ? bytes[at] & 0xff : 0;
                if (next < least || next > most) break;
                c = c << 6 | next & 0x3f;
                at++;
                least = 0x80;
                most = 0xbf;
            }
            if (more != 0 || c >= 0xd800 && c < 0xe000) text.append(UNKNOWN);
            else if (c < 0x10000) text.append((char) c);
            else text.append((char) (0xd7c0 + (c >> 10))).append((char) (0xdc00 | c & 0x3ff));
        }
        return text.toString();
    }
}
