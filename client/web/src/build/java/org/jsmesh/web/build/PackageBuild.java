package org.jsmesh.web.build;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Makes the npm package: what others build on, as modules with plain names. three.js stays outside. Other bundlers find
 * worker and decoder by {@code new URL('./NAME', import.meta.url)}, and so does a browser.
 */
public final class PackageBuild {
    private static final Map<String, String> MODULES =
            Map.of("jsm-loader", "three/jsm-loader.js", "jsm-viewer", "viewer/jsm-viewer.js");
    private static final String PREFIX = "jsm-";
    /** What is of our own page alone. */
    private static final List<String> PAGE = List.of("page", "levels");

    private static final String WORKER = "decode/worker.js";

    /** A bundler must neither follow this nor change it: the worker stays one file. */
    private static final String SCRIPT_DECODER = "await import('../decoder/decoder.js')";

    private static final String SCRIPT_DECODER_BESIDE =
            "await import(/* @vite-ignore */ /* webpackIgnore: true */ new URL('./jsm-decoder.js', import.meta.url).href)";

    private PackageBuild() {}

    /**
     * Builds the package.
     *
     * @param args the sources, the decoder that was compiled before, a folder for intermediate files, the folder of the
     *     package, which holds {@code package.json} already, and the tarball
     * @throws IOException when a file cannot be read or written
     */
    public static void main(String[] args) throws IOException {
        Layout layout = new Layout(Path.of(args[0]), Path.of(args[1]), Path.of(args[2]), Path.of(args[3]));
        Files.createDirectories(layout.work());
        Staging staging = new Staging(layout.work().resolve("package-staging"));
        staging.fill(layout);
        for (String folder : PAGE) Folders.clear(staging.folder().resolve(folder));
        for (Path target : staging.named()) {
            String name = target.getFileName().toString();
            staging.rename(target, PREFIX + name);
            if (!name.endsWith(".js")) Files.copy(target, layout.output().resolve(PREFIX + name));
        }
        staging.replace(SCRIPT_DECODER, SCRIPT_DECODER_BESIDE);
        Files.copy(
                staging.folder().resolve("decoder/decoder.js"), layout.output().resolve(PREFIX + "decoder.js"));
        Esbuild esbuild = new Esbuild(layout.work(), staging.folder());
        esbuild.worker(PREFIX + "worker", WORKER, layout.output());
        esbuild.library(modules(staging.folder()), layout.output());
        Tarball.write(layout.output(), Path.of(args[4]));
    }

    private static Map<String, String> modules(Path sources) throws IOException {
        Map<String, String> modules = new LinkedHashMap<>();
        List<String> missing = new ArrayList<>();
        MODULES.forEach((name, source) -> {
            if (Files.exists(sources.resolve(source))) modules.put(name, source);
            else missing.add(source);
        });
        if (!missing.isEmpty()) throw new IOException("the package needs the sources " + missing);
        return modules;
    }
}
