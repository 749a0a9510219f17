package org.jsmesh.servlet;

import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import org.jsmesh.servlet.http.ResponseSender;

/**
 * One open file for all answers that send it, also after another one has its name. It is closed when it was given up
 * and the last of them has ended. Thread-safe.
 */
final class SharedFile {
    private static final int BLOCK_BYTES = 32 << 10;

    private final FileChannel channel;
    private int answers;
    private boolean isGivenUp;

    private SharedFile(FileChannel channel) {
        this.channel = channel;
    }

    static SharedFile open(Path file) throws IOException {
        return new SharedFile(FileChannel.open(file));
    }

    FileChannel channel() {
        return channel;
    }

    /** The file for one more answer, which ends it; null when the file was given up. */
    synchronized ResponseSender.Source source() {
        if (isGivenUp) return null;
        answers++;
        return new Blocks();
    }

    /** No further answer will send it. */
    synchronized void giveUp() {
        isGivenUp = true;
        closeIfUnused();
    }

    private synchronized void ended() {
        answers--;
        closeIfUnused();
    }

    private void closeIfUnused() {
        if (!isGivenUp || answers > 0) return;
        try {
            channel.close();
        } catch (IOException e) {
            // It was read only, and nobody reads it any more.
        }
    }

    /** The bytes of the file, a block at a time. */
    private final class Blocks implements ResponseSender.Source {
        private final ByteBuffer block = ByteBuffer.allocate(BLOCK_BYTES);

        @Override
        public ByteBuffer next(long offset, long length) throws IOException {
            block.clear().limit((int) Math.min(length, BLOCK_BYTES));
            if (channel.read(block, offset) <= 0) throw new EOFException("the viewer became shorter");
            return block.flip();
        }

        @Override
        public void ended(boolean whole) {
            SharedFile.this.ended();
        }
    }
}
