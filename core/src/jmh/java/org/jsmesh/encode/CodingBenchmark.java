package org.jsmesh.encode;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.jsmesh.archive.ArchiveWriter;
import org.jsmesh.bench.BenchmarkMesh;
import org.jsmesh.bench.Faces;
import org.jsmesh.collapse.CollapseMesh;
import org.jsmesh.collapse.QuadricSimplifier;
import org.jsmesh.collapse.SimplificationTarget;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.ProgressListener;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/** The coding part of the encoder: from a simplified mesh to the archive's bytes. The errors that decide on precision are measured beforehand. */
@State(Scope.Benchmark)
@OutputTimeUnit(TimeUnit.SECONDS)
public class CodingBenchmark {
    private static final int BASE_VERTICES = 300;

    @Param(BenchmarkMesh.GENERATED)
    public String model;

    private SimplifiedMesh simplified;
    private final List<Double> errors = new ArrayList<>();

    @Setup
    public void simplify() {
        Mesh mesh = BenchmarkMesh.read(model);
        CollapseMesh collapsing = new CollapseMesh(mesh);
        QuadricSimplifier.simplify(
                collapsing, SimplificationTarget.ofVertices(BASE_VERTICES), ProgressListener.NONE, Runnable::run, 1);
        simplified = new SimplifiedMesh(collapsing);
        DistanceMeter meter = new DistanceMeter(mesh);
        byte[] bytes = write(lod -> {
            errors.add(meter.measure(lod.positions(), BenchmarkMesh.triangles(lod), lod.faces())
                    .mean());
            return errors.get(errors.size() - 1);
        });
        if (!Arrays.equals(bytes, writeAgain())) throw new IllegalStateException("coding again gives other bytes");
    }

    @Benchmark
    public byte[] code(Faces counter) {
        counter.faces += simplified.original().faces();
        return writeAgain();
    }

    private byte[] writeAgain() {
        Iterator<Double> known = errors.iterator();
        return write(lod -> known.next());
    }

    private byte[] write(ArchiveWriter.ErrorMeter meter) {
        return new ArchiveWriter(simplified, meter).write("00".repeat(32), (done, of) -> {});
    }
}
