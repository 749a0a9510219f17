package org.jsmesh.app;

import com.fasterxml.jackson.annotation.JsonPropertyOrder;
import java.util.Locale;
import java.util.function.IntToDoubleFunction;
import org.jsmesh.archive.BatchIndex;

/**
 * Bytes of an archive after which what is shown is no more than half a pixel off, by each of the errors of its index.
 *
 * @param pixels that the model's diagonal is long
 * @param meanBytes bytes after which it is off by that on average
 * @param quantileBytes bytes after which 99.9% of the surface is not off by more
 * @param boundBytes bytes after which no point is expected to be off by more
 */
@JsonPropertyOrder({"pixels", "meanBytes", "quantileBytes", "boundBytes"})
record HalfPixel(int pixels, long meanBytes, long quantileBytes, long boundBytes) {
    private static final double HALF_A_PIXEL = 50; // in % of one

    static HalfPixel of(BatchIndex index, int pixels) {
        return new HalfPixel(
                pixels,
                bytes(index, index::errorMean, pixels),
                bytes(index, index::errorQuantile, pixels),
                bytes(index, index::errorBound, pixels));
    }

    private static long bytes(BatchIndex index, IntToDoubleFunction error, int pixels) {
        return index.end(index.firstWithin(error, percent(pixels)));
    }

    /** Half a pixel in % of the diagonal. */
    static double percent(int pixels) {
        return HALF_A_PIXEL / pixels;
    }

    /** @param total bytes of the archive */
    String line(long total) {
        return String.format(
                Locale.ROOT,
                "within half a pixel, the diagonal being %d pixels long: on average after %s, 99.9%% of the surface after %s, all of it after %s",
                pixels,
                part(meanBytes, total),
                part(quantileBytes, total),
                part(boundBytes, total));
    }

    private static String part(long bytes, long total) {
        return String.format(Locale.ROOT, "%d bytes (%.2f%%)", bytes, 100.0 * bytes / total);
    }
}
