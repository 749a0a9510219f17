package org.jsmesh.codec.entropy;

import java.nio.charset.StandardCharsets;
import org.jsmesh.mesh.MalformedStreamException;

/** Codes short texts as UTF-8. */
public final class StringCoder {
    private static final int MAX_BYTES = 4096;

    private StringCoder() {}

    public static String code(BinaryCoder coder, IntegerModel lengths, String text) throws MalformedStreamException {
        byte[] bytes = text == null ? new byte[0] : text.getBytes(StandardCharsets.UTF_8);
        if (bytes.length > MAX_BYTES)
            throw new IllegalArgumentException("a text of " + bytes.length + " bytes, more than " + MAX_BYTES);
        int length = lengths.unsigned(coder, bytes.length);
        if (length > MAX_BYTES) throw new MalformedStreamException(-1, "a text of " + length + " bytes");
        if (!coder.isEncoder()) bytes = new byte[length];
        for (int i = 0; i < length; i++) bytes[i] = (byte) coder.raw(bytes[i] & 0xff, 8);
        return new String(bytes, StandardCharsets.UTF_8);
    }
}
