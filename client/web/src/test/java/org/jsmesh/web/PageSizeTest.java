package org.jsmesh.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** What a visit costs in bytes, packed by Brotli. The limits are a little above what is reached. */
class PageSizeTest {
    /** What the page of a model asks for before its first picture, itself included. */
    private static final int START = 81_900;

    /** All that a visit to any model may ask for, without decoders and what comes on a press of a button. */
    private static final int ALL = 170_000;

    /** The tools of the page, each of which comes when its button is pressed. */
    private static final Set<String> TOOLS = Set.of(
            "share",
            "screenshot",
            "rotate",
            "full-screen",
            "statistics",
            "limiter",
            "downloads",
            "unseen",
            "desktop",
            "export-worker",
            "browse",
            "browse-pages",
            "measure",
            "section",
            "annotations");

    private static final int TOOL = 4_000;

    /** The tool for levels of detail, and its worker, which decodes them. */
    private static final Set<String> LEVELS = Set.of("levels", "levels-worker");

    private static final int LEVELS_EACH = 11_000;

    /** For files of the visitor's device, and for those that somebody saves. */
    private static final Set<String> LOCAL = Set.of("picker", "open-files", "original", "workshop-worker");

    private static final int LOCAL_EACH = 7_000;

    /** What writes and encodes model files. */
    private static final int WORKSHOP = 290_000;

    /** With the first decoder in it. */
    private static final int WORKER = 58_400;

    /** The first decoder, and the whole one. */
    private static final int DECODER = 92_300;

    /** Where there is no WebAssembly, with what loads either. */
    private static final int JAVASCRIPT_DECODER = 74_600;

    private static final String FOLDER = "/META-INF/resources/jsm/";
    private static final Pattern ASKED = Pattern.compile("[\" ](viewer/[^\" ]+)");

    private static final Pattern PART = Pattern.compile("(?:from|import)\\s*\"\\./(chunk-[^\"]+)\"");

    @BeforeAll
    static void needBrotli() {
        Assumptions.assumeTrue(
                PageSizeTest.class.getResource(FOLDER + "index.html.br") != null,
                "the page was built without Brotli, which this machine lacks");
    }

    @Test
    void shouldBeginWithFewBytes() throws IOException {
        Set<String> files = new TreeSet<>(Set.of("index.html"));
        for (Matcher asked = ASKED.matcher(new String(read("index.html"), StandardCharsets.UTF_8)); asked.find(); ) {
            files.add(asked.group(1));
        }
        assertThat(files).hasSize(7); // page, style, icon, two scripts, what they share, worker
        int bytes = 0;
        for (String file : files) bytes += packed(file);
        assertThat(bytes).isBetween(50_000, START);
    }

    @Test
    void shouldNotGrow() throws Exception {
        int all = packed("index.html");
        int webAssembly = 0;
        int javaScript = 0;
        Set<String> parts = partsOfTools();
        for (String file : viewer()) {
            int bytes = packed(file);
            if (file.startsWith("viewer/workshop-") && file.endsWith(".wasm"))
                assertThat(bytes).as(file).isLessThan(WORKSHOP);
            else if (file.endsWith(".wasm")) webAssembly += bytes;
            else if (file.startsWith("viewer/decoder-")) javaScript += bytes;
            else if (file.startsWith("viewer/worker-"))
                assertThat(bytes).as(file).isBetween(40_000, WORKER);
            else if (isTool(file) || parts.contains(file))
                assertThat(bytes).as(file).isLessThan(TOOL);
            else if (LEVELS.contains(file.replaceAll("viewer/|-[^-]+$", "")))
                assertThat(bytes).as(file).isLessThan(LEVELS_EACH);
            else if (LOCAL.contains(file.replaceAll("viewer/|-[^-]+$", "")))
                assertThat(bytes).as(file).isLessThan(LOCAL_EACH);
            else if (!file.endsWith(".txt")) all += bytes;
        }
        assertThat(all).as("without decoders").isBetween(50_000, ALL);
        assertThat(javaScript).as("decoder in JavaScript").isBetween(1, JAVASCRIPT_DECODER);
        assertThat(webAssembly).as("decoder").isLessThan(DECODER);
    }

    private static boolean isTool(String file) {
        return TOOLS.contains(file.replaceAll("viewer/|-[^-]+$", ""));
    }

    /** What tools share, and nothing else asks for. */
    private static Set<String> partsOfTools() throws Exception {
        Set<String> parts = new TreeSet<>();
        Deque<String> asking = new ArrayDeque<>();
        for (String file : viewer()) {
            if (file.startsWith("viewer/chunk-")) parts.add(file);
            else if (file.endsWith(".js") && !isTool(file)) asking.add(file);
        }
        while (!asking.isEmpty()) {
            Matcher asked = PART.matcher(new String(read(asking.remove()), StandardCharsets.UTF_8));
            while (asked.find()) if (parts.remove("viewer/" + asked.group(1))) asking.add("viewer/" + asked.group(1));
        }
        return parts;
    }

    @Test
    void shouldNameFilesAfterTheirContent() throws Exception {
        assertThat(viewer())
                .filteredOn(file -> !file.endsWith(".txt"))
                .isNotEmpty()
                .allMatch(file -> file.matches("viewer/[^/]+-[A-Z2-7]{8}\\.[a-z]+"));
    }

    /** Without what is packed. */
    private static Set<String> viewer() throws IOException, URISyntaxException {
        Path folder = Path.of(PageSizeTest.class.getResource(FOLDER + "viewer").toURI());
        Set<String> names = new TreeSet<>();
        try (Stream<Path> files = Files.list(folder)) {
            files.map(file -> "viewer/" + file.getFileName())
                    .filter(name -> !name.matches(".*\\.(gz|br)"))
                    .forEach(names::add);
        }
        return names;
    }

    /** Small files are not packed. */
    private static int packed(String file) throws IOException {
        byte[] brotli = read(file + ".br");
        return brotli == null ? read(file).length : brotli.length;
    }

    private static byte[] read(String file) throws IOException {
        try (InputStream in = PageSizeTest.class.getResourceAsStream(FOLDER + file)) {
            return in == null ? null : in.readAllBytes();
        }
    }
}
