package org.jsmesh.display;

import java.util.List;
import java.util.concurrent.TimeUnit;
import org.jsmesh.bench.BenchmarkMesh;
import org.jsmesh.bench.Faces;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/** Decodes an archive in steps of equal bytes, and brings the arrays to draw to what is there after each of them. */
@State(Scope.Benchmark)
@OutputTimeUnit(TimeUnit.SECONDS)
public class RefineBenchmark {
    private static final double CREASE = .5;

    @Param(BenchmarkMesh.GENERATED)
    public String model;

    @Param("41")
    public int steps;

    private byte[] archive;

    @Setup
    public void encode() {
        archive = BenchmarkMesh.archive(BenchmarkMesh.read(model));
    }

    @Benchmark
    public LiveMesh refine(Faces counter) throws MalformedStreamException {
        ArchiveDecoder decoder = new ArchiveDecoder();
        LiveMesh live = null;
        int from = 0;
        for (int step = 1; step <= steps; step++) {
            int to = (int) ((long) archive.length * step / steps);
            decoder.feed(archive, from, to - from);
            from = to;
            if (decoder.batches() == 0) continue;
            if (live == null) live = new LiveMesh(decoder.growing(), List.of());
            live.update(CREASE);
        }
        if (!decoder.isComplete()) throw new IllegalStateException(decoder.batches() + " batches");
        counter.faces += decoder.faces();
        return live;
    }
}
