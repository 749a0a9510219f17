package org.jsmesh.load;

import java.net.InetSocketAddress;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jsmesh.load.net.RequestHead;
import org.jsmesh.load.net.ResponseHead;
import org.jsmesh.plan.BatchRequest;

/** One request of a viewer, and what its answer must be. */
final class ViewerRequest {
    private static final Pattern CONTENT_RANGE = Pattern.compile("bytes (\\d+)-(\\d+)/(\\d+)");

    private final String target;
    private final Map<String, String> fields;
    private final boolean manifest;
    private final boolean planned;
    private final long end;
    private long place;
    private long answerEnd;
    private boolean accepted;

    private ViewerRequest(
            String target, Map<String, String> fields, boolean manifest, boolean planned, long place, long end) {
        this.target = target;
        this.fields = fields;
        this.manifest = manifest;
        this.planned = planned;
        this.place = place;
        this.end = end;
        answerEnd = end;
    }

    static ViewerRequest manifest(Model model) {
        return new ViewerRequest(
                "/m/" + model.id() + "/manifest.json", Map.of("Accept", "application/json"), true, false, 0, 0);
    }

    /** A range of the archive; or, where batches begin and the server shall plan, whole batches. */
    static ViewerRequest bytes(Model model, BatchRequest next, boolean serverPlan) {
        String archive = "/m/" + model.id() + "/" + model.sha256();
        int batch = next.fromBatch();
        if (serverPlan && batch > 0 && model.index().offset(batch) == next.fromByte()) {
            String query =
                    "?from=" + batch + "&bytesPerSecond=" + next.bytesPerSecond() + "&waitMillis=" + next.waitMillis();
            return new ViewerRequest(
                    archive + "/patches" + query, Map.of(), false, true, next.fromByte(), next.endByte());
        }
        String range = "bytes=" + next.fromByte() + "-" + (next.endByte() - 1);
        Map<String, String> fields = next.fromByte() == 0
                ? Map.of("Range", range)
                : Map.of("Range", range, "If-Range", '"' + model.sha256() + '"');
        long end = Math.min(next.endByte(), model.bytes().length);
        return new ViewerRequest(archive + ".jsm", fields, false, false, next.fromByte(), end);
    }

    RequestHead head(InetSocketAddress host) {
        return new RequestHead("127.0.0.1:" + host.getPort(), target, fields);
    }

    boolean isManifest() {
        return manifest;
    }

    /** Whether the body belongs to the archive. */
    boolean takesBody() {
        return accepted && !manifest;
    }

    /** Place in the archive of the next byte of the body. */
    long place() {
        return place;
    }

    void advance(int bytes) {
        place += bytes;
    }

    long bytesLeft() {
        return answerEnd - place;
    }

    /** What is wrong with an answer, or null. */
    String check(ResponseHead head, Model model) {
        accepted = true;
        if (manifest || planned) {
            if (head.status() != 200) return target + " was answered " + head.status();
            answerEnd = place + head.length();
            if (planned && answerEnd != end) return "the server planned up to byte " + answerEnd + ", not " + end;
            return null;
        }
        if (head.status() != 206) return target + " was answered " + head.status();
        if (!head.field("ETag").equals('"' + model.sha256() + '"')) return "the ETag is " + head.field("ETag");
        Matcher m = CONTENT_RANGE.matcher(head.field("Content-Range"));
        if (!m.matches() || Long.parseLong(m.group(1)) != place || Long.parseLong(m.group(2)) != end - 1)
            return "asked for " + place + " to " + (end - 1) + ", the server sent " + head.field("Content-Range");
        if (Long.parseLong(m.group(3)) != model.bytes().length || head.length() != end - place)
            return "lengths differ: " + head.field("Content-Range") + ", Content-Length " + head.length();
        answerEnd = end;
        return null;
    }
}
