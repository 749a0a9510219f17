package org.jsmesh.upload;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.security.MessageDigest;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.locks.ReentrantLock;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jsmesh.files.AtomicFiles;

/**
 * A model that comes in parts, whenever its sender has a connection. What the server says it has is on disk, whatever
 * becomes of the server. Thread-safe; one part comes at a time.
 */
public final class Resumable {
    private static final String PART = "part";
    private static final String PLAN = "resume";
    private static final String OFFSET = "offset";
    private static final long FORCE_BYTES = 4 << 20;
    private static final long FORCE_NANOS = 2_000_000_000L;
    private static final Pattern NUMBERS = Pattern.compile("(\\d{1,19}) (\\d{1,19})");

    private final Ticket ticket;
    private final String name;
    private final long length;
    private final String extension;
    private final String metadata;
    private final ReentrantLock turn = new ReentrantLock();
    private volatile long offset;
    private volatile long changedMillis;
    private volatile boolean over;

    private Resumable(Ticket ticket, String name, long length, String extension, String metadata) {
        this.ticket = ticket;
        this.name = name;
        this.length = length;
        this.extension = extension;
        this.metadata = metadata;
    }

    /** Makes its folder. The metadata is one line of ASCII. */
    static Resumable begin(Ticket ticket, String name, long length, String extension, String metadata)
            throws IOException {
        Resumable begun = new Resumable(ticket, name, length, extension, metadata);
        ticket.begin();
        Files.createFile(ticket.folder().resolve(PART));
        begun.note(0);
        String plan = name + '\n' + length + '\n' + extension + '\n' + metadata + '\n';
        AtomicFiles.write(ticket.folder().resolve(PLAN), plan.getBytes(StandardCharsets.UTF_8));
        AtomicFiles.syncFolder(ticket.folder().getParent());
        return begun;
    }

    /** What an earlier server has left; null when the folder holds no such upload. */
    static Resumable of(Ticket ticket) throws IOException {
        Path plan = ticket.folder().resolve(PLAN);
        if (!Files.exists(plan)) return null;
        List<String> lines = Files.readAllLines(plan);
        Matcher numbers = NUMBERS.matcher(
                Files.readString(ticket.folder().resolve(OFFSET)).strip());
        if (lines.size() < 4 || !numbers.matches()) return null;
        Resumable left = new Resumable(ticket, lines.get(0), Long.parseLong(lines.get(1)), lines.get(2), lines.get(3));
        left.offset = Long.parseLong(numbers.group(1));
        left.changedMillis = Long.parseLong(numbers.group(2));
        return left;
    }

    /** {@return its name, which nobody can guess} */
    public String name() {
        return name;
    }

    /** {@return the id of the model} */
    public String id() {
        return ticket.id();
    }

    /** {@return how many bytes it will have} */
    public long length() {
        return length;
    }

    /** {@return how many bytes are on disk} */
    public long offset() {
        return offset;
    }

    /** {@return what its sender has said of it when it began, as it was sent} */
    public String metadata() {
        return metadata;
    }

    Ticket ticket() {
        return ticket;
    }

    Instant expires(long unfinishedMillis) {
        return Instant.ofEpochMilli(changedMillis + unfinishedMillis);
    }

    /** {@return true when nobody else sends a part now; then {@link #end} must follow} */
    public boolean begin() {
        return turn.tryLock();
    }

    /** The part is over. */
    public void end() {
        turn.unlock();
    }

    /** {@return true when it is whole or removed; to be asked by who has the turn} */
    public boolean isOver() {
        return over;
    }

    /**
     * Appends a part. To be called by who has the turn.
     *
     * @param in the part, of which no more is read than is missing
     * @param digest of the part, or null
     * @param expected its value, without which nothing of the part is kept
     * @return whether the digest is as expected
     * @throws Upload.SpoolException when the part cannot be written
     * @throws IOException when it does not come; what has come without a digest is kept
     */
    public boolean append(InputStream in, MessageDigest digest, byte[] expected) throws IOException {
        long at = offset;
        try (FileChannel channel = open(at)) {
            byte[] block = new byte[1 << 16];
            long forced = System.nanoTime();
            try {
                while (at < length) {
                    int count = in.read(block, 0, (int) Math.min(block.length, length - at));
                    if (count < 0) break;
                    if (digest != null) digest.update(block, 0, count);
                    write(channel, ByteBuffer.wrap(block, 0, count));
                    at += count;
                    boolean much = at - offset >= FORCE_BYTES || System.nanoTime() - forced >= FORCE_NANOS;
                    if (!much || digest != null) continue;
                    force(channel, at);
                    forced = System.nanoTime();
                }
            } finally {
                if (digest == null && at > offset) force(channel, at);
            }
            if (digest == null) return true;
            if (!MessageDigest.isEqual(digest.digest(), expected)) return false;
            force(channel, at);
            return true;
        }
    }

    /** Drops what came after the last byte that is known to be on disk. */
    private FileChannel open(long at) throws Upload.SpoolException {
        try {
            FileChannel channel = FileChannel.open(ticket.folder().resolve(PART), StandardOpenOption.WRITE);
            return channel.truncate(at).position(at);
        } catch (IOException e) {
            throw new Upload.SpoolException(e);
        }
    }

    private static void write(FileChannel channel, ByteBuffer bytes) throws Upload.SpoolException {
        try {
            while (bytes.hasRemaining()) channel.write(bytes);
        } catch (IOException e) {
            throw new Upload.SpoolException(e);
        }
    }

    private void force(FileChannel channel, long at) throws Upload.SpoolException {
        try {
            channel.force(true);
            note(at);
        } catch (IOException e) {
            throw new Upload.SpoolException(e);
        }
    }

    private void note(long at) throws IOException {
        long now = System.currentTimeMillis();
        String numbers = at + " " + now + "\n";
        AtomicFiles.write(ticket.folder().resolve(OFFSET), numbers.getBytes(StandardCharsets.US_ASCII));
        offset = at;
        changedMillis = now;
    }

    /** Gives the file the name of a whole one. From now on it will be encoded. */
    void complete() throws Upload.SpoolException {
        try {
            AtomicFiles.move(ticket.folder().resolve(PART), ticket.body(extension));
            over = true;
        } catch (IOException e) {
            throw new Upload.SpoolException(e);
        }
    }

    /** Nothing can be appended any more. */
    void give() {
        over = true;
    }
}
