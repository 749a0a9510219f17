package org.jsmesh.upload;

/**
 * What the server grants clients that send models.
 *
 * @param tokens of those who may send
 * @param mostBytes of one model file, of a ZIP archive also after unpacking
 * @param mostFaces of a model
 * @param encodeMillis that encoding one may take
 * @param queued models that are received, wait or are encoded at the same time
 * @param heapMegabytes of the process that encodes
 */
public record UploadSettings(
        UploadTokens tokens, long mostBytes, int mostFaces, long encodeMillis, int queued, int heapMegabytes) {
    public UploadSettings {
        if (mostBytes < 1) throw new IllegalArgumentException("bytes of an upload: " + mostBytes);
        if (mostFaces < 1) throw new IllegalArgumentException("faces of an upload: " + mostFaces);
        if (encodeMillis < 1) throw new IllegalArgumentException("milliseconds of encoding: " + encodeMillis);
        if (queued < 1) throw new IllegalArgumentException("uploads in the queue: " + queued);
        if (heapMegabytes < 32) throw new IllegalArgumentException("MiB of the encoder: " + heapMegabytes);
    }

    /** 256 MiB, 10 million faces, 10 minutes, 8 in the queue, 2 GiB of heap. */
    public static UploadSettings of(UploadTokens tokens) {
        return new UploadSettings(tokens, 256L << 20, 10_000_000, 600_000, 8, 2048);
    }

    public UploadSettings withMostBytes(long bytes) {
        return new UploadSettings(tokens, bytes, mostFaces, encodeMillis, queued, heapMegabytes);
    }

    public UploadSettings withMostFaces(int faces) {
        return new UploadSettings(tokens, mostBytes, faces, encodeMillis, queued, heapMegabytes);
    }

    public UploadSettings withEncodeMillis(long millis) {
        return new UploadSettings(tokens, mostBytes, mostFaces, millis, queued, heapMegabytes);
    }

    public UploadSettings withQueued(int models) {
        return new UploadSettings(tokens, mostBytes, mostFaces, encodeMillis, models, heapMegabytes);
    }

    public UploadSettings withHeapMegabytes(int megabytes) {
        return new UploadSettings(tokens, mostBytes, mostFaces, encodeMillis, queued, megabytes);
    }
}
