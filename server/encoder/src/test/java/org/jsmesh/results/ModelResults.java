package org.jsmesh.results;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ForkJoinPool;
import java.util.stream.Stream;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.BatchKind;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.encode.measure.DistanceMeter;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshCleaner;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.test.results.ResultColumn;
import org.jsmesh.test.results.ResultTable;

/**
 * Figures of one model: those of {@code docs/benchmarks.md}, of positions and faces alone, but for the bytes with
 * attributes.
 */
final class ModelResults {
    private static final int STAGE_BITS = 14;
    private static final int[] PERCENTS = {1, 5, 10, 25, 50};

    /** Distances in % of the diagonal that nobody can tell from none. */
    private static final double NO_DISTANCE = 1e-5;

    private static final List<BatchKind> PICTURES = List.of(BatchKind.TEXTURE, BatchKind.PREVIEW, BatchKind.POSTER);

    private final Mesh whole;
    private final Mesh bare;

    ModelResults(Mesh model) {
        whole = MeshCleaner.clean(model, new ArrayList<>());
        bare = MeshCleaner.clean(bare(whole), new ArrayList<>());
    }

    static ResultTable table() {
        Stream<ResultColumn> bytes =
                Stream.of(ResultColumn.given("reference"), small("stage"), small("whole"), small("attributed"));
        List<ResultColumn> errors = new ArrayList<>();
        for (int percent : PERCENTS) errors.add(ResultColumn.small("at " + percent + "%", NO_DISTANCE));
        Stream<ResultColumn> work = Stream.of(ResultColumn.same("levels"), small("decisions"));
        return new ResultTable(
                "model", Stream.of(bytes, errors.stream(), work).flatMap(s -> s).toList());
    }

    private static ResultColumn small(String name) {
        return ResultColumn.small(name);
    }

    /**
     * Measures.
     *
     * @param counter may serve several models
     * @param recorded the row as it is recorded, from which the reference is taken; null for none: then it is the stage
     */
    double[] measure(DecisionCounter counter, double[] recorded) {
        EncodedArchive archive = encode(bare);
        double stage = stage(archive.header().batches(), bare.faces());
        double reference = recorded == null ? stage : recorded[0];
        List<Double> figures = new ArrayList<>(List.of(reference, stage, (double) archive.bytes().length));
        figures.add(hasAttributes() ? attributed() : Double.NaN);
        DistanceMeter meter = new DistanceMeter(bare);
        for (int percent : PERCENTS) figures.add(error(meter, archive, (long) (reference * percent / 100)));
        figures.add((double) archive.header().levels().size());
        figures.add((double) counter.count(archive.bytes()) / bare.vertices());
        return figures.stream().mapToDouble(x -> x).toArray();
    }

    /**
     * The archive of positions and faces alone.
     *
     * @param end bytes of the stage
     */
    record Staged(byte[] archive, int end, int vertices) {}

    Staged staged() {
        EncodedArchive archive = encode(bare);
        int end = (int) stage(archive.header().batches(), bare.faces());
        return new Staged(archive.bytes(), end, bare.vertices());
    }

    private static EncodedArchive encode(Mesh mesh) {
        EncoderSettings settings = EncoderSettings.defaults()
                .withPoster(false)
                .withThreads(Runtime.getRuntime().availableProcessors());
        return new MeshEncoder(settings, ForkJoinPool.commonPool()).encode(mesh, ProgressListener.NONE);
    }

    /** Bytes to the first batch after which all faces are there with all positions known well. */
    private static double stage(BatchIndex index, int faces) {
        int batch = 0;
        while (index.faces(batch) < faces || index.precisionBits(batch) < STAGE_BITS) batch++;
        return index.end(batch);
    }

    private boolean hasAttributes() {
        return !whole.channels().isEmpty()
                || !whole.faceChannels().isEmpty()
                || whole.materials().size() > 1;
    }

    /** Bytes without images, which are as large in every format. */
    private double attributed() {
        BatchIndex index = encode(whole).header().batches();
        long bytes = 0;
        for (int i = 0; i < index.size(); i++) if (!PICTURES.contains(index.kind(i))) bytes += index.bytes(i);
        return bytes;
    }

    private double error(DistanceMeter meter, EncodedArchive archive, long bytes) {
        Mesh shown = archive.header().batches().end(0) <= bytes ? prefix(archive.bytes(), bytes) : middle();
        return meter.mean(shown.positions(), corners(shown), shown.faces());
    }

    private static Mesh prefix(byte[] archive, long bytes) {
        try {

            ArchiveDecoder decoder = new ArchiveDecoder();
            decoder.feed(archive, 0, (int) Math.min(bytes, archive.length));
            return decoder.mesh();
        } catch (MalformedStreamException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Nothing shown counts as one point in the middle. */
    private Mesh middle() {
        float[] b = bare.bounds();
        float[] centre = {(b[0] + b[3]) / 2, (b[1] + b[4]) / 2, (b[2] + b[5]) / 2};
        return new MeshBuilder().positions(centre).faceWedges(new int[3]).build();
    }

    private static Mesh bare(Mesh mesh) {
        return new MeshBuilder()
                .positions(mesh.positions())
                .faceWedges(corners(mesh))
                .build();
    }

    private static int[] corners(Mesh mesh) {
        int[] corners = mesh.faceWedges().clone();
        for (int i = 0; i < corners.length; i++) corners[i] = mesh.wedgeVertices()[corners[i]];
        return corners;
    }
}
