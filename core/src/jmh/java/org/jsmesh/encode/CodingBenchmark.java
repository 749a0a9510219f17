package org.jsmesh.encode;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.jsmesh.bench.BenchmarkMesh;
import org.jsmesh.bench.Faces;
import org.jsmesh.codec.lod.LodSurface;
import org.jsmesh.collapse.CollapseMesh;
import org.jsmesh.collapse.QuadricSimplifier;
import org.jsmesh.collapse.Quality;
import org.jsmesh.collapse.SimplificationTarget;
import org.jsmesh.encode.measure.LevelMeter;
import org.jsmesh.encode.measure.SurfacePoints;
import org.jsmesh.encode.write.ArchiveWriter;
import org.jsmesh.encode.write.ErrorMeter;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.ProgressListener;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/**
 * The coding part of the encoder: from a simplified mesh to the archive's bytes. The errors that decide on precision
 * are measured beforehand.
 */
@State(Scope.Benchmark)
@OutputTimeUnit(TimeUnit.SECONDS)
public class CodingBenchmark {
    private static final int BASE_VERTICES = 300;

    @Param(BenchmarkMesh.GENERATED)
    public String model;

    private SimplifiedMesh simplified;
    private final Recorder recorder = new Recorder();

    @Setup
    public void simplify() {
        Mesh mesh = BenchmarkMesh.read(model);
        CollapseMesh collapsing = new CollapseMesh(mesh);
        QuadricSimplifier.simplify(
                collapsing,
                SimplificationTarget.ofVertices(BASE_VERTICES),
                Quality.DEFAULT,
                ProgressListener.NONE,
                Runnable::run,
                1);
        simplified = new SimplifiedMesh(collapsing);
        int[] triangles = BenchmarkMesh.triangles(mesh);
        recorder.meter = new LevelMeter(mesh, triangles, new SurfacePoints(mesh.positions(), triangles));
        byte[] bytes = write(recorder);
        if (!Arrays.equals(bytes, writeAgain())) throw new IllegalStateException("coding again gives other bytes");
    }

    @Benchmark
    public byte[] code(Faces counter) {
        counter.faces += simplified.original().faces();
        return writeAgain();
    }

    private byte[] writeAgain() {
        return write(new Player(recorder));
    }

    private byte[] write(ErrorMeter meter) {
        return new ArchiveWriter(simplified, meter).write("00".repeat(32), (done, of) -> {});
    }

    /** Keeps what a meter says. */
    private static final class Recorder implements ErrorMeter {
        private final List<Sounding> soundings = new ArrayList<>();
        private final List<Double> means = new ArrayList<>();
        private LevelMeter meter;

        @Override
        public Sounding sound(LodSurface shown, boolean thorough) {
            return keep(meter.sound(shown, thorough));
        }

        @Override
        public Sounding soundMoved(LodSurface.Places places, boolean wholly) {
            return keep(meter.soundMoved(places, wholly));
        }

        private Sounding keep(Sounding sounding) {
            soundings.add(sounding);
            return sounding;
        }

        @Override
        public double mean(LodSurface exact) {
            means.add(meter.mean(exact));
            return means.get(means.size() - 1);
        }

        @Override
        public void finish() {
            meter.finish();
        }
    }

    /** Says it again. */
    private static final class Player implements ErrorMeter {
        private final Iterator<Sounding> soundings;
        private final Iterator<Double> means;

        Player(Recorder recorder) {
            soundings = recorder.soundings.iterator();
            means = recorder.means.iterator();
        }

        @Override
        public Sounding sound(LodSurface shown, boolean thorough) {
            return soundings.next();
        }

        @Override
        public Sounding soundMoved(LodSurface.Places places, boolean wholly) {
            return soundings.next();
        }

        @Override
        public double mean(LodSurface exact) {
            return means.next();
        }

        @Override
        public void finish() {
            // all is known
        }
    }
}
