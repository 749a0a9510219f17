package org.jsmesh.test;

import java.awt.GraphicsEnvironment;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.opentest4j.TestAbortedException;

/**
 * What a test needs from the machine it runs on. A test calls {@link #browser()}, {@link #firefox()},
 * {@link #display()}, {@link #nginx()}, {@link #node()}, {@link #python()}, {@link #javaws()} or {@link #xdg()} before
 * anything else: where the thing is missing the test is skipped and says so, unless the system property
 * {@code jsm.require} (a comma-separated list of {@code browser}, {@code firefox}, {@code display}, {@code nginx},
 * {@code node}, {@code python}, {@code javaws}, {@code xdg}) names it; then the test fails. The {@linkplain FastSet
 * fast set} has none of these tests.
 */
public final class Requirement {
    private static final Set<String> KNOWN =
            Set.of("browser", "firefox", "display", "nginx", "node", "python", "javaws", "xdg");

    /** Both programs of a usable Chromium. */
    public record Browser(Path chromium, Path driver) {}

    private Requirement() {}

    /** The Chromium of this machine, and the driver that belongs to it. */
    public static Browser browser() {
        leaveOutOfFastSet("browser");
        Optional<Path> chromium = onPath("chromium", "chromium-browser", "google-chrome", "google-chrome-stable");
        Optional<Path> driver = onPath("chromedriver");
        if (chromium.isEmpty() || driver.isEmpty()) {
            missing(
                    "browser",
                    "no " + (chromium.isEmpty() ? "chromium" : "chromedriver") + " on the PATH",
                    "install chromium and chromium-driver");
        }
        return new Browser(chromium.orElseThrow(), driver.orElseThrow());
    }

    /** The Firefox of this machine. */
    public static Path firefox() {
        leaveOutOfFastSet("firefox");
        Optional<Path> firefox = onPath("firefox-esr", "firefox");
        if (firefox.isEmpty()) missing("firefox", "no firefox on the PATH", "install firefox-esr");
        return firefox.orElseThrow();
    }

    /** Somewhere to open a window. */
    public static void display() {
        leaveOutOfFastSet("display");
        if (GraphicsEnvironment.isHeadless()) {
            missing("display", "no display (DISPLAY is not set)", "run under xvfb-run");
        }
    }

    /** The nginx of this machine. */
    public static Path nginx() {
        leaveOutOfFastSet("nginx");
        Optional<Path> nginx = onPath("nginx");
        if (nginx.isEmpty()) missing("nginx", "no nginx on the PATH or in /usr/sbin", "install nginx");
        return nginx.orElseThrow();
    }

    /** Node.js, beside the packages that {@code npm ci} puts into the folder of the page. */
    public static Path node() {
        leaveOutOfFastSet("node");
        Optional<Path> node = onPath("node", "nodejs");
        boolean packages = Files.isDirectory(SampleModels.project().resolve("client/web/node_modules"));
        if (node.isEmpty()) missing("node", "no node on the PATH", "install nodejs and npm");
        if (!packages) missing("node", "no client/web/node_modules", "run npm ci in client/web");
        return node.orElseThrow();
    }

    /** The Python 3 of this machine. */
    public static Path python() {
        leaveOutOfFastSet("python");
        Optional<Path> python = onPath("python3");
        if (python.isEmpty()) missing("python", "no python3 on the PATH", "install python3");
        return python.orElseThrow();
    }

    /** What starts programs that a JNLP file describes. */
    public static Path javaws() {
        leaveOutOfFastSet("javaws");
        Optional<Path> javaws = onPath("javaws");
        if (javaws.isEmpty()) missing("javaws", "no javaws on the PATH", "install icedtea-netx");
        return javaws.orElseThrow();
    }

    /** What opens an address with the program of the user's choice; beside it is what sets the choice. */
    public static Path xdg() {
        leaveOutOfFastSet("xdg");
        Optional<Path> open = onPath("xdg-open");
        if (open.isEmpty() || onPath("xdg-mime").isEmpty()) {
            missing("xdg", "no xdg-open or no xdg-mime on the PATH", "install xdg-utils");
        }
        return open.orElseThrow();
    }

    private static Optional<Path> onPath(String... names) {
        // Not on the path of ordinary users: where servers are.
        String path = Optional.ofNullable(System.getenv("PATH")).orElse("") + File.pathSeparator + "/usr/sbin";
        for (String folder : path.split(File.pathSeparator)) {
            for (String name : names) {
                for (String suffix : List.of("", ".exe")) {
                    Path program = Path.of(folder, name + suffix);
                    if (Files.isRegularFile(program) && Files.isExecutable(program)) return Optional.of(program);
                }
            }
        }
        return Optional.empty();
    }

    private static void leaveOutOfFastSet(String what) {
        if (FastSet.isOn()) skip("the fast set has no tests that need a " + what);
    }

    private static void missing(String what, String found, String remedy) {
        String message = found + ": " + remedy;
        if (required().contains(what)) {
            throw new AssertionError("this run requires a " + what + ", but there is " + message);
        }
        skip(message);
    }

    private static void skip(String message) {
        String test = StackWalker.getInstance()
                .walk(frames -> frames.filter(f -> !f.getClassName().equals(Requirement.class.getName()))
                        .findFirst()
                        .map(f -> f.getClassName() + "." + f.getMethodName())
                        .orElse("a test"));
        System.out.println("SKIPPED " + test + ": " + message);
        throw new TestAbortedException(message);
    }

    private static Set<String> required() {
        Set<String> required = new TreeSet<>();
        for (String word : System.getProperty("jsm.require", "").split(",")) {
            if (word.isBlank()) continue;
            if (!KNOWN.contains(word.strip())) {
                throw new IllegalArgumentException("jsm.require names " + word.strip() + ", known are " + KNOWN);
            }
            required.add(word.strip());
        }
        return required;
    }
}
