package org.jsmesh.web.build;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/** The bundler esbuild: a program of the machine's kind that a jar on the class path of the build carries. */
final class Esbuild {
    private static final String PLACE = "META-INF/resources/_static/%s/%s/%s";
    private static final String NOTICE = "--banner:js=/* jSM: Apache-2.0. */";
    private static final String NOTICE_WITH_THREE =
            "--banner:js=/* jSM: Apache-2.0. three.js: MIT, see three-LICENSE.txt. */";
    private static final ObjectMapper JSON = new ObjectMapper();

    private final Path work;
    private final Path sources;

    /**
     * @param work for the program and for what it tells
     * @param sources where it runs
     */
    Esbuild(Path work, Path sources) {
        this.work = work;
        this.sources = sources;
    }

    /** Bundles a script (a module, with what it imports later in files of its own) or a style sheet. */
    Bundle bundle(Path entry, Path output) throws IOException {
        String source = Folders.relative(sources, entry);
        JsonNode outputs = split(source, output);
        Map<String, List<String>> files = new TreeMap<>();
        for (Map.Entry<String, JsonNode> file : outputs.properties()) {
            String from = file.getValue().path("entryPoint").asText();
            if (!from.isEmpty()) files.put(from, atOnce(outputs, file.getKey()));
        }
        List<String> own = files.remove(source);
        if (own == null) throw new IOException("esbuild made nothing of " + source);
        return new Bundle(own.get(0), own.subList(1, own.size()), files);
    }

    /** What {@link #bundle} would make, for a first look. */
    SharedModules shared(Path entry, String later) throws IOException {
        JsonNode outputs = split(Folders.relative(sources, entry), work.resolve("look"));
        List<String> entries = new ArrayList<>();
        Set<String> atOnce = new TreeSet<>();
        for (Map.Entry<String, JsonNode> file : outputs.properties()) {
            String from = file.getValue().path("entryPoint").asText();
            if (from.endsWith(".js")) entries.add(from);
            if (from.equals(later)) atOnce.addAll(atOnce(outputs, file.getKey()));
        }
        List<String> modules = new ArrayList<>();
        for (Map.Entry<String, JsonNode> file : outputs.properties()) {
            boolean isShared = !file.getValue().has("entryPoint") && atOnce.contains(name(file.getKey()));
            if (isShared) file.getValue().path("inputs").fieldNames().forEachRemaining(modules::add);
        }
        return new SharedModules(entries, modules);
    }

    private JsonNode split(String source, Path output) throws IOException {
        Path report = work.resolve("bundle.json");
        run(
                output,
                source,
                "--splitting",
                "--minify",
                NOTICE_WITH_THREE,
                "--entry-names=[name]-[hash]",
                "--chunk-names=[name]-[hash]",
                "--asset-names=[name]-[hash]",
                "--loader:.svg=file",
                "--metafile=" + report);
        return JSON.readTree(report.toFile()).path("outputs");
    }

    /**
     * Bundles modules for other bundlers: what they share is in files beside them, and three.js is left to them.
     *
     * @param entries sources by the names of the modules
     */
    void library(Map<String, String> entries, Path output) throws IOException {
        List<String> options = new ArrayList<>(List.of(
                NOTICE, "--splitting", "--chunk-names=[name]-[hash]", "--external:three", "--external:three/*"));
        entries.forEach((name, source) -> options.add(name + "=" + source));
        run(output, options.toArray(String[]::new));
    }

    /** Bundles a script that stays one file. */
    void worker(String name, String source, Path output) throws IOException {
        run(output, NOTICE, name + "=" + source, "--minify-syntax", "--minify-identifiers");
    }

    /** The name of a file and of those that it imports at once, and so on. */
    private static List<String> atOnce(JsonNode outputs, String file) {
        List<String> all = new ArrayList<>(List.of(name(file)));
        collect(outputs, file, all);
        return all;
    }

    private static void collect(JsonNode outputs, String file, List<String> found) {
        for (JsonNode imported : outputs.path(file).path("imports")) {
            String path = imported.path("path").asText();
            if (!imported.path("kind").asText().equals("import-statement") || found.contains(name(path))) continue;
            found.add(name(path));
            collect(outputs, path, found);
        }
    }

    private static String name(String path) {
        return path.substring(path.lastIndexOf('/') + 1);
    }

    private void run(Path output, String... options) throws IOException {
        List<String> command = new ArrayList<>(List.of(
                program().toString(),
                "--bundle",
                "--format=esm",
                "--target=es2022",
                "--charset=utf8",
                "--legal-comments=none",
                "--log-level=warning",
                "--outdir=" + output));
        command.addAll(List.of(options));
        Process process = new ProcessBuilder(command)
                .directory(sources.toFile())
                .redirectErrorStream(true)
                .start();
        process.getOutputStream().close();
        String said = new String(process.getInputStream().readAllBytes());
        try {
            if (process.waitFor() != 0) throw new IOException("esbuild failed:\n" + said);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException(e);
        }
        System.out.print(said);
    }

    private Path program() throws IOException {
        String platform = System.getProperty("esbuild.platform");
        String version = System.getProperty("esbuild.version");
        Path program = work.resolve("esbuild-" + version + ".exe");
        if (Files.exists(program)) return program;
        for (String name : List.of("bin/esbuild", "esbuild.exe")) {
            try (InputStream in =
                    Esbuild.class.getClassLoader().getResourceAsStream(PLACE.formatted(platform, version, name))) {
                if (in == null) continue;
                Path whole = work.resolve("esbuild.part");
                Files.copy(in, whole, StandardCopyOption.REPLACE_EXISTING);
                if (!whole.toFile().setExecutable(true)) throw new IOException(whole + " cannot be made executable");
                return Files.move(whole, program);
            }
        }
        throw new IOException("there is no esbuild for " + platform + " on the class path of the build");
    }
}
