package org.jsmesh.upload;

import org.jsmesh.memory.MemoryEstimate;
import org.jsmesh.sandbox.SandboxLimits;

/**
 * What the server grants clients that send models.
 *
 * @param tokens of those who may send
 * @param mostBytes of one model file, of a ZIP archive also after unpacking
 * @param mostFaces of a model
 * @param encodeMillis that encoding one may take
 * @param queued models that are received, wait or are encoded at the same time
 * @param heapMegabytes of the process that encodes, in MiB
 * @param unfinishedMillis that a model which comes in parts is kept without a further part
 */
public record UploadSettings(
        UploadTokens tokens,
        long mostBytes,
        int mostFaces,
        long encodeMillis,
        int queued,
        int heapMegabytes,
        long unfinishedMillis) {
    private static final int HEAP_MEGABYTES = 2048;
    private static final int ROUND = 1000;

    /**
     * Checks the settings.
     *
     * @param tokens see {@link #tokens()}
     * @param mostBytes see {@link #mostBytes()}
     * @param mostFaces see {@link #mostFaces()}
     * @param encodeMillis see {@link #encodeMillis()}
     * @param queued see {@link #queued()}
     * @param heapMegabytes see {@link #heapMegabytes()}
     * @param unfinishedMillis see {@link #unfinishedMillis()}
     * @throws IllegalArgumentException when a number is below 1, or the heap below 32 MiB
     */
    public UploadSettings {
        if (mostBytes < 1) throw new IllegalArgumentException("bytes of an upload: " + mostBytes);
        if (mostFaces < 1) throw new IllegalArgumentException("faces of an upload: " + mostFaces);
        if (encodeMillis < 1) throw new IllegalArgumentException("milliseconds of encoding: " + encodeMillis);
        if (queued < 1) throw new IllegalArgumentException("uploads in the queue: " + queued);
        if (unfinishedMillis < 1) throw new IllegalArgumentException("milliseconds of a part: " + unfinishedMillis);
        if (heapMegabytes < 32) throw new IllegalArgumentException("MiB of the encoder: " + heapMegabytes);
    }

    /**
     * {@return settings that grant 256 MiB, 10 minutes, 8 in the queue, 2 GiB of heap, the faces of surfaces that are
     * {@linkplain #facesFor sure to fit} in it, and a day for the next part}
     *
     * @param tokens of those who may send
     */
    public static UploadSettings of(UploadTokens tokens) {
        return new UploadSettings(tokens, 256L << 20, facesFor(HEAP_MEGABYTES), 600_000, 8, HEAP_MEGABYTES, 86_400_000);
    }

    /**
     * Says which limit of faces goes with a heap: a surface that is let in can be encoded. Triangles that share no
     * vertices take more; such a model is refused by what its file says of it, or fails.
     *
     * @param heapMegabytes of the process that encodes, in MiB
     * @return faces, in round thousands where they are many
     */
    public static int facesFor(int heapMegabytes) {
        long faces = MemoryEstimate.facesFor((long) heapMegabytes << 20);
        return (int) Math.min(Integer.MAX_VALUE, faces < ROUND ? faces : faces / ROUND * ROUND);
    }

    /**
     * Changes how large a model file may be.
     *
     * @param bytes at least 1; of a ZIP archive also after unpacking
     * @return settings that differ in that alone
     */
    public UploadSettings withMostBytes(long bytes) {
        return new UploadSettings(tokens, bytes, mostFaces, encodeMillis, queued, heapMegabytes, unfinishedMillis);
    }

    /**
     * Changes how many faces a model may have.
     *
     * @param faces at least 1
     * @return settings that differ in that alone
     */
    public UploadSettings withMostFaces(int faces) {
        return new UploadSettings(tokens, mostBytes, faces, encodeMillis, queued, heapMegabytes, unfinishedMillis);
    }

    /**
     * Changes how long encoding one model may take.
     *
     * @param millis at least 1; a model that takes longer has failed
     * @return settings that differ in that alone
     */
    public UploadSettings withEncodeMillis(long millis) {
        return new UploadSettings(tokens, mostBytes, mostFaces, millis, queued, heapMegabytes, unfinishedMillis);
    }

    /**
     * Changes how many models are taken at the same time.
     *
     * @param models at least 1 that are received, wait or are encoded; further ones are refused
     * @return settings that differ in that alone
     */
    public UploadSettings withQueued(int models) {
        return new UploadSettings(tokens, mostBytes, mostFaces, encodeMillis, models, heapMegabytes, unfinishedMillis);
    }

    /**
     * Changes the memory of the process that encodes. The limit of faces stays; see {@link #facesFor}.
     *
     * @param megabytes of its heap, in MiB, at least 32
     * @return settings that differ in that alone
     */
    public UploadSettings withHeapMegabytes(int megabytes) {
        return new UploadSettings(tokens, mostBytes, mostFaces, encodeMillis, queued, megabytes, unfinishedMillis);
    }

    /**
     * Changes how long a model that comes in parts is kept.
     *
     * @param millis at least 1, from one part to the next
     * @return settings that differ in that alone
     */
    public UploadSettings withUnfinishedMillis(long millis) {
        return new UploadSettings(tokens, mostBytes, mostFaces, encodeMillis, queued, heapMegabytes, millis);
    }

    /** What a process that encodes may take. */
    SandboxLimits sandbox() {
        return SandboxLimits.defaults()
                .withHeapMegabytes(heapMegabytes)
                .withEncodeMillis(encodeMillis)
                .withMostFaces(mostFaces)
                .withMostBytes(mostBytes);
    }
}
