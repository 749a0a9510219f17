package org.jsmesh.web;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.jsmesh.display.LiveMesh;
import org.jsmesh.plan.BatchRequest;
import org.jsmesh.plan.RoundPlanner;
import org.teavm.jso.typedarrays.Int8Array;

/**
 * What the methods do that the worker calls. There is one archive at a time; {@link #open} starts the next one. Bytes
 * go in and arrays come out through one buffer that Java and JavaScript share, {@link #staging}, in portions of at most
 * its size. On WebAssembly it lies in linear memory, which may move, so ask for it again after every call.
 *
 * <p>Everything else is a number or JSON text. No exception leaves these methods: each answers as {@link Answer} says,
 * with its value or with an error. Below, the answer is the value.
 */
final class DecoderCalls {
    private static final int STAGING_BYTES = 1 << 20;
    static final ByteBuffer STAGING = ByteBuffer.allocateDirect(STAGING_BYTES).order(ByteOrder.LITTLE_ENDIAN);

    private static DecodingSession session = new DecodingSession();
    private static final RoundPlanner PLANNER = new RoundPlanner();

    private DecoderCalls() {}

    /** Forgets the archive before and starts with the first byte of the next one. The throughput estimate stays. */
    static String open() {
        return Answer.done(() -> session = new DecodingSession());
    }

    /** The buffer through which bytes go in and arrays come out. */
    static Int8Array staging() {
        return Int8Array.fromJavaBuffer(STAGING);
    }

    /** Decodes the first bytes of the buffer; answers how many batches are applied so far. */
    static String feed(int length) {
        return Answer.of(json -> json.number(session.feed(staged(length))));
    }

    /**
     * Decodes the first bytes of the buffer up to a batch that only the whole decoder knows. Answers how many batches
     * are applied so far, or, at such a batch, −1 less that number: more bytes are then of no use here.
     */
    static String feedFirst(int length) {
        return Answer.of(json -> json.number(session.feedFirst(staged(length))));
    }

    private static byte[] staged(int length) {
        if (length < 0 || length > STAGING_BYTES)
            throw new WrongCallException("cannot feed " + length + " bytes, only 0 to " + STAGING_BYTES);
        byte[] bytes = new byte[length];
        STAGING.clear();
        STAGING.get(bytes);
        return bytes;
    }

    /** The header with the index (see {@link HeaderJson}), or null until its first part has arrived. */
    static String header() {
        return Answer.of(json -> {
            if (session.header() == null) writeFirst(json);
            else HeaderJson.write(json, session.opening(), session.header());
        });
    }

    /** The same as far as the first decoder knows it: without words and identity. */
    static String firstHeader() {
        return Answer.of(DecoderCalls::writeFirst);
    }

    private static void writeFirst(Json json) {
        if (session.opening() == null) json.text(null);
        else HeaderJson.writeFirst(json, session.opening(), session.header(), session.index());
    }

    /** Whether the last batch is applied. */
    static String isComplete() {
        return Answer.of(json -> json.flag(session.isComplete()));
    }

    /**
     * Brings the arrays to draw to what is decoded now; answers what has changed in them, see {@link ChangesJson}. Then
     * {@link #copy} hands out the changed elements.
     */
    static String refine() {
        return Answer.of(json -> ChangesJson.write(json, session.refine(), session.batches(), session.hasJumped()));
    }

    /**
     * Copies elements of the changed ranges, one range after the other, into the buffer, as many as fit. Answers how
     * many it has copied.
     *
     * @param from the first element, counted over all ranges
     */
    static String copy(int from) {
        return Answer.of(json -> {
            LiveMesh live = session.live();
            if (live == null) throw new WrongCallException("there is nothing to copy before refine()");
            if (from < 0) throw new WrongCallException("there is no element " + from);
            STAGING.clear();
            json.number(live.copy(from, STAGING));
        });
    }

    /** The images that can be shown: see {@link ShownImages#write}. */
    static String images() {
        return Answer.of(json -> session.writeImages(json));
    }

    /**
     * Copies a portion of an image file into the buffer; answers how many bytes of it are left from there on.
     *
     * @param image place in the list of {@link #images}
     * @param from the first byte
     */
    static String copyImage(int image, int from) {
        return Answer.of(json -> {
            byte[] bytes = session.image(image);
            if (from < 0 || from > bytes.length)
                throw new WrongCallException("image " + image + " has no byte " + from);
            STAGING.clear();
            STAGING.put(bytes, from, Math.min(STAGING_BYTES, bytes.length - from));
            json.number(bytes.length - from);
        });
    }

    /** Identity of the mesh decoded so far, computed from its faces. */
    static String sha256() {
        return Answer.of(json -> json.text(session.sha256()));
    }

    /**
     * How the original compares with the hashes of the header: those of the decoded mesh and of the model, and what
     * differs, as a clause that is empty when nothing does.
     */
    static String proof() {
        return Answer.of(json -> session.writeProof(json));
    }

    /**
     * A user starts to wait for {@code waitMillis} milliseconds of a clock that stands at {@code now}. A response under
     * way belongs to the round.
     */
    static String beginRound(double now, double waitMillis) {
        return Answer.done(() -> {
            if (!(waitMillis > 0)) throw new WrongCallException("a round cannot take " + (long) waitMillis + " ms");
            PLANNER.beginRound(time(now), waitMillis);
        });
    }

    /** The next request of the round, or null when the round asks for no more. */
    static String nextRequest(double now, double receivedBytes) {
        return Answer.of(json -> {
            if (!(receivedBytes >= 0))
                throw new WrongCallException("cannot have received " + (long) receivedBytes + " bytes");
            BatchRequest request = PLANNER.next(time(now), session.index(), (long) receivedBytes);
            if (request == null) {
                json.text(null);
                return;
            }
            json.open('{').key("from").number(request.fromByte());
            json.key("end").number(request.endByte());
            json.key("fromBatch").number(request.fromBatch());
            json.key("endBatch").number(request.endBatch());
            json.key("bytesPerSecond").number(request.bytesPerSecond());
            json.key("waitMillis").number(request.waitMillis()).close('}');
        });
    }

    /** Whether to show what is there now, even if a response is under way. */
    static String isOver(double now) {
        return Answer.of(json -> json.flag(PLANNER.isOver(time(now), session.batches() > 0)));
    }

    /** A request is sent. */
    static String beginResponse(double now) {
        return Answer.done(() -> PLANNER.sent(time(now)));
    }

    /** Bytes of the response arrived. */
    static String arrived(double now, int bytes) {
        return Answer.done(() -> PLANNER.arrived(time(now), bytes));
    }

    /** The response ended. The estimate learns from it unless it came from a cache. */
    static String endResponse(boolean cached) {
        return Answer.done(() -> PLANNER.ended(cached));
    }

    /** Whether to read the rest of a response after the round. */
    static String mayGoOn(double now, double bytesLeft) {
        return Answer.of(json -> json.flag(PLANNER.mayGoOn(time(now), (long) bytesLeft)));
    }

    /** The estimate of the throughput; 0 while nothing is known. */
    static String bytesPerSecond(double now) {
        return Answer.of(json -> json.number(PLANNER.bytesPerSecond(time(now))));
    }

    private static double time(double now) {
        if (!Double.isFinite(now)) throw new WrongCallException("the clock stands at no number");
        return now;
    }
}
