package org.jsmesh.app.paper;

import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.atomic.AtomicInteger;
import org.jsmesh.archive.Proof;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.session.RoundReport;
import org.jsmesh.session.SessionListener;
import org.jsmesh.session.SessionOptions;
import org.jsmesh.session.SessionProgress;
import org.jsmesh.session.SessionResult;
import org.jsmesh.session.StreamingSession;

/** What the client of jSM shows of an archive, and when. */
final class Streams {
    private static final int PORTION = 4096;

    private Streams() {}

    /** A mesh that is ready to be drawn so long after the client began. */
    record Shown(double millis, int faces, int vertices) {}

    /** A round, and the vertices of the mesh at its end. */
    record Round(RoundReport report, int vertices) {}

    /** Fetches and decodes an archive. Returns the mesh after each batch; the last one is proven to be the original. */
    static List<Shown> decoded(URI archive) throws IOException {
        List<Shown> shown = new ArrayList<>();
        ArchiveDecoder decoder = new ArchiveDecoder();
        HttpClient client =
                HttpClient.newBuilder().version(HttpClient.Version.HTTP_1_1).build();
        long begin = System.nanoTime();
        try (InputStream body = client.send(
                        HttpRequest.newBuilder(archive).build(), HttpResponse.BodyHandlers.ofInputStream())
                .body()) {
            byte[] buffer = new byte[PORTION];
            int n;
            while ((n = body.read(buffer)) > 0) {
                for (int at = 0; at < n; at++) {
                    int before = decoder.batches();
                    decoder.feed(buffer, at, 1);
                    if (decoder.batches() > before && !decoder.isComplete()) shown.add(shown(begin, decoder.mesh()));
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException(archive + ": interrupted", e);
        }
        Mesh mesh = decoder.mesh();
        if (!Proof.of(decoder.header(), mesh).difference().isEmpty())
            throw new IOException(archive + ": what arrived is not the original");
        shown.add(shown(begin, mesh));
        return shown;
    }

    private static Shown shown(long begin, Mesh mesh) {
        return new Shown(Figures.millisSince(begin), mesh.faces(), mesh.vertices());
    }

    /** Fetches all with the client of the viewers. Returns the mesh that it shows first, and the last one. */
    static List<Shown> whole(URI archive) throws IOException {
        List<Shown> shown = Collections.synchronizedList(new ArrayList<>());
        long begin = System.nanoTime();
        SessionListener listener = new SessionListener() {
            @Override
            public void refined(Mesh mesh, SessionProgress progress) {
                if (shown.isEmpty()) shown.add(shown(begin, mesh));
            }
        };
        try (StreamingSession session =
                StreamingSession.open(archive, SessionOptions.defaults(), listener, Runnable::run)) {
            SessionResult result = await(session.complete());
            if (!result.identical()) throw new IOException(archive + ": what arrived is not the original");
            shown.add(shown(begin, result.mesh()));
        }
        return List.copyOf(shown);
    }

    /** One round of a new client. */
    static Round round(URI archive, int waitMillis) throws IOException {
        AtomicInteger shown = new AtomicInteger();
        AtomicInteger atEnd = new AtomicInteger();
        SessionListener listener = new SessionListener() {
            @Override
            public void refined(Mesh mesh, SessionProgress progress) {
                shown.set(mesh.vertices());
            }

            @Override
            public void roundEnded(RoundReport round) {
                atEnd.set(shown.get()); // a response goes on for a while
            }
        };
        try (StreamingSession session =
                StreamingSession.open(archive, SessionOptions.defaults(), listener, Runnable::run)) {
            RoundReport report = await(session.refine(waitMillis));
            return new Round(report, atEnd.get());
        }
    }

    static <T> T await(CompletableFuture<T> future) throws IOException {
        try {
            return future.get();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException("interrupted", e);
        } catch (ExecutionException e) {
            if (e.getCause() instanceof IOException io) throw io;
            throw new IllegalStateException(e.getCause());
        }
    }
}
