package org.jsmesh.archive;

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

/** Decodes a whole archive that is there at once, without the snapshot for a viewer and without the identity hash. */
@State(Scope.Benchmark)
@OutputTimeUnit(TimeUnit.SECONDS)
public class DecodeBenchmark {
    @Param(BenchmarkMesh.GENERATED)
    public String model;

    private byte[] bare;
    private byte[] whole;

    @Setup
    public void encode() {
        bare = BenchmarkMesh.archive(BenchmarkMesh.read(model));
        whole = BenchmarkMesh.archive(BenchmarkMesh.readWhole(model));
    }

    @Benchmark
    public ArchiveDecoder decode(Faces counter) throws MalformedStreamException {
        return decode(bare, counter);
    }

    @Benchmark
    public ArchiveDecoder decodeWithAttributes(Faces counter) throws MalformedStreamException {
        return decode(whole, counter);
    }

    private static ArchiveDecoder decode(byte[] archive, Faces counter) throws MalformedStreamException {
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(archive, 0, archive.length);
        if (!decoder.isComplete()) throw new IllegalStateException(decoder.batches() + " batches");
        counter.faces += decoder.faces();
        return decoder;
    }
}
