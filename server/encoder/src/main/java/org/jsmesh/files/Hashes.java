package org.jsmesh.files;

import java.io.IOException;
import java.io.InputStream;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;

/** SHA-256 in lower-case hexadecimal. */
final class Hashes {
    private static final int PORTION = 1 << 16;

    private Hashes() {}

    static MessageDigest digest() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e); // every JDK has it
        }
    }

    static String sha256(byte[] content) {
        return HexFormat.of().formatHex(digest().digest(content));
    }

    /** @param in read to its end, not closed */
    static String sha256(InputStream in) throws IOException {
        MessageDigest digest = digest();
        byte[] portion = new byte[PORTION];
        for (int count; (count = in.read(portion)) >= 0; ) digest.update(portion, 0, count);
        return HexFormat.of().formatHex(digest.digest());
    }
}
