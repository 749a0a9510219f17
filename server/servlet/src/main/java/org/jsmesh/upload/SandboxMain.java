package org.jsmesh.upload;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.concurrent.ForkJoinPool;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.files.AtomicFiles;
import org.jsmesh.files.ModelFiles;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.io.ModelFormatException;

/**
 * The program that {@link SandboxEncoder} starts: model file, archive, most faces and MiB of heap are its arguments.
 * Says on its output how far it is and what is wrong.
 */
final class SandboxMain {
    static final String PROGRESS = "progress";
    static final String FAILURE = "failure";
    private static final int LONGEST_WORDS = 500;
    private static final long QUIET_NANOS = 100_000_000;

    private final PrintStream out;
    private long saidNanos = System.nanoTime() - QUIET_NANOS;

    private SandboxMain(PrintStream out) {
        this.out = out;
    }

    public static void main(String[] arguments) {
        PrintStream out = new PrintStream(System.out, true, StandardCharsets.UTF_8);
        Thread watch = new Thread(SandboxMain::endWithTheServer);
        watch.setDaemon(true);
        watch.start();
        SandboxMain child = new SandboxMain(out);
        int code =
                child.run(Path.of(arguments[0]), Path.of(arguments[1]), Integer.parseInt(arguments[2]), arguments[3]);
        Runtime.getRuntime().halt(code);
    }

    /** The input ends when the server does, however that ends. */
    private static void endWithTheServer() {
        try {
            while (System.in.read() >= 0) continue;
        } catch (IOException e) {
            // It has ended.
        }
        Runtime.getRuntime().halt(1);
    }

    private int run(Path model, Path archive, int mostFaces, String heapMegabytes) {
        try {
            say("reading", 0);
            Mesh mesh = ModelFiles.read(model).mesh();
            if (mesh.faces() > mostFaces) {
                return fail(
                        "the model has " + mesh.faces() + " faces, more than the " + mostFaces + " allowed",
                        "send a smaller model");
            }
            int threads = Math.max(1, Runtime.getRuntime().availableProcessors() / 2);
            EncoderSettings settings = EncoderSettings.defaults().withThreads(threads);
            ProgressListener progress = this::say;
            byte[] bytes = new MeshEncoder(settings, ForkJoinPool.commonPool())
                    .encode(mesh, progress)
                    .bytes();
            AtomicFiles.write(archive, bytes);
            return 0;
        } catch (ModelFormatException e) {
            String place = e.place().isEmpty() ? "" : " (" + e.place() + ")";
            return fail("the model cannot be read: " + e.reason() + place, e.remedy());
        } catch (IllegalArgumentException e) {
            return fail("the model cannot be encoded: " + e.getMessage(), "repair the model file");
        } catch (OutOfMemoryError e) {
            return fail(
                    "the model needs more memory than the " + heapMegabytes + " MiB allowed", "send a smaller model");
        } catch (StackOverflowError e) {
            return fail("the model is nested too deeply", "export it anew");
        } catch (IOException e) {
            return fail("the server could not write or read its files", "tell the server's owner");
        }
    }

    private void say(String stage, double fraction) {
        long now = System.nanoTime();
        if (now - saidNanos < QUIET_NANOS && fraction > 0) return;
        saidNanos = now;
        out.println(PROGRESS + "\t" + words(stage) + "\t" + fraction);
    }

    private int fail(String reason, String remedy) {
        out.println(FAILURE + "\t" + words(reason) + "\t" + words(remedy));
        return 1;
    }

    /** On one line, without tabs: some of it comes out of the file. */
    private static String words(String text) {
        String line = String.valueOf(text).replaceAll("\\p{Cntrl}+", " ").strip();
        return line.isEmpty() ? "-" : line.substring(0, Math.min(line.length(), LONGEST_WORDS));
    }
}
