package org.jsmesh.flags;

import org.jsmesh.encode.Quality;
import org.jsmesh.encode.Simplifier;
import org.jsmesh.mesh.UpAxis;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** How the values of options that decide the bytes of archives are written. */
public final class EncodeConverters {
    private EncodeConverters() {}

    /** Reads the name of a simplifier. */
    public static final class SimplifierName implements ITypeConverter<Simplifier> {
        @Override
        public Simplifier convert(String text) {
            return switch (text) {
                case "quadric" -> Simplifier.QUADRIC;
                case "paper" -> Simplifier.PAPER;
                default -> throw new TypeConversionException("'" + text + "' is no simplifier, use quadric or paper");
            };
        }
    }

    /** Reads the name of a quality. */
    public static final class QualityName implements ITypeConverter<Quality> {
        @Override
        public Quality convert(String text) {
            return switch (text) {
                case "fast" -> Quality.FAST;
                case "default" -> Quality.DEFAULT;
                case "best" -> Quality.BEST;
                default -> throw new TypeConversionException("'" + text + "' is no quality, use fast, default or best");
            };
        }
    }

    /** Reads the name of an axis. */
    public static final class Axis implements ITypeConverter<UpAxis> {
        @Override
        public UpAxis convert(String text) {
            return switch (text) {
                case "y" -> UpAxis.Y;
                case "z" -> UpAxis.Z;
                default -> throw new TypeConversionException("'" + text + "' is no axis that points up, use y or z");
            };
        }
    }

    /** Reads {@code .25}. */
    public static final class Threshold implements ITypeConverter<Double> {
        @Override
        public Double convert(String text) {
            try {
                return Double.valueOf(text.strip());
            } catch (NumberFormatException e) {
                throw new TypeConversionException("'" + text + "' is no threshold such as .25");
            }
        }
    }
}
