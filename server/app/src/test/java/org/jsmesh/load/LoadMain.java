package org.jsmesh.load;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The long load test: {@code LoadMain [--viewers=500] [--seconds=600] [--seed=1] [--http2] [--json=FILE]
 * [--server=OPTIONS] MODEL...}. Exit code 1 when a condition does not hold.
 */
public final class LoadMain {
    private LoadMain() {}

    public static void main(String[] args) throws IOException, InterruptedException {
        int viewers = 500;
        double seconds = 600;
        long seed = 1;
        boolean http2 = false;
        Path json = null;
        List<String> options = List.of();
        List<Path> models = new ArrayList<>();
        for (String arg : args) {
            String value = arg.substring(arg.indexOf('=') + 1);
            if (arg.startsWith("--viewers=")) viewers = Integer.parseInt(value);
            else if (arg.startsWith("--seconds=")) seconds = Double.parseDouble(value);
            else if (arg.startsWith("--seed=")) seed = Long.parseLong(value);
            else if (arg.equals("--http2")) http2 = true;
            else if (arg.startsWith("--json=")) json = Path.of(value);
            else if (arg.startsWith("--server="))
                options = Arrays.asList(value.trim().split("\\s+"));
            else if (arg.startsWith("--")) throw new IllegalArgumentException("unknown option " + arg);
            else models.add(Path.of(arg));
        }
        if (models.isEmpty()) throw new IllegalArgumentException("name the models to encode and look at");
        LoadSettings settings = LoadSettings.soak(viewers, seconds, seed)
                .withServerOptions(options)
                .withHttp2(http2);
        Path folder = Files.createTempDirectory("jsm-load");
        LoadReport report;
        try (LoadRun run = new LoadRun(settings, models, folder)) {
            report = run.run();
        }
        report.print(new PrintWriter(System.out, true, StandardCharsets.UTF_8));
        System.out.println("Logs of the server: " + folder);
        if (json != null) Files.writeString(json, ReportJson.of(report));
        System.exit(report.holds() ? 0 : 1);
    }
}
