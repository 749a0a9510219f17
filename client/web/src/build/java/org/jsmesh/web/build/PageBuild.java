package org.jsmesh.web.build;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;

/**
 * Makes the page that is served of its sources: a bundle for the page, one for its worker, and the files beside them,
 * each named after its content and packed as browsers take it. Does nothing when nothing has changed since the last
 * time. The same sources give the same bytes.
 */
public final class PageBuild {
    private static final String PAGE = "page/index.html";
    private static final String MODEL = "page/viewer.js";
    private static final List<String> MODEL_FILES = List.of("decode/worker.js");

    private final Layout layout;
    private final Staging staging;
    private final HashedFiles files;
    private final Map<String, String> named = new TreeMap<>(); // served, by their sources
    private final Map<String, List<String>> later = new TreeMap<>(); // as Bundle has them

    private PageBuild(Layout layout) {
        this.layout = layout;
        staging = new Staging(layout.work().resolve("staging"));
        files = new HashedFiles(layout.viewer(), new Esbuild(layout.work(), staging.folder()));
    }

    /**
     * Builds the page.
     *
     * @param args four folders: the sources, the decoder that was compiled before, one for intermediate files, and the
     *     one that is served
     * @throws IOException when a file cannot be read or written
     */
    public static void main(String[] args) throws IOException {
        Layout layout = new Layout(Path.of(args[0]), Path.of(args[1]), Path.of(args[2]), Path.of(args[3]));
        Inputs inputs = Inputs.of(layout);
        if (inputs.areUnchanged()) {
            System.out.println("the page is up to date");
            return;
        }
        inputs.forget();
        try {
            new PageBuild(layout).run();
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
        inputs.remember();
    }

    private void run() throws IOException {
        Folders.clear(layout.viewer());
        Files.createDirectories(layout.viewer());
        staging.fill(layout);
        staging.addThree();
        Files.copy(
                staging.folder().resolve("node_modules/three/LICENSE"),
                layout.viewer().resolve("three-LICENSE.txt"));
        bundleWhatScriptsName();
        Files.writeString(layout.output().resolve("index.html"), page());
        String table = Sizes.of(layout.output(), Packing.pack(layout.output())).toTable();
        Files.writeString(layout.work().resolve("sizes.txt"), table);
        System.out.print(table);
    }

    /** Files first, then workers: a worker's name depends on the names of the files that it asks for. */
    private void bundleWhatScriptsName() throws IOException {
        List<Path> workers = new ArrayList<>();
        for (Path target : staging.named()) {
            if (target.toString().endsWith(".js")) workers.add(target);
            else rename(target, files.copy(target));
        }
        for (Path worker : workers) rename(worker, files.bundle(worker).name());
    }

    private void rename(Path target, String name) throws IOException {
        staging.rename(target, name);
        named.put(Folders.relative(staging.folder(), target), name);
    }

    /** The page with the names of its files put in, and a hint for each module that its script loads at once. */
    private String page() throws IOException {
        Path template = staging.folder().resolve(PAGE);
        List<String> modules = new ArrayList<>();
        String page = Staging.replaced(template, References.OF_PAGES, target -> "viewer/" + place(target, modules));
        StringBuilder hints = new StringBuilder();
        for (String module : modules) {
            hints.append("    <link rel=\"modulepreload\" href=\"viewer/")
                    .append(module)
                    .append("\">\n");
        }
        return page.replace("  </body>", hints + "  </body>").replace("  </head>", modelFiles() + "  </head>");
    }

    /**
     * What a page of one model asks for at once, the longest first, because browsers open six connections and let the
     * rest wait; {@code org.jsmesh.page.PageTemplate} makes hints of it.
     */
    private String modelFiles() {
        List<String> names = new ArrayList<>();
        for (String source : MODEL_FILES) if (named.containsKey(source)) names.add(named.get(source));
        names.addAll(later.getOrDefault(MODEL, List.of()));
        if (names.isEmpty()) return "";
        String paths = names.stream().map(name -> "viewer/" + name).collect(Collectors.joining(" "));
        return "    <meta name=\"jsm-model-files\" content=\"" + paths + "\">\n";
    }

    private String place(Path target, List<String> modules) {
        try {
            String name = target.toString();
            if (!name.endsWith(".js") && !name.endsWith(".css")) return files.copy(target);
            if (name.endsWith(".js")) files.shared(target, MODEL).gather(staging.folder());
            Bundle bundle = files.bundle(target);
            modules.addAll(bundle.imports());
            later.putAll(bundle.later());
            return bundle.name();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
