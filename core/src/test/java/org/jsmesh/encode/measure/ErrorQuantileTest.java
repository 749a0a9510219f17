package org.jsmesh.encode.measure;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.assertj.core.api.SoftAssertions;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.BatchKind;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.io.ModelReader;
import org.jsmesh.mesh.io.ResourceResolver;
import org.jsmesh.test.SampleModels;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Measures batches with 100,000 points of either surface and compares the quantiles of the index. */
@Tag("slow")
class ErrorQuantileTest {
    private static final int POINTS = 100_000;

    /** The index may say less than the truth by this factor, in a model with few faces and so few points. */
    private static final double LOW = 0.7;

    private static final double HIGH = 1.6;

    /** Within sweeps it keeps what was true before. */
    private static final double HIGH_IN_SWEEP = 3;

    @Test
    void shouldTellWhereNearlyAllOfAGearIs() throws Exception {
        check("planetary-gear.obj", 9);
    }

    @Test
    @Tag("long")
    void shouldTellWhereNearlyAllOfAnOctopusIs() throws Exception {
        check("octopus.ply", 12);
    }

    private static void check(String model, int every) throws Exception {
        Path file = SampleModels.project().resolve("models").resolve(model);
        Mesh original = ModelReader.read(file.toString(), Files.readAllBytes(file), ResourceResolver.NONE)
                .mesh();
        byte[] bytes = new MeshEncoder(EncoderSettings.defaults())
                .encode(original, ProgressListener.NONE)
                .bytes();
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(bytes, 0, bytes.length);
        BatchIndex index = decoder.header().batches();
        TriangleTree whole = tree(original);
        double[] points = whole.surface().strew(POINTS);
        double percent = 100 / diagonal(original.bounds());
        decoder = new ArchiveDecoder();
        SoftAssertions softly = new SoftAssertions();
        int measured = 0;
        for (int i = 0; i < index.size() && index.errorMean(i) > 0; i++) {
            decoder.feed(bytes, (int) index.offset(i), index.bytes(i));
            softly.assertThat(index.errorQuantile(i))
                    .as("quantile of batch " + i)
                    .isBetween(index.errorMean(i), index.errorBound(i))
                    .isLessThanOrEqualTo(i == 0 ? 100 : index.errorQuantile(i - 1));
            if (i % every != 0) continue;
            TriangleTree shown = tree(decoder.mesh());
            double there = quantile(shown, points);
            double back = quantile(whole, shown.surface().strew(POINTS));
            double found = Math.max(there, back) * percent;
            boolean sweeps = index.kind(i) != BatchKind.SPLITS;
            softly.assertThat(index.errorQuantile(i) / found)
                    .as("quantile of batch " + i + ", " + index.kind(i))
                    .isBetween(LOW, sweeps ? HIGH_IN_SWEEP : HIGH);
            measured++;
        }
        softly.assertThat(measured).isGreaterThan(4);
        softly.assertThat(index.errorQuantile(index.size() - 1)).isZero();
        softly.assertAll();
        assertThat(index.firstWithin(index::errorQuantile, 0.05))
                .isBetween(
                        index.firstWithin(index::errorMean, 0.05) + 1, index.firstWithin(index::errorBound, 0.05) - 1);
    }

    private static double quantile(TriangleTree surface, double[] points) {
        TriangleTree.Cursor cursor = new TriangleTree.Cursor(surface);
        double[] squares = new double[points.length / 3];
        for (int i = 0; i < squares.length; i++)
            squares[i] = cursor.squaredDistance(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
        Arrays.sort(squares);
        return Math.sqrt(squares[(int) (BatchIndex.QUANTILE * squares.length)]);
    }

    private static TriangleTree tree(Mesh mesh) {
        int[] triangles = new int[3 * mesh.faces()];
        for (int i = 0; i < triangles.length; i++) triangles[i] = mesh.vertex(i / 3, i % 3);
        return new TriangleTree(mesh.positions(), triangles, mesh.faces());
    }

    private static double diagonal(float[] bounds) {
        double squares = 0;
        for (int a = 0; a < 3; a++) squares += Math.pow((double) bounds[a + 3] - bounds[a], 2);
        return Math.sqrt(squares);
    }
}
