package org.jsmesh.app.paper;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Stream;
import org.jsmesh.app.paper.Downloads.Part;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.plan.RoundPlanner;
import org.jsmesh.session.RequestReport;
import org.jsmesh.session.SessionListener;
import org.jsmesh.session.SessionOptions;
import org.jsmesh.session.StreamingSession;

/**
 * The conversation of figure 8 of the paper: the page, the simplified mesh, patches by the measured bandwidth, and at
 * last all the rest. What was asked and answered is from the server's log, the times are those of the client.
 */
final class Conversation {
    private static final int WAIT_MILLIS = 2000;
    private static final int ROUNDS = 3;

    /** The log is written a little after the answer. */
    private static final long LOG_NANOS = 5_000_000_000L;

    private final Served served;
    private final Wire wire;
    private final Path log;
    private final ProgressListener progress;

    Conversation(Served served, Wire wire, Path folder, ProgressListener progress) {
        this.served = served;
        this.wire = wire;
        log = folder.resolve(PaperServer.LOG);
        this.progress = progress;
    }

    PaperTable record(LinkKind link) throws IOException {
        PaperTable table = new PaperTable(
                "figure8",
                "Figure 8: the conversation of client and servlet",
                "Real requests over " + wire.described(List.of(link))
                        + ". The page of the model, without its"
                        + " scripts; then the client of the viewers with a wait of " + WAIT_MILLIS
                        + " ms a round, which leaves the planning to the servlet: manifest and simplified model, "
                        + ROUNDS
                        + " rounds, and all the rest. The model is the bunny with all its "
                        + Figures.count(served.bunny().whole().faces())
                        + " faces. Method, path, range, status and bytes are from the server's log; times are the"
                        + " client's, in milliseconds from its beginning. SHA stands for the 64 digits of the"
                        + " archive's hash.",
                "It is the paper's diagram with a manifest before the simplified model, which names sizes and hashes;"
                        + " the first request for the model is for the whole batches within "
                        + Figures.count(RoundPlanner.FIRST_REQUEST_BYTES)
                        + " bytes, as nothing is known of the bandwidth; what of an answer is late belongs to the next"
                        + " round; if an answer ends within a batch, a range brings the rest of it; and the patches"
                        + " resource gets the estimate, and as the time to fill 1.2 times what is left of the wait"
                        + " after the time to the first byte, or a quarter of the wait where less is left, and 2 times"
                        + " that while the estimate is a lower bound.",
                List.of("from ms", "to ms", "method", "path", "range", "status", "bytes"));
        wire.open();
        Streams.whole(served.wholeArchive(wire));
        int before = lines().size();
        wire.shape(link);
        progress.step("figure8", 0);
        long begin = System.nanoTime();
        Downloads.fetch(List.of(Part.whole(served.wholePage(wire))), x -> {});
        double pageMillis = Figures.millisSince(begin);
        SessionOptions options = SessionOptions.defaults().withServerPlan(true);
        List<RequestReport> requests;
        try (StreamingSession session = StreamingSession.open(
                served.wholePage(wire).resolve("manifest.json"), options, SessionListener.NONE, Runnable::run)) {
            for (int i = 0; i < ROUNDS; i++) {
                progress.step("figure8", .25 + .2 * i);
                Streams.await(session.refine(WAIT_MILLIS));
            }
            Streams.await(session.complete());
            requests = session.trace().requests();
        }
        wire.open();
        List<JsonNode> answers = answers(before, requests.size() + 1);
        table.rows().add(row(0, pageMillis, answers.get(0)));
        for (int i = 0; i < requests.size(); i++) {
            RequestReport r = requests.get(i);
            table.rows().add(row(pageMillis + r.startMillis(), pageMillis + r.endMillis(), answerOf(r, answers)));
        }
        return table;
    }

    private List<String> row(double from, double to, JsonNode answer) {
        String query = text(answer, "query") == null ? "" : "?" + text(answer, "query");
        String range = text(answer, "range") == null ? Figures.NONE : text(answer, "range");
        return List.of(
                Figures.count(Math.round(from)),
                Figures.count(Math.round(to)),
                answer.path("method").asText(),
                "`" + answer.path("path").asText().replace(served.wholeSha256(), "SHA") + query + "`",
                range,
                answer.path("status").asText(),
                Figures.count(answer.path("bytes").asLong()));
    }

    /** The line of the log for a request, which is then used up. */
    private static JsonNode answerOf(RequestReport request, List<JsonNode> answers) throws IOException {
        URI address = URI.create(request.url());
        for (int i = 1; i < answers.size(); i++) {
            JsonNode answer = answers.get(i);
            if (address.getPath().equals(text(answer, "path"))
                    && Objects.equals(address.getQuery(), text(answer, "query"))
                    && Objects.equals(request.range(), text(answer, "range"))) return answers.remove(i);
        }
        throw new IOException(address + ": the server's log has no such request");
    }

    /** Null where the log has null. */
    private static String text(JsonNode answer, String name) {
        return answer.path(name).isNull() ? null : answer.path(name).asText();
    }

    private List<JsonNode> answers(int before, int count) throws IOException {
        long begin = System.nanoTime();
        while (lines().size() < before + count && System.nanoTime() - begin < LOG_NANOS)
            LockSupport.parkNanos(20_000_000);
        List<JsonNode> answers = new ArrayList<>();
        ObjectMapper mapper = new ObjectMapper();
        List<String> lines = lines();
        for (String line : lines.subList(before, lines.size())) answers.add(mapper.readTree(line));
        if (answers.isEmpty()) throw new IOException(log + ": the server has not written its log");
        return answers;
    }

    private List<String> lines() throws IOException {
        try (Stream<String> lines = Files.lines(log)) {
            return lines.toList();
        }
    }
}
