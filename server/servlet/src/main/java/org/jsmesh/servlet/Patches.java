package org.jsmesh.servlet;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.regex.Pattern;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.plan.BatchPlanner;
import org.jsmesh.servlet.http.Answer;
import org.jsmesh.store.ServedArchive;

/**
 * The paper's flow control (section 5.2). The client tells the throughput that it measured and the time that its user
 * is ready to wait. The server sends as many patches as fit. The client measures that response, forms a new estimate
 * from it and the previous one, and sends it with the next request. The server keeps nothing about a client.
 */
final class Patches {
    private static final String REMEDY =
            "ask with from (batches you hold), bytesPerSecond (your estimate) and waitMillis (the time to fill), whole numbers ≥ 0";
    private static final Pattern NUMBER = Pattern.compile("\\d{1,18}");

    private final ArchiveResponse bytes;

    Patches(ArchiveResponse bytes) {
        this.bytes = bytes;
    }

    void send(HttpServletRequest request, HttpServletResponse response, ServedArchive archive) throws IOException {
        BatchIndex index = archive.batches();
        long from = number(request, "from");
        long bytesPerSecond = number(request, "bytesPerSecond");
        long waitMillis = number(request, "waitMillis");
        if (from < 0 || bytesPerSecond < 0 || waitMillis < 0) {
            String reason = "from, bytesPerSecond or waitMillis is missing or no number";
            Answer.error(request, response, HttpServletResponse.SC_BAD_REQUEST, reason, REMEDY);
            return;
        }
        if (from > index.size()) {
            String reason = "from=" + from + ": the archive has " + index.size() + " batches";
            Answer.error(request, response, HttpServletResponse.SC_BAD_REQUEST, reason, REMEDY);
            return;
        }
        response.setHeader("Cache-Control", "no-store, no-transform");
        int first = (int) from;
        int end = BatchPlanner.plan(index, first, bytesPerSecond, waitMillis);
        if (end == first) {
            response.setStatus(HttpServletResponse.SC_NO_CONTENT);
            return;
        }
        response.setHeader("Content-Location", "batches/" + first + "-" + (end - 1));
        bytes.send(request, response, archive, index.offset(first), index.end(end - 1) - index.offset(first));
    }

    private static long number(HttpServletRequest request, String name) {
        String value = request.getParameter(name);
        return value != null && NUMBER.matcher(value).matches() ? Long.parseLong(value) : -1;
    }
}
