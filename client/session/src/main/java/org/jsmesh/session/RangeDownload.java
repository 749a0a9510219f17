package org.jsmesh.session;

import java.io.IOException;
import java.security.MessageDigest;
import org.jsmesh.plan.RoundPlanner;

/** One answer on its way into a {@link ReceivedArchive}. */
final class RangeDownload {
    private final ArchiveBody body;
    private final ReceivedArchive archive;
    private final RoundPlanner planner;
    private final SteadyClock clock;
    private final double startMillis;
    private double firstByteMillis = -1;
    private double lastPartMillis;
    private long bodyBytes;
    private long bodyLength = -1;
    private long skip;
    private MessageDigest skipped;
    private boolean ranged = true;
    private boolean ended;

    /** A request that was sent just now; the planner is told of what arrives. */
    RangeDownload(ArchiveBody body, ReceivedArchive archive, RoundPlanner planner, SteadyClock clock) {
        this.body = body;
        this.archive = archive;
        this.planner = planner;
        this.clock = clock;
        startMillis = clock.millis();
        lastPartMillis = startMillis;
        planner.sent(startMillis);
    }

    /** Takes the next part; false when none came within the time. */
    boolean step(long timeoutMillis) throws IOException {
        ArchiveBody.Part part = body.poll(timeoutMillis);
        if (part == null) return false;
        lastPartMillis = clock.millis();
        if (part instanceof ArchiveBody.Head head) begin(head);
        else if (part instanceof ArchiveBody.Bytes bytes) take(bytes);
        else end();
        return true;
    }

    private void begin(ArchiveBody.Head head) throws IOException {
        archive.join(head);
        ranged = head.ranged();
        if (head.toByte() >= 0) bodyLength = head.toByte() - head.fromByte();
        skip = archive.bytes() - head.fromByte();
        if (skip > 0) skipped = ReceivedArchive.sha256();
    }

    private void take(ArchiveBody.Bytes bytes) throws IOException {
        if (bytes.length() == 0) return;
        if (firstByteMillis < 0) firstByteMillis = bytes.atMillis();
        bodyBytes += bytes.length();
        planner.arrived(bytes.atMillis(), bytes.length());
        int offset = 0;
        if (skip > 0) {
            offset = (int) Math.min(skip, bytes.length());
            skipped.update(bytes.array(), 0, offset);
            skip -= offset;
            if (skip == 0 && !MessageDigest.isEqual(skipped.digest(), archive.prefixHash())) {
                throw new ArchiveChangedException(
                        body.url(), "its first " + archive.bytes() + " bytes are others than before");
            }
        }
        if (offset < bytes.length()) archive.take(bytes.array(), offset, bytes.length() - offset);
    }

    private void end() throws IOException {
        ended = true;
        if (bodyLength >= 0 && bodyBytes < bodyLength) {
            throw new IOException("the answer ended after " + bodyBytes + " of " + bodyLength + " bytes");
        }
        if (bodyBytes == 0) throw new IOException("the answer was empty");
        archive.checkEnd(!ranged);
    }

    /** True when the body has arrived whole. */
    boolean isEnded() {
        return ended;
    }

    /**
     * False when the server sent the whole archive though a range was asked for: a body to go on reading in later
     * rounds.
     */
    boolean isRanged() {
        return ranged;
    }

    /** Bytes of the body still to come; a guess of 0 when its length is not known. */
    long bytesLeft() {
        return Math.max(0, bodyLength - bodyBytes);
    }

    /** Bytes of the body received. */
    long bodyBytes() {
        return bodyBytes;
    }

    /** Milliseconds without any sign of the server. */
    double silentMillis() {
        return clock.millis() - lastPartMillis;
    }

    /** Reading goes on after a pause: what is learned begins anew. */
    void resumed() {
        lastPartMillis = clock.millis();
        planner.sent(lastPartMillis);
    }

    void cancel() {
        body.cancel();
    }

    RequestReport report() {
        return new RequestReport(
                body.url(),
                body.range(),
                (long) startMillis,
                firstByteMillis < 0 ? -1 : (long) firstByteMillis,
                (long) clock.millis(),
                bodyBytes,
                body.isHttp2());
    }
}
