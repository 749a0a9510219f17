package org.jsmesh.app.paper;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * Servers in a process and a network namespace of their own, behind a pair of virtual interfaces. {@code tc tbf} keeps
 * what the servers send to the rate of the link, in whole packets, and {@code tc netem} holds back what the client
 * sends for the round trip, where the kernel has it. Needs Linux, root and iproute2.
 */
final class KernelWire implements Wire {
    private static final String SPACE = "jsm-paper";
    private static final String OURS = "jsm-p-client";
    private static final String THEIRS = "jsm-p-server";
    private static final String SERVER_ADDRESS = "10.231.78.1";
    private static final String CLIENT_ADDRESS = "10.231.78.2";

    /** A bucket of 10 ms, a buffer of 200 ms, as far as they hold some packets. */
    private static final int LEAST_BURST = 3200;

    private static final int LEAST_BUFFER = 30_000;

    private final boolean hasRoundTrips;
    private final Process server;
    private final URI archives;
    private final URI text;

    KernelWire(Path folder) throws IOException {
        tidy();
        Process started = null;
        try {
            run("ip", "netns", "add", SPACE);
            run("ip", "link", "add", OURS, "type", "veth", "peer", "name", THEIRS, "netns", SPACE);
            run("ip", "-n", SPACE, "address", "add", SERVER_ADDRESS + "/24", "dev", THEIRS);
            run("ip", "-n", SPACE, "link", "set", THEIRS, "up");
            run("ip", "address", "add", CLIENT_ADDRESS + "/24", "dev", OURS);
            run("ip", "link", "set", OURS, "up");
            hasRoundTrips = quietly(delay(0));
            started = serve(folder);
            BufferedReader lines =
                    new BufferedReader(new InputStreamReader(started.getInputStream(), StandardCharsets.UTF_8));
            archives = address(lines);
            text = address(lines);
            server = started;
        } catch (IOException | RuntimeException e) {
            if (started != null) started.destroyForcibly();
            tidy();
            throw e;
        }
    }

    private static Process serve(Path folder) throws IOException {
        Path java = Path.of(System.getProperty("java.home"), "bin", "java");
        return new ProcessBuilder(
                        "ip",
                        "netns",
                        "exec",
                        SPACE,
                        java.toString(),
                        "-cp",
                        System.getProperty("java.class.path"),
                        PaperServer.class.getName(),
                        folder.toString(),
                        SERVER_ADDRESS)
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
    }

    private static URI address(BufferedReader lines) throws IOException {
        String line = lines.readLine();
        if (line == null) throw new IOException("the server in the network namespace " + SPACE + " did not start");
        return URI.create(line);
    }

    @Override
    public void shape(LinkKind link) throws IOException {
        double bytesPerSecond = link.bitsPerSecond() / 8;
        long burst = Math.max(LEAST_BURST, Math.round(bytesPerSecond / 100));
        long buffer = Math.max(LEAST_BUFFER, Math.round(bytesPerSecond / 5)) + burst;
        String rate = Math.round(link.bitsPerSecond()) + "bit";
        run(
                "tc",
                "-n",
                SPACE,
                "qdisc",
                "replace",
                "dev",
                THEIRS,
                "root",
                "tbf",
                "rate",
                rate,
                "burst",
                Long.toString(burst),
                "limit",
                Long.toString(buffer));
        if (hasRoundTrips) run(delay(link.delayMillis()));
    }

    private static String[] delay(long millis) {
        return new String[] {"tc", "qdisc", "replace", "dev", OURS, "root", "netem", "delay", millis + "ms"};
    }

    @Override
    public void open() throws IOException {
        if (hasRoundTrips) run(delay(0));
        quietly("tc", "-n", SPACE, "qdisc", "delete", "dev", THEIRS, "root");
    }

    @Override
    public URI archives() {
        return archives;
    }

    @Override
    public URI text() {
        return text;
    }

    @Override
    public long carriedBytes() throws IOException {
        return Long.parseLong(run("cat", "/sys/class/net/" + OURS + "/statistics/rx_bytes"));
    }

    @Override
    public boolean hasRoundTrips() {
        return hasRoundTrips;
    }

    @Override
    public String described() {
        return "the servers run in a network namespace of their own, tc tbf of the kernel keeps to the rate of whole"
                + " packets, and "
                + (hasRoundTrips
                        ? "tc netem holds back what the client sends for the round trip"
                        : "nothing adds to the round trip, as the kernel has no tc netem");
    }

    @Override
    public void close() throws IOException {
        try {
            server.getOutputStream().close(); // it ends with its input
            server.waitFor(10, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            server.destroyForcibly();
            tidy();
        }
    }

    private static void tidy() {
        quietly("ip", "link", "delete", OURS);
        quietly("ip", "netns", "delete", SPACE);
    }

    /** Whether a command did it; what is not there cannot be taken away. */
    private static boolean quietly(String... command) {
        try {
            run(command);
            return true;
        } catch (IOException e) {
            return false;
        }
    }

    private static String run(String... command) throws IOException {
        String said;
        try {
            Process process =
                    new ProcessBuilder(command).redirectErrorStream(true).start();
            process.getOutputStream().close();
            said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8).strip();
            if (process.waitFor() == 0) return said;
        } catch (IOException e) {
            said = String.valueOf(e.getMessage());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            said = "interrupted";
        }
        throw new IOException(String.join(" ", List.of(command)) + ": "
                + said.lines().findFirst().orElse("failed")
                + ". --tc needs Linux, root and iproute2; without --tc a proxy shapes the links");
    }
}
