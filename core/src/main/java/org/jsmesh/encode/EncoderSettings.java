package org.jsmesh.encode;

import java.io.Serializable;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.jsmesh.mesh.UpAxis;

/**
 * How to encode. Settings are {@link Serializable}, so that jobs can carry them to other machines.
 *
 * @param baseFaces faces of the base mesh to aim at; 0 lets the encoder choose (about the first 1% of the bytes up to
 *     14 bits of precision; with {@link Simplifier#PAPER} as few as the levels allow)
 * @param threads that may be used; the bytes do not depend on it
 * @param keepOrder whether the archive gives back the order of vertices, faces, corners and materials, and what no face
 *     refers to
 * @param simplifier that chooses the collapses
 * @param quality of {@link Simplifier#QUADRIC}
 * @param levels thresholds of the weight for the levels of {@link Simplifier#PAPER}, ascending; none for
 *     {@link org.jsmesh.collapse.PaperSimplifier#DEFAULT_THRESHOLDS}
 * @param up the axis of the model that points up; {@link UpAxis#UNKNOWN} takes the one that the file's format has
 * @param poster whether the archive has a poster, where the encoder has a {@linkplain PosterPainter painter}
 */
public record EncoderSettings(
        int baseFaces,
        int threads,
        boolean keepOrder,
        Simplifier simplifier,
        Quality quality,
        List<Double> levels,
        UpAxis up,
        boolean poster)
        implements Serializable {
    /** Upper limit of levels; differences of attributes are far below it. */
    private static final double LARGEST_THRESHOLD = 1_000_000;

    /**
     * Checks the settings.
     *
     * @param baseFaces see {@link #baseFaces()}
     * @param threads see {@link #threads()}
     * @param keepOrder see {@link #keepOrder()}
     * @param simplifier see {@link #simplifier()}
     * @param quality see {@link #quality()}
     * @param levels see {@link #levels()}
     * @param up see {@link #up()}
     * @param poster see {@link #poster()}
     * @throws IllegalArgumentException without a thread, with a negative number of faces, or with levels that the
     *     simplifier cannot take
     */
    public EncoderSettings {
        if (threads < 1) throw new IllegalArgumentException("threads: " + threads);
        if (baseFaces < 0) throw new IllegalArgumentException("faces of the base: " + baseFaces);
        levels = List.copyOf(levels);
        if (!levels.isEmpty() && simplifier != Simplifier.PAPER)
            throw new IllegalArgumentException("levels " + levels + " are for the simplifier of the paper");
        double last = 0;
        for (double level : levels) {
            if (!(level > last) || level > LARGEST_THRESHOLD)
                throw new IllegalArgumentException(
                        "levels " + levels + ": thresholds ascend from above 0 to at most " + (int) LARGEST_THRESHOLD);
            last = level;
        }
    }

    /** {@return what the command uses when it is told nothing} */
    public static EncoderSettings defaults() {
        return new EncoderSettings(0, 1, false, Simplifier.QUADRIC, Quality.DEFAULT, List.of(), UpAxis.UNKNOWN, true);
    }

    /**
     * Changes the size of the base mesh.
     *
     * @param faces to aim at; 0 lets the encoder choose
     * @return settings that differ in that alone
     */
    public EncoderSettings withBaseFaces(int faces) {
        return new EncoderSettings(faces, threads, keepOrder, simplifier, quality, levels, up, poster);
    }

    /**
     * Changes how many threads may be used.
     *
     * @param count at least 1
     * @return settings that differ in that alone
     */
    public EncoderSettings withThreads(int count) {
        return new EncoderSettings(baseFaces, count, keepOrder, simplifier, quality, levels, up, poster);
    }

    /**
     * Changes whether the order of the original is kept.
     *
     * @param keep true to keep it, for which the archive grows
     * @return settings that differ in that alone
     */
    public EncoderSettings withKeepOrder(boolean keep) {
        return new EncoderSettings(baseFaces, threads, keep, simplifier, quality, levels, up, poster);
    }

    /**
     * Changes what chooses the collapses, and empties the list of levels.
     *
     * @param other the simplifier
     * @return settings that differ in simplifier and levels alone
     */
    public EncoderSettings withSimplifier(Simplifier other) {
        return new EncoderSettings(baseFaces, threads, keepOrder, other, quality, List.of(), up, poster);
    }

    /**
     * Changes what {@link Simplifier#QUADRIC} aims at.
     *
     * @param wanted the quality
     * @return settings that differ in that alone
     */
    public EncoderSettings withQuality(Quality wanted) {
        return new EncoderSettings(baseFaces, threads, keepOrder, simplifier, wanted, levels, up, poster);
    }

    /**
     * Changes the levels of {@link Simplifier#PAPER}.
     *
     * @param thresholds of the weight, ascending; none for its own
     * @return settings that differ in that alone
     */
    public EncoderSettings withLevels(List<Double> thresholds) {
        return new EncoderSettings(baseFaces, threads, keepOrder, simplifier, quality, thresholds, up, poster);
    }

    /**
     * Changes the axis that points up.
     *
     * @param axis the axis; {@link UpAxis#UNKNOWN} takes the one that the file's format has
     * @return settings that differ in that alone
     */
    public EncoderSettings withUp(UpAxis axis) {
        return new EncoderSettings(baseFaces, threads, keepOrder, simplifier, quality, levels, axis, poster);
    }

    /**
     * Changes whether the archive has a poster.
     *
     * @param wanted false for none
     * @return settings that differ in that alone
     */
    public EncoderSettings withPoster(boolean wanted) {
        return new EncoderSettings(baseFaces, threads, keepOrder, simplifier, quality, levels, up, wanted);
    }

    /**
     * Names all that the bytes of an archive depend on, for who keeps archives by model and settings. The same settings
     * have the same key in every process and version that knows them; the number of threads is no part of it.
     *
     * @return words with a space between, such as {@code quadric default}: simplifier and quality, and whatever differs
     *     from the {@link #defaults()}
     */
    public String key() {
        StringBuilder key = new StringBuilder(word(simplifier));
        if (simplifier == Simplifier.QUADRIC || quality != Quality.DEFAULT)
            key.append(' ').append(word(quality));
        if (!levels.isEmpty())
            key.append(" levels=").append(levels.stream().map(String::valueOf).collect(Collectors.joining(",")));
        if (baseFaces > 0) key.append(" base-faces=").append(baseFaces);
        if (keepOrder) key.append(" keep-order");
        if (up != UpAxis.UNKNOWN) key.append(" up=").append(word(up));
        if (!poster) key.append(" no-poster");
        return key.toString();
    }

    private static String word(Enum<?> value) {
        return value.name().toLowerCase(Locale.ROOT);
    }
}
