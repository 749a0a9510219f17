package org.jsmesh.memory;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.jsmesh.encode.EncoderSettings;

/**
 * The heap that encoding a model takes, told from its header, its length and a few samples, without reading it whole.
 *
 * <pre>
 *     MemoryEstimate need = MemoryEstimate.of(Path.of("chair.ply"), EncoderSettings.defaults());
 *     System.out.println(need.faces() + " faces take " + (need.bytes() &gt;&gt; 20) + " MiB of heap");
 * </pre>
 *
 * The file is not checked. What looks damaged, or like no model at all, is taken for whatever its length allows; that
 * it cannot be encoded is found out by reading it.
 *
 * @param faces triangles that the model is likely to have
 * @param channels values of attributes that a corner has beside its position: 3 for a normal, 2 for a texture
 *     coordinate, up to 4 for a colour
 * @param bytes of heap that are enough in nearly all cases, those that the program itself takes included
 * @param leastBytes with less heap than this the model cannot be encoded
 */
public record MemoryEstimate(long faces, int channels, long bytes, long leastBytes) {
    /** The part of {@link ByteRanges} that tells most: a source of the first bytes alone should have so many. */
    public static final int START_BYTES = 1 << 16;

    /**
     * Checks the numbers.
     *
     * @param faces see {@link #faces()}
     * @param channels see {@link #channels()}
     * @param bytes see {@link #bytes()}
     * @param leastBytes see {@link #leastBytes()}
     * @throws IllegalArgumentException when a number is negative, or the least is more than enough
     */
    public MemoryEstimate {
        if (faces < 0 || channels < 0 || leastBytes < 0 || leastBytes > bytes)
            throw new IllegalArgumentException(
                    faces + " faces, " + channels + " channels, " + leastBytes + " to " + bytes + " bytes");
    }

    /**
     * Estimates what a model file takes.
     *
     * @param model the file; companions are not looked at
     * @param settings that it will be encoded with
     * @return the estimate
     * @throws IOException when the file cannot be read
     */
    public static MemoryEstimate of(Path model, EncoderSettings settings) throws IOException {
        Path name = model.getFileName();
        try (FileChannel channel = FileChannel.open(model, StandardOpenOption.READ)) {
            return of(
                    name == null ? "" : name.toString(),
                    Files.size(model),
                    (from, bytes) -> read(channel, from, bytes),
                    settings);
        }
    }

    /**
     * Estimates what a model takes that lies somewhere else. It reads {@link #START_BYTES} at the beginning, of glTF
     * the description if it has no more than 4 MiB, and of text and archives some 64 samples of 4 KiB.
     *
     * @param name of the file, a hint where its first bytes leave the format open
     * @param length of the whole file
     * @param content reads parts of it
     * @param settings that it will be encoded with
     * @return the estimate
     * @throws IOException when the source cannot be read
     */
    public static MemoryEstimate of(String name, long length, ByteRanges content, EncoderSettings settings)
            throws IOException {
        if (length < 0) throw new IllegalArgumentException("bytes of the file: " + length);
        return HeapCost.of(ModelCount.of(new Sampled(name, length, content)), settings);
    }

    /**
     * Estimates what a model takes of which only the beginning is at hand. The estimate is less sure than with samples
     * of text, and of a glTF or ZIP file whose directory lies further behind.
     *
     * @param name of the file, a hint where its first bytes leave the format open
     * @param length of the whole file
     * @param start its first bytes, {@link #START_BYTES} of them or all
     * @param settings that it will be encoded with
     * @return the estimate
     */
    public static MemoryEstimate of(String name, long length, byte[] start, EncoderSettings settings) {
        try {
            return of(name, length, ByteRanges.ofStart(start), settings);
        } catch (IOException e) {
            throw new IllegalStateException(e); // an array can be read
        }
    }

    /**
     * The largest models that a heap is surely enough for, if they are surfaces: with a normal, a texture coordinate
     * and a material at every corner, and faces that share vertices.
     *
     * @param heapBytes of the heap
     * @return faces, at least 1
     */
    public static long facesFor(long heapBytes) {
        return HeapCost.faces(heapBytes);
    }

    private static byte[] read(FileChannel channel, long from, int bytes) throws IOException {
        ByteBuffer buffer = ByteBuffer.allocate((int) Math.max(0, Math.min(bytes, channel.size() - from)));
        while (buffer.hasRemaining()) if (channel.read(buffer, from + buffer.position()) < 0) break;
        byte[] read = new byte[buffer.position()];
        buffer.flip().get(read);
        return read;
    }
}
