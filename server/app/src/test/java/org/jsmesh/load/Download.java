package org.jsmesh.load;

import java.nio.ByteBuffer;
import java.security.MessageDigest;
import java.util.Arrays;
import java.util.HexFormat;

/** The archive as one viewer puts it together; every byte is looked at once. */
final class Download {
    private final Model model;
    private final MessageDigest digest = Model.newDigest();
    private final byte[] kept;
    private long received;
    private long sentTwice;

    /** @param keep whether the bytes are wanted afterwards, to be decoded */
    Download(Model model, boolean keep) {
        this.model = model;
        kept = keep ? new byte[model.bytes().length] : null;
    }

    long received() {
        return received;
    }

    boolean isComplete() {
        return received == model.bytes().length;
    }

    /** Bytes that came though they were there. */
    long sentTwice() {
        return sentTwice;
    }

    /**
     * Takes bytes of the archive.
     *
     * @param at place of the first one
     * @return what is wrong with them, or null
     */
    String take(long at, ByteBuffer bytes) {
        long known = Math.min(Math.max(0, received - at), bytes.remaining());
        sentTwice += known;
        bytes.position(bytes.position() + (int) known);
        if (!bytes.hasRemaining()) return null;
        if (at + known != received) return "bytes from " + at + " on, where " + received + " was next";
        if (received + bytes.remaining() > model.bytes().length) return "more bytes than the archive has";
        int from = (int) received;
        int count = bytes.remaining();
        int wrong = ByteBuffer.wrap(model.bytes(), from, count).mismatch(bytes);
        if (wrong >= 0) return "byte " + (from + wrong) + " is another than in the file";
        digest.update(bytes.duplicate());
        if (kept != null) bytes.get(kept, from, count);
        received += count;
        return null;
    }

    /** Whether what came is the archive; asked once, at the end. */
    boolean isOriginal() {
        return isComplete() && HexFormat.of().formatHex(digest.digest()).equals(model.sha256());
    }

    /** The bytes kept, or null. */
    byte[] kept() {
        return kept == null ? null : Arrays.copyOf(kept, (int) received);
    }
}
