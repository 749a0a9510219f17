package org.jsmesh.app;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jsmesh.test.Requirement;

/**
 * A real nginx on 127.0.0.1 without rights, with the server block that the guide recommends. Skips the test where there
 * is none.
 */
final class Nginx implements AutoCloseable {
    private static final Pattern BLOCK = Pattern.compile("(?s)```nginx\n(.*?)```");

    private final Process process;
    private final int port;

    private Nginx(Process process, int port) {
        this.process = process;
        this.port = port;
    }

    static Nginx start(Path site, Path work) throws IOException, InterruptedException {
        return start(site, work, "", "# nothing");
    }

    /**
     * @param site folder to serve
     * @param work empty folder for its own files
     * @param more directives for the http block
     * @param without a directive to leave out of the recommended ones
     */
    static Nginx start(Path site, Path work, String more, String without) throws IOException, InterruptedException {
        Path program = Requirement.nginx();
        Files.createDirectories(work);
        int port;
        try (ServerSocket probe = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            port = probe.getLocalPort();
        }
        Files.writeString(
                work.resolve("nginx.conf"), configuration(site, port, more).replace(without, ""));
        Process process = new ProcessBuilder(
                        program.toString(), "-p", work.toString(), "-c", "nginx.conf", "-e", "error.log")
                .redirectErrorStream(true)
                .redirectOutput(work.resolve("output.log").toFile())
                .start();
        Nginx nginx = new Nginx(process, port);
        nginx.awaitAnswer(work);
        return nginx;
    }

    private static String configuration(Path site, int port, String more) throws IOException {
        Path guide = Path.of("../../docs/guide.md");
        Matcher block = BLOCK.matcher(Files.readString(guide));
        if (!block.find()) throw new IllegalStateException(guide + " has no nginx block");
        String server = block.group(1)
                .replaceFirst("listen [^;]+;", "listen 127.0.0.1:" + port + ";")
                .replaceFirst("root [^;]+;", Matcher.quoteReplacement("root \"" + site + "\";"));
        // The inner block would win.
        if (more.contains("gzip_types")) server = server.replaceFirst("gzip_types [^;]+;", "");
        return "daemon off;\nmaster_process off;\npid nginx.pid;\nevents {}\nhttp {\naccess_log access.log;\n"
                + "client_body_temp_path body; proxy_temp_path proxy; fastcgi_temp_path fastcgi; uwsgi_temp_path uwsgi; scgi_temp_path scgi;\n"
                + "types { text/html html; text/css css; text/javascript js; image/svg+xml svg; }\n" + more + "\n"
                + server + "}\n";
    }

    private void awaitAnswer(Path work) throws IOException, InterruptedException {
        for (int tries = 0; ; tries++) {
            try (Socket socket = new Socket()) {
                socket.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), port), 1000);
                return;
            } catch (IOException e) {
                if (tries == 200 || !process.isAlive()) {
                    close();
                    throw new IOException(
                            "nginx does not start: " + Files.readString(work.resolve("output.log"))
                                    + Files.readString(work.resolve("error.log")),
                            e);
                }
                Thread.sleep(50);
            }
        }
    }

    URI uri() {
        return URI.create("http://127.0.0.1:" + port + "/");
    }

    @Override
    public void close() {
        process.destroy();
        try {
            if (!process.waitFor(10, TimeUnit.SECONDS)) process.destroyForcibly();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
