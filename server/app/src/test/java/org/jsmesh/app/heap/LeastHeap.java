package org.jsmesh.app.heap;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.memory.MemoryEstimate;

/**
 * Finds the least heap with which {@code jsm encode} encodes a model, by running it with more or less, and prints it
 * beside the estimate. It runs this Java with the serial collector and no other flag than {@code -Xmx}, so that the
 * result depends on no number of processors. Arguments: model files, then {@code --} and options of the command.
 */
final class LeastHeap {
    private static final double PROGRAM = 18e6;
    private static final int LEAST = 16; // MiB
    private static final int PART = 16; // of the result: how exact it is
    private static final String COLLECTOR = "-XX:+UseSerialGC";

    /** Of the estimate. What does not succeed with so much fails for another reason. */
    private static final int MOST = 8;

    private LeastHeap() {}

    public static void main(String[] args) throws IOException, InterruptedException {
        List<String> words = Arrays.asList(args);
        int end = words.contains("--") ? words.indexOf("--") : words.size();
        List<String> options = words.subList(Math.min(words.size(), end + 1), words.size());
        System.out.println("java " + Runtime.version() + " " + COLLECTOR + "\n");
        System.out.println("| model | faces | least heap, MiB | bytes a face beyond 18 MB | estimated, MiB |");
        System.out.println("|---|--:|--:|--:|--:|");
        for (String name : words.subList(0, end)) {
            Path model = Path.of(name);
            MemoryEstimate estimate = MemoryEstimate.of(model, EncoderSettings.defaults());
            int megabytes = least(model, options, (int) (estimate.bytes() >> 20));
            System.out.printf(
                    Locale.ROOT,
                    "| %s %s | %d | %d | %.0f | %d |%n",
                    model.getFileName(),
                    String.join(" ", options),
                    estimate.faces(),
                    megabytes,
                    (((long) megabytes << 20) - PROGRAM) / Math.max(1, estimate.faces()),
                    estimate.bytes() >> 20);
        }
    }

    private static int least(Path model, List<String> options, int estimate) throws IOException, InterruptedException {
        int little = LEAST;
        int enough = estimate + estimate / PART;
        while (!isEnough(model, options, enough)) {
            if (enough > MOST * estimate)
                throw new IllegalStateException(
                        model + " cannot be encoded with " + enough + " MiB. See what 'jsm encode' says of it");
            little = enough;
            enough *= 2;
        }
        while (enough - little > enough / PART) {
            int middle = (little + enough) / 2;
            if (isEnough(model, options, middle)) enough = middle;
            else little = middle;
        }
        return enough;
    }

    private static boolean isEnough(Path model, List<String> options, int megabytes)
            throws IOException, InterruptedException {
        Path archive = Files.createTempFile("least-heap", ".jsm");
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                COLLECTOR,
                "-Xmx" + megabytes + "m",
                "-cp",
                System.getProperty("java.class.path"),
                "org.jsmesh.app.Jsm",
                "encode",
                model.toString(),
                "-o",
                archive.toString()));
        command.addAll(options);
        try {
            Process process = new ProcessBuilder(command)
                    .redirectErrorStream(true)
                    .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                    .start();
            return process.waitFor() == 0;
        } finally {
            Files.delete(archive);
        }
    }
}
