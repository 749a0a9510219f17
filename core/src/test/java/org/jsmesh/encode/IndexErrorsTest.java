package org.jsmesh.encode;

import org.assertj.core.api.SoftAssertions;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.encode.measure.DistanceMeter;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.ProgressListener;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Measures what every batch shows with many points, both ways, and compares the errors of the index. */
@Tag("slow")
class IndexErrorsTest {
    private static final int SAMPLES = 10_000;

    /** Of the last sweep's end, few points tell. */
    private static final double END_OF_SWEEP = 0.4; // of the error before it

    /**
     * Where a fit ends, the true error may rise a little, the more the better the fit was, until the next splits come;
     * the index, which does not, follows it.
     */
    private static final double MOST_RISE = 1.18;

    @ParameterizedTest
    @CsvSource({"40, .1, 0", "90, .02, .01", "60, .3, .002"})
    void shouldAgreeWithWhatEveryBatchShows(int side, double waves, double bumps) throws Exception {
        Mesh original = torus(side, waves, bumps);
        byte[] bytes = new MeshEncoder(EncoderSettings.defaults())
                .encode(original, ProgressListener.NONE)
                .bytes();
        ArchiveDecoder decoder = new ArchiveDecoder();
        DistanceMeter meter = new DistanceMeter(original, SAMPLES);
        SoftAssertions softly = new SoftAssertions();
        double lowest = Double.POSITIVE_INFINITY; // of the means found so far
        BatchIndex index = whole(bytes);
        double[] found = new double[index.size()];
        for (int i = 0; i < index.size(); i++) {
            decoder.feed(bytes, (int) index.offset(i), index.bytes(i));
            if (index.errorMean(i) == 0) break;
            Mesh shown = decoder.mesh();
            int[] triangles = new int[3 * shown.faces()];
            for (int c = 0; c < triangles.length; c++) triangles[c] = shown.vertex(c / 3, c % 3);
            DistanceMeter.Distance distance = meter.measure(shown.positions(), triangles, shown.faces());
            found[i] = distance.mean();
            softly.assertThat(index.errorBound(i)).as("bound of batch " + i).isGreaterThan(distance.maximum());
        }
        for (int i = 0; i < index.size(); i++) {
            if (i > 0) {
                softly.assertThat(index.errorMean(i)).isLessThanOrEqualTo(index.errorMean(i - 1));
                softly.assertThat(index.errorBound(i)).isLessThanOrEqualTo(index.errorBound(i - 1));
            }
            if (found[i] == 0) break;
            softly.assertThat(found[i]).as("error of batch " + i).isLessThan(MOST_RISE * lowest);
            lowest = Math.min(lowest, found[i]);
            boolean isEnd = index.faces(i) == original.faces() && found[i] < END_OF_SWEEP * found[firstWhole(index)];
            double tolerance = isEnd ? 1.35 : 1.12;
            softly.assertThat(index.errorMean(i))
                    .as("mean of batch " + i)
                    .isBetween(found[i] / tolerance, tolerance * found[i]);
        }
        softly.assertThat(index.size()).isGreaterThan(10);
        softly.assertAll();
    }

    private static int firstWhole(BatchIndex index) {
        int i = 0;
        while (index.faces(i) < index.faces(index.size() - 1)) i++;
        return i;
    }

    private static BatchIndex whole(byte[] bytes) throws Exception {
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(bytes, 0, bytes.length);
        return decoder.header().batches();
    }

    private static Mesh torus(int side, double waves, double bumps) {
        float[] positions = new float[3 * side * side];
        int[] corners = new int[6 * side * side];
        for (int i = 0; i < side * side; i++) {
            double u = 2 * Math.PI * (i / side) / side;
            double v = 2 * Math.PI * (i % side) / side;
            double r =
                    1 + waves * StrictMath.sin(3 * u + 2 * v) + bumps * StrictMath.sin(77 * u) * StrictMath.cos(59 * v);
            positions[3 * i] = (float) ((3 + r * StrictMath.cos(v)) * StrictMath.cos(u));
            positions[3 * i + 1] = (float) ((3 + r * StrictMath.cos(v)) * StrictMath.sin(u));
            positions[3 * i + 2] = (float) (r * StrictMath.sin(v));
            int right = i / side * side + (i + 1) % side;
            int down = (i + side) % (side * side);
            int both = (right + side) % (side * side);
            int at = 6 * i;
            for (int corner : new int[] {i, right, down, right, both, down}) corners[at++] = corner;
        }
        return new MeshBuilder().positions(positions).faceWedges(corners).build();
    }
}
