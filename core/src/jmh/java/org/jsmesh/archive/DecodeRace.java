package org.jsmesh.archive;

import com.openize.drako.Draco;
import com.openize.drako.DracoMesh;
import com.openize.drako.DrakoException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Locale;
import org.jsmesh.bench.BenchmarkMesh;
import org.jsmesh.bench.Benchmarks;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;

/**
 * jSM and Draco in Java decode the same model by turns in one JVM: CPU time of the thread, the best of many rounds,
 * which holds still where other work makes JMH's clock useless.
 */
public final class DecodeRace {
    private static final int ROUNDS = 40;
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private DecodeRace() {}

    public static void main(String[] args) throws DrakoException, MalformedStreamException {
        System.out.println("Million faces/s of CPU time\n\n| model | jSM | Draco in Java, 14 bits | ratio |");
        System.out.println("|---|---:|---:|---:|");
        for (String model : Benchmarks.models()) {
            Mesh mesh = BenchmarkMesh.read(model);
            byte[] archive = BenchmarkMesh.archive(mesh);
            byte[] draco = DracoBenchmark.encode(mesh);
            double ours = Double.POSITIVE_INFINITY;
            double theirs = Double.POSITIVE_INFINITY;
            for (int i = 0; i < ROUNDS; i++) {
                long begin = THREADS.getCurrentThreadCpuTime();
                int faces = decode(archive);
                long middle = THREADS.getCurrentThreadCpuTime();
                int dracoFaces = ((DracoMesh) Draco.decode(draco)).getNumFaces();
                long end = THREADS.getCurrentThreadCpuTime();
                if (faces != mesh.faces() || dracoFaces == 0)
                    throw new IllegalStateException(faces + " and " + dracoFaces + " faces of " + mesh.faces());
                ours = Math.min(ours, (middle - begin) / 1e3 / mesh.faces());
                theirs = Math.min(theirs, (end - middle) / 1e3 / mesh.faces());
            }
            System.out.printf(Locale.ROOT, "| %s | %.2f | %.2f | %.3f |%n", model, 1 / ours, 1 / theirs, theirs / ours);
        }
    }

    private static int decode(byte[] archive) throws MalformedStreamException {
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(archive, 0, archive.length);
        return decoder.faces();
    }
}
