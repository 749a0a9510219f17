package org.jsmesh.encode;

import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.jsmesh.bench.BenchmarkMesh;
import org.jsmesh.bench.Faces;
import org.jsmesh.collapse.CollapseMesh;
import org.jsmesh.collapse.Effort;
import org.jsmesh.collapse.QuadricSimplifier;
import org.jsmesh.collapse.SimplificationTarget;
import org.jsmesh.encode.measure.LevelMeter;
import org.jsmesh.encode.measure.StageProgress;
import org.jsmesh.encode.measure.SurfacePoints;
import org.jsmesh.encode.write.ArchiveWriter;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.ProgressListener;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/** The coding part of the encoder: from a simplified mesh to the archive's bytes, measuring the errors included. */
@State(Scope.Benchmark)
@OutputTimeUnit(TimeUnit.SECONDS)
public class CodingBenchmark {
    private static final int BASE_VERTICES = 300;

    @Param(BenchmarkMesh.GENERATED)
    public String model;

    private SimplifiedMesh simplified;
    private int[] triangles;
    private SurfacePoints surface;

    @Setup
    public void simplify() {
        Mesh mesh = BenchmarkMesh.read(model);
        CollapseMesh collapsing = new CollapseMesh(mesh);
        QuadricSimplifier.simplify(
                collapsing,
                SimplificationTarget.ofVertices(BASE_VERTICES),
                Effort.SOME,
                ProgressListener.NONE,
                Runnable::run,
                1);
        simplified = new SimplifiedMesh(collapsing);
        triangles = BenchmarkMesh.triangles(mesh);
        surface = new SurfacePoints(mesh.positions(), triangles);
        if (!Arrays.equals(write(), write())) throw new IllegalStateException("coding again gives other bytes");
    }

    @Benchmark
    public byte[] code(Faces counter) {
        counter.faces += simplified.original().faces();
        return write();
    }

    private byte[] write() {
        StageProgress stages = new StageProgress(ProgressListener.NONE);
        LevelMeter meter = new LevelMeter(simplified.original(), triangles, surface, stages);
        return new EncodedArchive(
                        new ArchiveWriter(simplified, meter).write("00".repeat(32), (done, of) -> {}), null, List.of())
                .bytes();
    }
}
