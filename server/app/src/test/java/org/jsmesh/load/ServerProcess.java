package org.jsmesh.load;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jsmesh.load.net.EventLoop;

/** {@code jsm serve} in a process of its own, which can be ended and started again at the same ports. */
final class ServerProcess implements AutoCloseable {
    private static final int LONGEST_START_SECONDS = 60;
    private static final int LONGEST_STOP_SECONDS = 60;
    private static final Pattern FULL_COLLECTION = Pattern.compile("Pause Full \\(Diagnostic.*?(\\d+)M->(\\d+)M");

    private final Path folder;
    private final Path archives;
    private final LoadSettings settings;
    private final int port = freePort();
    private final int managementPort = freePort();
    private Process process;
    private int largestFile;
    private int starts;

    /** @param folder for its logs */
    ServerProcess(Path folder, Path archives, LoadSettings settings) {
        this.folder = folder;
        this.archives = archives;
        this.settings = settings;
    }

    /** The server and what it starts can write no larger file, as if the disk were full. */
    ServerProcess withLargestFile(int kilobytes) {
        largestFile = kilobytes;
        return this;
    }

    void start() throws IOException, InterruptedException {
        starts++;
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xms" + settings.heapMegabytes() + "m",
                "-Xmx" + settings.heapMegabytes() + "m",
                // So that memory which grows is not the heap's.
                "-XX:+AlwaysPreTouch",
                "-Xlog:gc:file=" + log("gc")));
        // Surefire hides the class path of tests in a jar.
        String path = System.getProperty("surefire.test.class.path", System.getProperty("java.class.path"));
        command.addAll(List.of("-cp", path, "org.jsmesh.app.Jsm", "serve", archives.toString()));
        command.addAll(List.of("--port", "" + port, "--management-port", "" + managementPort));
        command.addAll(List.of("--cache", folder.resolve("cache").toString()));
        command.addAll(settings.serverOptions());
        if (largestFile > 0) {
            String shell = "ulimit -f " + largestFile + "; exec \"$0\" \"$@\"";
            command.addAll(0, List.of("bash", "-c", shell));
        }
        ProcessBuilder builder = new ProcessBuilder(command);
        builder.redirectErrorStream(true).redirectOutput(log("out").toFile());
        process = builder.start();
        for (int i = 0; i < LONGEST_START_SECONDS * 20; i++) {
            if (!process.isAlive()) throw new IOException("the server did not start: " + Files.readString(log("out")));
            if (isReady()) return;
            Thread.sleep(50);
        }
        throw new IOException("the server was not ready after " + LONGEST_START_SECONDS + " s");
    }

    /** Ends the server as an operator does (SIGTERM), and returns the seconds that it took. */
    double stop() throws IOException, InterruptedException {
        double begin = EventLoop.millis();
        process.destroy();
        if (!process.waitFor(LONGEST_STOP_SECONDS, TimeUnit.SECONDS)) {
            process.destroyForcibly();
            throw new IOException("the server did not end within " + LONGEST_STOP_SECONDS + " s after SIGTERM");
        }
        return (EventLoop.millis() - begin) / 1000;
    }

    /** Ends the server as a power cut does. */
    void kill() throws InterruptedException {
        process.destroyForcibly().waitFor();
    }

    private boolean isReady() {
        return !get("/health/ready").isEmpty();
    }

    /** Body of a management resource; empty when there is none. */
    private String get(String path) {
        try (var in =
                URI.create("http://127.0.0.1:" + managementPort + path).toURL().openStream()) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            return "";
        }
    }

    /** The lines of {@code /metrics}. */
    Map<String, Double> metrics() {
        Map<String, Double> values = new TreeMap<>();
        get("/metrics").lines().filter(l -> !l.startsWith("#")).forEach(line -> {
            int space = line.lastIndexOf(' ');
            if (space > 0) values.put(line.substring(0, space), Double.parseDouble(line.substring(space + 1)));
        });
        return values;
    }

    /** What is left on the heap after a full collection, in MB; −1 where the JDK's tools are missing. */
    int liveHeapMegabytes() throws IOException, InterruptedException {
        Path jcmd = Path.of(System.getProperty("java.home"), "bin", "jcmd");
        if (!Files.isExecutable(jcmd)) return -1;
        new ProcessBuilder(jcmd.toString(), "" + pid(), "GC.run")
                .redirectErrorStream(true)
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .start()
                .waitFor();
        int live = -1;
        for (String line : Files.readAllLines(log("gc"))) {
            Matcher m = FULL_COLLECTION.matcher(line);
            if (m.find()) live = Integer.parseInt(m.group(2));
        }
        return live;
    }

    /** The manifest of a model, as text. */
    String manifest(Model model) throws IOException {
        URI uri = URI.create("http://127.0.0.1:" + port + "/m/" + model.id() + "/manifest.json");
        try (var in = uri.toURL().openStream()) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    /** What the process that runs now has printed. */
    String output() throws IOException {
        return Files.readString(log("out"));
    }

    private Path log(String kind) {
        return folder.resolve("server-" + starts + "." + kind);
    }

    long pid() {
        return process.pid();
    }

    boolean isAlive() {
        return process.isAlive();
    }

    InetSocketAddress address() {
        return new InetSocketAddress("127.0.0.1", port);
    }

    private static int freePort() {
        try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getByName("127.0.0.1"))) {
            return socket.getLocalPort();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Override
    public void close() {
        if (process != null) process.destroyForcibly();
    }
}
