package org.jsmesh.web.testing;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.awt.image.BufferedImage;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jsmesh.test.Requirement;

/**
 * A Firefox in a window, with a profile of its own, that draws in software; driven by the commands of WebDriver BiDi,
 * because Debian has no geckodriver. Skips the test where there is none (see {@link Requirement}).
 */
public final class Firefox implements AutoCloseable {
    private static final int PATIENCE_SECONDS = 120;
    private static final ObjectMapper JSON = new ObjectMapper();
    private static final Pattern ADDRESS = Pattern.compile("listening on (ws://\\S+)");
    private static final String PREFERENCES = """
            user_pref("webgl.force-enabled", true);
            user_pref("gfx.webrender.software", true);
            user_pref("app.normandy.enabled", false);
            user_pref("datareporting.policy.dataSubmissionEnabled", false);
            """;

    private final BlockingQueue<JsonNode> answers = new LinkedBlockingQueue<>();
    private final Process process;
    private final WebSocket socket;
    private final String context;
    private int commands;

    /** @param profile an empty folder */
    public Firefox(Path profile) throws IOException {
        Path program = Requirement.firefox();
        Requirement.display();
        Files.writeString(profile.resolve("user.js"), PREFERENCES);
        process = new ProcessBuilder(
                        program.toString(),
                        "--no-remote",
                        "--profile",
                        profile.toString(),
                        "--remote-debugging-port",
                        "0")
                .redirectErrorStream(true)
                .start();
        try {
            socket = HttpClient.newHttpClient()
                    .newWebSocketBuilder()
                    .buildAsync(URI.create(address() + "/session"), new Listener())
                    .join();
            send("session.new", Map.of("capabilities", Map.of()));
            context = send("browsingContext.getTree", Map.of())
                    .at("/contexts/0/context")
                    .asText();
        } catch (IOException | RuntimeException e) {
            process.destroyForcibly();
            throw e;
        }
    }

    /** What it says first; the rest is read and forgotten, so that it never waits for a reader. */
    private String address() throws IOException {
        BufferedReader output = process.inputReader();
        for (String line = output.readLine(); line != null; line = output.readLine()) {
            Matcher found = ADDRESS.matcher(line);
            if (!found.find()) continue;
            Thread rest = new Thread(() -> output.lines().forEach(ignored -> {}), "output of Firefox");
            rest.setDaemon(true);
            rest.start();
            return found.group(1);
        }
        throw new IOException("Firefox ended before it listened");
    }

    public void open(URI page) {
        send("browsingContext.navigate", Map.of("context", context, "url", page.toString(), "wait", "complete"));
    }

    /** Runs the body of an asynchronous function in the page and gives what it returns, as JSON. */
    public JsonNode call(String body) {
        String expression = "(async () => {" + body + "})().then((value) => JSON.stringify(value ?? null))";
        JsonNode answer = send(
                "script.evaluate",
                Map.of("expression", expression, "target", Map.of("context", context), "awaitPromise", true));
        if (!answer.path("type").asText().equals("success"))
            throw new AssertionError(
                    "in the page: " + answer.at("/exceptionDetails/text").asText());
        return read(answer.at("/result/value").asText());
    }

    /** Waits until an expression holds in the page. */
    public void await(String expression) {
        call("const end = performance.now() + 100_000;"
                + "while (!(" + expression + ")) {"
                + "  if (performance.now() > end) throw new Error('never: ' + JSON.stringify(window.jsm ?? null,"
                + " ['state', 'error', 'faces', 'bytes', 'totalBytes']));"
                + "  await new Promise((resolve) => setTimeout(resolve, 50));"
                + "}");
    }

    /** The viewer's picture alone, on a transparent background. */
    public BufferedImage snapshot(int width, int height) {
        return Browser.picture(
                call("return jsm.snapshot(" + width + ", " + height + ");").asText());
    }

    private JsonNode send(String method, Map<String, ?> parameters) {
        int id = ++commands;
        try {
            String text = JSON.writeValueAsString(Map.of("id", id, "method", method, "params", parameters));
            socket.sendText(text, true).join();
            while (true) {
                JsonNode answer = answers.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
                if (answer == null) throw new AssertionError("Firefox does not answer " + method);
                if (answer.path("id").asInt() != id) continue; // an event
                if (answer.path("type").asText().equals("error"))
                    throw new AssertionError(
                            method + ": " + answer.path("message").asText());
                return answer.path("result");
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException(e);
        }
    }

    private static JsonNode read(CharSequence text) {
        try {
            return JSON.readTree(text.toString());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Ends the browser that this one started. */
    @Override
    public void close() {
        socket.abort();
        process.descendants().forEach(ProcessHandle::destroy);
        process.destroy();
        try {
            if (!process.waitFor(20, TimeUnit.SECONDS))
                process.destroyForcibly().waitFor();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Messages may come in parts. */
    private final class Listener implements WebSocket.Listener {
        private final StringBuilder parts = new StringBuilder();

        @Override
        public CompletionStage<?> onText(WebSocket from, CharSequence data, boolean isLast) {
            parts.append(data);
            if (isLast) {
                answers.add(read(parts));
                parts.setLength(0);
            }
            from.request(1);
            return null;
        }
    }
}
