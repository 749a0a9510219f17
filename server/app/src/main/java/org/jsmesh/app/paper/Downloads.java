package org.jsmesh.app.paper;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.util.List;
import java.util.function.DoubleConsumer;

/** Plain downloads over HTTP/1.1, one request after the other on one connection. */
final class Downloads {
    private Downloads() {}

    /** What to ask for: an address, and a range of bytes, or null for all. */
    record Part(URI address, String range) {
        static Part whole(URI address) {
            return new Part(address, null);
        }

        /** Bytes from one on, up to and without another. */
        static Part of(URI address, long from, long to) {
            return new Part(address, "bytes=" + from + "-" + (to - 1));
        }
    }

    /**
     * What it took.
     *
     * @param millis from the first request, with its connection, to the end of the last answer
     * @param bytes of bodies
     */
    record Taken(double millis, long bytes) {}

    /** Fetches parts over a new connection. */
    static Taken fetch(List<Part> parts, DoubleConsumer progress) throws IOException {
        HttpClient client =
                HttpClient.newBuilder().version(HttpClient.Version.HTTP_1_1).build();
        long bytes = 0;
        long begin = System.nanoTime();
        for (int i = 0; i < parts.size(); i++) {
            progress.accept((double) i / parts.size());
            bytes += fetch(client, parts.get(i));
        }
        return new Taken(Figures.millisSince(begin), bytes);
    }

    private static long fetch(HttpClient client, Part part) throws IOException {
        HttpRequest.Builder request = HttpRequest.newBuilder(part.address());
        if (part.range() != null) request.header("Range", part.range());
        try {
            HttpResponse<byte[]> answer = client.send(request.build(), HttpResponse.BodyHandlers.ofByteArray());
            int expected = part.range() == null ? 200 : 206;
            if (answer.statusCode() != expected)
                throw new IOException(part.address() + ": the server answers " + answer.statusCode() + " to "
                        + (part.range() == null ? "a request" : part.range()));
            return answer.body().length;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException(part.address() + ": interrupted", e);
        }
    }
}
