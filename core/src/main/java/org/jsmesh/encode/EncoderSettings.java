package org.jsmesh.encode;

/**
 * How to encode.
 *
 * @param baseFaces faces of the base mesh to aim at; 0 lets the encoder choose (about the first 1% of the bytes up to 14 bits of precision)
 * @param threads that may be used; the bytes do not depend on it
 * @param keepOrder whether the archive is to give back the order of vertices, faces, corners and materials, and what no face refers to
 */
public record EncoderSettings(int baseFaces, int threads, boolean keepOrder) {
    /** @throws IllegalArgumentException without a thread, or with a negative number of faces */
    public EncoderSettings {
        if (threads < 1) throw new IllegalArgumentException("threads: " + threads);
        if (baseFaces < 0) throw new IllegalArgumentException("faces of the base: " + baseFaces);
    }

    public static EncoderSettings defaults() {
        return new EncoderSettings(0, 1, false);
    }

    public EncoderSettings withBaseFaces(int faces) {
        return new EncoderSettings(faces, threads, keepOrder);
    }

    public EncoderSettings withThreads(int count) {
        return new EncoderSettings(baseFaces, count, keepOrder);
    }

    public EncoderSettings withKeepOrder(boolean keep) {
        return new EncoderSettings(baseFaces, threads, keep);
    }
}
