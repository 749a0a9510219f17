package org.jsmesh.files;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Set;

/**
 * Leaves out what a PNG says of its colour space. Viewers show the numbers of its pixels as they are, as glTF wants it;
 * the library would convert them.
 */
final class PlainPng {
    private static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', 13, 10, 26, 10};
    private static final Set<String> LEFT_OUT = Set.of("iCCP", "gAMA", "cHRM", "sRGB");
    /** Bytes of a chunk around its content: length, type, check. */
    private static final int FRAME = 12;

    private PlainPng() {}

    /** The same picture without colour space; files of other kinds, and damaged ones, as they are. */
    static byte[] of(byte[] file) {
        if (!Arrays.equals(SIGNATURE, Arrays.copyOf(file, SIGNATURE.length))) return file;
        ByteArrayOutputStream plain = new ByteArrayOutputStream(file.length);
        plain.write(file, 0, SIGNATURE.length);
        for (int at = SIGNATURE.length; at + FRAME <= file.length; ) {
            long length = FRAME;
            for (int i = 0; i < 4; i++) length += (file[at + i] & 255L) << 24 - 8 * i;
            if (length > file.length - at) return file;
            String type = new String(file, at + 4, 4, StandardCharsets.ISO_8859_1);
            if (!LEFT_OUT.contains(type)) plain.write(file, at, (int) length);
            at += (int) length;
        }
        return plain.toByteArray();
    }
}
