package org.jsmesh.desktop.draw;

import com.jogamp.opengl.GL3;
import com.jogamp.opengl.GLDrawableFactory;
import com.jogamp.opengl.GLOffscreenAutoDrawable;
import com.jogamp.opengl.GLProfile;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.session.MeshStep;
import org.jsmesh.session.SessionListener;
import org.jsmesh.session.SessionOptions;
import org.jsmesh.session.StreamingSession;

/**
 * What it costs the thread that draws when a model streams in: {@code StreamBenchmark MODEL.jsm [WIDTH HEIGHT [MiB]]}
 * streams an archive through session and renderer, with a frame each 60th of a second, and prints processor times of
 * that thread. The calls that draw are counted apart, because Mesa draws with the processor.
 */
public final class StreamBenchmark {
    private static final int FRAME_MILLIS = 16;
    private static final int MESH_MILLIS = 60;

    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    private final ConcurrentLinkedQueue<SceneStep> arrived = new ConcurrentLinkedQueue<>();
    private final LiveScene live = new LiveScene();
    private final int width;
    private final int height;
    private final long slice;
    private volatile Framing framing;
    private double[] updates = new double[1 << 16];
    private double[] draws = new double[1 << 16];
    private int frames;
    private int pictures;
    private int steps;
    private long bytes;

    private StreamBenchmark(int width, int height, long slice) {
        this.width = width;
        this.height = height;
        this.slice = slice;
    }

    /** @param args the archive; width and height of the picture; most MiB that a frame brings to the graphics card */
    public static void main(String[] args) throws Exception {
        if (args.length != 1 && args.length != 3 && args.length != 4) {
            System.err.println("usage: StreamBenchmark MODEL.jsm [WIDTH HEIGHT [MiB]]");
            System.exit(2);
        }
        int width = args.length > 1 ? Integer.parseInt(args[1]) : 1280;
        int height = args.length > 1 ? Integer.parseInt(args[2]) : 800;
        double most = args.length > 3 ? Double.parseDouble(args[3]) : 2;
        new StreamBenchmark(width, height, (long) (most * (1 << 20))).run(Path.of(args[0]));
    }

    private void run(Path model) throws Exception {
        ExecutorService viewing = Executors.newSingleThreadExecutor();
        GLProfile profile = GLProfile.get(GLProfile.GL3);
        GLOffscreenAutoDrawable drawable = GLDrawableFactory.getFactory(profile)
                .createOffscreenAutoDrawable(null, Screenshot.capabilities(profile), null, width, height);
        drawable.display();
        drawable.getContext().makeCurrent();
        GL3 gl = drawable.getContext().getGL().getGL3();
        long began = threads.getCurrentThreadCpuTime();
        SceneRenderer renderer = new SceneRenderer(gl, live);
        System.out.printf(
                "%s%nstart %.1f ms%n",
                gl.glGetString(GL3.GL_RENDERER), millis(threads.getCurrentThreadCpuTime() - began));
        long start = System.nanoTime();
        SessionOptions options = SessionOptions.defaults().withMeshMillis(MESH_MILLIS);
        try (StreamingSession session = StreamingSession.open(model, options, new Listener(), viewing)) {
            CompletableFuture<?> all = session.complete().thenRunAsync(() -> {}, viewing);
            while (!all.isDone() || !arrived.isEmpty() || !live.isResting()) frame(gl, renderer);
            all.join();
        }
        System.out.printf(
                "%d steps, %.0f MB, %.1f s, %d frames with changes, %d pictures%n",
                steps, bytes / 1e6, (System.nanoTime() - start) / 1e9, frames, pictures);
        print("update", Arrays.copyOf(updates, frames));
        print("draw", Arrays.copyOf(draws, pictures));
        viewing.shutdown();
        drawable.getContext().release();
        drawable.destroy();
    }

    private void frame(GL3 gl, SceneRenderer renderer) throws InterruptedException {
        long wall = System.nanoTime();
        long before = threads.getCurrentThreadCpuTime();
        for (SceneStep step = arrived.poll(); step != null; step = arrived.poll()) {
            live.take(step);
            steps++;
            bytes += step.live().bytes();
        }
        boolean isBusy = !live.isResting();
        boolean isOther = renderer.advance(gl, slice);
        gl.glFlush();
        long after = threads.getCurrentThreadCpuTime();
        if (isBusy) {
            if (frames == updates.length) updates = Arrays.copyOf(updates, 2 * frames);
            updates[frames++] = millis(after - before);
        }
        if (isOther) {
            renderer.draw(gl, Camera.framing(framing, width, height), width, height, true, DrawStyle.defaults());
            gl.glFinish();
            if (pictures == draws.length) draws = Arrays.copyOf(draws, 2 * pictures);
            draws[pictures++] = millis(threads.getCurrentThreadCpuTime() - after);
        }
        long left = FRAME_MILLIS - (System.nanoTime() - wall) / 1_000_000;
        if (left > 0) Thread.sleep(left);
    }

    private static double millis(long nanos) {
        return nanos / 1e6;
    }

    private static void print(String what, double[] times) {
        Arrays.sort(times);
        long over = Arrays.stream(times).filter(t -> t > FRAME_MILLIS).count();
        System.out.printf(
                "%s, CPU ms: 50%% %.2f, 95%% %.2f, most %.2f, over %d ms: %d%n",
                what, at(times, .5), at(times, .95), at(times, 1), FRAME_MILLIS, over);
    }

    private static double at(double[] sorted, double share) {
        return sorted.length == 0 ? 0 : sorted[Math.min(sorted.length - 1, (int) (share * sorted.length))];
    }

    private final class Listener implements SessionListener {
        private LiveScenes scenes;

        @Override
        public boolean isLive() {
            return true;
        }

        @Override
        public void opened(ArchiveHeader header) {
            framing = Framing.of(header.bounds(), header.up());
            scenes = new LiveScenes(header, framing, new TextureImages());
        }

        @Override
        public void stepped(MeshStep step) {
            arrived.add(scenes.next(step));
        }
    }
}
