package org.jsmesh.archive;

import java.util.concurrent.TimeUnit;
import org.jsmesh.bench.BenchmarkMesh;
import org.jsmesh.bench.Faces;
import org.jsmesh.mesh.MalformedStreamException;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/**
 * The two halves of decoding splits, each alone, over the finest pass, which has about a quarter of all vertices. They
 * can be told apart because connectivity asks for no position that its own pass brings.
 */
@OutputTimeUnit(TimeUnit.SECONDS)
public class FinestPassBenchmark {
    /** An archive. */
    @State(Scope.Benchmark)
    public static class Archive {
        @Param(BenchmarkMesh.GENERATED)
        public String model;

        private byte[] bytes;

        @Setup
        public void encode() throws MalformedStreamException {
            bytes = BenchmarkMesh.archive(BenchmarkMesh.read(model));
            FinestPass.check(bytes);
        }
    }

    /** The pass before its splits. */
    @State(Scope.Thread)
    public static class Coarser {
        private FinestPass pass;

        @Setup(Level.Invocation)
        public void decode(Archive archive) throws MalformedStreamException {
            pass = new FinestPass(archive.bytes);
        }
    }

    /** The pass after its splits, before their positions. */
    @State(Scope.Thread)
    public static class Split {
        private FinestPass pass;

        @Setup(Level.Invocation)
        public void decode(Archive archive) throws MalformedStreamException {
            pass = new FinestPass(archive.bytes);
            pass.applySplits();
        }
    }

    @Benchmark
    public int applySplits(Coarser state, Faces counter) throws MalformedStreamException {
        counter.faces += state.pass.faces();
        return state.pass.applySplits();
    }

    @Benchmark
    public int placeVertices(Split state, Faces counter) throws MalformedStreamException {
        counter.faces += state.pass.faces();
        return state.pass.placeVertices();
    }
}
