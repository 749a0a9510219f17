package org.jsmesh.spark;

import java.util.List;
import java.util.Locale;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.Quality;
import org.jsmesh.encode.Simplifier;
import org.jsmesh.mesh.UpAxis;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;
import picocli.CommandLine.TypeConversionException;

/** The options of {@code jsm encode} that decide the bytes of archives; a test compares them. A mixin. */
final class EncodeFlags {
    @Option(
            names = "--base-faces",
            paramLabel = "N",
            description = "Faces of the base mesh to aim at. Default: about the first 1%% of the bytes.")
    private int baseFaces;

    @Option(
            names = "--simplifier",
            paramLabel = "quadric|paper",
            converter = SimplifierName.class,
            description = "quadric (default), or paper: the method of Chen and Nishita 2002.")
    private Simplifier simplifier = Simplifier.QUADRIC;

    @Option(
            names = "--quality",
            paramLabel = "fast|default|best",
            converter = QualityName.class,
            description = "For --simplifier quadric: how much time may go into the shape of the coarse levels.")
    private Quality quality = Quality.DEFAULT;

    @Option(
            names = "--levels",
            paramLabel = "T",
            split = ",",
            description = "For --simplifier paper: thresholds of the levels, ascending. Default: .15,.3,.4")
    private List<Double> levels = List.of();

    @Option(
            names = "--keep-order",
            description = "Give back vertices, faces and corners in their order, and what no face uses. Costs bytes.")
    private boolean keepOrder;

    @Option(
            names = "--up",
            paramLabel = "y|z",
            converter = Axis.class,
            description = "The axis of the models that points up. Default: what the format says.")
    private UpAxis up = UpAxis.UNKNOWN;

    @Option(names = "--no-poster", description = "Put no poster (a small picture of the model) into the archives.")
    private boolean withoutPoster;

    /** @throws IllegalArgumentException that says what does not go together */
    EncoderSettings settings() {
        if (baseFaces < 0)
            throw new IllegalArgumentException("--base-faces is " + baseFaces + ", it cannot be negative");
        if (!levels.isEmpty() && simplifier != Simplifier.PAPER)
            throw new IllegalArgumentException("--levels goes with --simplifier paper; quadric finds its own levels");
        if (quality != Quality.DEFAULT && simplifier == Simplifier.PAPER)
            throw new IllegalArgumentException(
                    "--quality goes with --simplifier quadric; the paper's method has one way only");
        return EncoderSettings.defaults()
                .withBaseFaces(baseFaces)
                .withKeepOrder(keepOrder)
                .withSimplifier(simplifier)
                .withQuality(quality)
                .withLevels(levels)
                .withUp(up)
                .withPoster(!withoutPoster);
    }

    private static <E extends Enum<E>> E named(Class<E> kind, String text, String what) {
        for (E value : kind.getEnumConstants())
            if (value.name().toLowerCase(Locale.ROOT).equals(text)) return value;
        throw new TypeConversionException("'" + text + "' is no " + what);
    }

    /** Reads the name of a simplifier. */
    static final class SimplifierName implements ITypeConverter<Simplifier> {
        @Override
        public Simplifier convert(String text) {
            return named(Simplifier.class, text, "simplifier, use quadric or paper");
        }
    }

    /** Reads the name of a quality. */
    static final class QualityName implements ITypeConverter<Quality> {
        @Override
        public Quality convert(String text) {
            return named(Quality.class, text, "quality, use fast, default or best");
        }
    }

    /** Reads the name of an axis. */
    static final class Axis implements ITypeConverter<UpAxis> {
        @Override
        public UpAxis convert(String text) {
            if (text.equals("unknown")) throw new TypeConversionException("'unknown' is no axis, use y or z");
            return named(UpAxis.class, text, "axis that points up, use y or z");
        }
    }
}
