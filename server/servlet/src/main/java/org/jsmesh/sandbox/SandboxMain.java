package org.jsmesh.sandbox;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.files.AtomicFiles;
import org.jsmesh.files.Explanation;
import org.jsmesh.files.ModelEncoding;
import org.jsmesh.files.ModelInputs;

/**
 * The program that {@link SandboxEncoder} starts: model file, archive, report of what was read, most faces, most
 * unpacked bytes and threads are its arguments. It reports progress and errors on its output.
 */
final class SandboxMain {
    static final String PROGRESS = "progress";
    static final String FAILURE = "failure";
    static final String NO_ROOM = "no-room";
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
        ModelEncoding encoding = new ModelEncoding(
                        EncoderSettings.defaults().withThreads(Integer.parseInt(arguments[5])))
                .withMostFaces(Integer.parseInt(arguments[3]))
                .withMostBytes(Long.parseLong(arguments[4]));
        int code = child.run(encoding, Path.of(arguments[0]), Path.of(arguments[1]), Path.of(arguments[2]));
        Runtime.getRuntime().halt(code);
    }

    /** The input ends with the server, however the server ends. */
    private static void endWithTheServer() {
        try {
            while (System.in.read() >= 0) continue;
        } catch (IOException e) {
            // It has ended.
        }
        Runtime.getRuntime().halt(1);
    }

    private int run(ModelEncoding encoding, Path model, Path archive, Path report) {
        try {
            ModelInputs inputs = new ModelInputs();
            EncodedArchive encoded = encoding.encode(model, inputs, this::say);
            say("writing", 0);
            try {
                AtomicFiles.write(archive, encoded::writeTo);
                AtomicFiles.write(report, inputs.toJson().getBytes(StandardCharsets.UTF_8));
                return 0;
            } catch (IOException e) {
                out.println(NO_ROOM + "\t" + words(e.toString()) + "\t-");
                return 1;
            }
        } catch (IOException | RuntimeException | OutOfMemoryError | StackOverflowError e) {
            Explanation words = Explanation.of("the model", e, Explanation.Audience.SENDER);
            out.println(FAILURE + "\t" + words(words.sentence()) + "\t" + words(words.remedy()));
            return 1;
        }
    }

    private void say(String stage, double fraction) {
        long now = System.nanoTime();
        if (now - saidNanos < QUIET_NANOS && fraction > 0) return;
        saidNanos = now;
        out.println(PROGRESS + "\t" + words(stage) + "\t" + fraction);
    }

    /** On one line, without tabs, because some of it comes from the file. */
    private static String words(String text) {
        String line = String.valueOf(text).replaceAll("\\p{Cntrl}+", " ").strip();
        return line.isEmpty() ? "-" : line.substring(0, Math.min(line.length(), LONGEST_WORDS));
    }
}
