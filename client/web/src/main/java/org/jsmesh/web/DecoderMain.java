package org.jsmesh.web;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.jsmesh.display.RenderMesh;
import org.jsmesh.plan.BatchRequest;
import org.jsmesh.plan.RoundPlanner;
import org.teavm.jso.JSExport;
import org.teavm.jso.typedarrays.Int8Array;

/**
 * The methods that the worker calls. There is one archive at a time; {@link #open} starts the next one. Bytes go in and
 * arrays come out through one buffer that Java and JavaScript share, {@link #staging}, in portions of at most its size.
 * On WebAssembly it lies in linear memory, which may move, so ask for it again after every call.
 *
 * <p>Everything else is a number or JSON text. No exception leaves these methods: each answers as {@link Answer} says,
 * with its value or with an error. Below, the answer is the value.
 */
public final class DecoderMain {
    private static final int STAGING_BYTES = 1 << 20;
    static final ByteBuffer STAGING = ByteBuffer.allocateDirect(STAGING_BYTES).order(ByteOrder.LITTLE_ENDIAN);

    /** How many arrays {@link RenderMesh} numbers. */
    private static final int ARRAYS = 6;

    private static DecodingSession session = new DecodingSession();
    private static final RoundPlanner PLANNER = new RoundPlanner();
    private static RenderMesh drawn;

    private DecoderMain() {}

    public static void main(String[] args) {}

    /** Forgets the archive before and starts with the first byte of the next one. The throughput estimate stays. */
    @JSExport
    public static String open() {
        return Answer.done(() -> {
            session = new DecodingSession();
            drawn = null;
        });
    }

    /** The buffer through which bytes go in and arrays come out. */
    @JSExport
    public static Int8Array staging() {
        return Int8Array.fromJavaBuffer(STAGING);
    }

    /** Decodes the first bytes of the buffer; answers how many batches are applied so far. */
    @JSExport
    public static String feed(int length) {
        return Answer.of(json -> {
            if (length < 0 || length > STAGING_BYTES)
                throw new WrongCallException("cannot feed " + length + " bytes, only 0 to " + STAGING_BYTES);
            byte[] bytes = new byte[length];
            STAGING.clear();
            STAGING.get(bytes);
            json.number(session.feed(bytes));
        });
    }

    /** The header with the index (see {@link HeaderJson}), or null until its first part has arrived. */
    @JSExport
    public static String header() {
        return Answer.of(json -> {
            if (session.opening() == null) json.text(null);
            else HeaderJson.write(json, session.opening(), session.header());
        });
    }

    /** Whether the last batch is applied. */
    @JSExport
    public static String isComplete() {
        return Answer.of(json -> json.flag(session.isComplete()));
    }

    /**
     * Prepares the arrays of the mesh shown now, which {@link #copy} then hands out; answers how many elements each
     * has, in the order of the numbers in {@link RenderMesh}.
     */
    @JSExport
    public static String draw() {
        return Answer.of(json -> {
            drawn = session.draw();
            json.open('[');
            for (int array = 0; array < ARRAYS; array++) json.number(drawn.count(array));
            json.close(']');
        });
    }

    /**
     * Copies elements of an array into the buffer, from one on, as many as fit. Answers how many it has copied.
     *
     * @param array number in {@link RenderMesh}
     * @param from the first element
     */
    @JSExport
    public static String copy(int array, int from) {
        return Answer.of(json -> {
            if (drawn == null) throw new WrongCallException("there is nothing to copy before draw()");
            if (array < 0 || array >= ARRAYS) throw new WrongCallException("there is no array " + array);
            if (from < 0 || from > drawn.count(array))
                throw new WrongCallException("array " + array + " has no element " + from);
            STAGING.clear();
            json.number(drawn.copy(array, from, STAGING));
        });
    }

    /** Releases the arrays to the garbage collector. */
    @JSExport
    public static String release() {
        return Answer.done(() -> drawn = null);
    }

    /** The images that can be shown: see {@link DecodingSession#writeImages}. */
    @JSExport
    public static String images() {
        return Answer.of(json -> session.writeImages(json));
    }

    /**
     * Copies a portion of an image file into the buffer; answers how many bytes of it are left from there on.
     *
     * @param image place in the list of {@link #images}
     * @param from the first byte
     */
    @JSExport
    public static String copyImage(int image, int from) {
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
    @JSExport
    public static String sha256() {
        return Answer.of(json -> json.text(session.sha256()));
    }

    /**
     * A user starts to wait for {@code waitMillis} milliseconds of a clock that stands at {@code now}. A response under
     * way belongs to the round.
     */
    @JSExport
    public static String beginRound(double now, double waitMillis) {
        return Answer.done(() -> {
            if (!(waitMillis > 0)) throw new WrongCallException("a round cannot take " + waitMillis + " ms");
            PLANNER.beginRound(now, waitMillis);
        });
    }

    /** The next request of the round, or null when the round asks for no more. */
    @JSExport
    public static String nextRequest(double now, double receivedBytes) {
        return Answer.of(json -> {
            if (!(receivedBytes >= 0)) throw new WrongCallException("cannot have received " + receivedBytes + " bytes");
            BatchRequest request = PLANNER.next(now, session.index(), (long) receivedBytes);
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
    @JSExport
    public static String isOver(double now) {
        return Answer.of(json -> json.flag(PLANNER.isOver(now, session.batches() > 0)));
    }

    /** A request is sent. */
    @JSExport
    public static String beginResponse(double now) {
        return Answer.done(() -> PLANNER.sent(now));
    }

    /** Bytes of the response arrived. */
    @JSExport
    public static String arrived(double now, int bytes) {
        return Answer.done(() -> PLANNER.arrived(now, bytes));
    }

    /** The response ended. The estimate learns from it unless it came from a cache. */
    @JSExport
    public static String endResponse(boolean cached) {
        return Answer.done(() -> PLANNER.ended(cached));
    }

    /** Whether to read the rest of a response after the round. */
    @JSExport
    public static String mayGoOn(double now, double bytesLeft) {
        return Answer.of(json -> json.flag(PLANNER.mayGoOn(now, (long) bytesLeft)));
    }

    /** The estimate of the throughput; 0 while nothing is known. */
    @JSExport
    public static String bytesPerSecond(double now) {
        return Answer.of(json -> json.number(PLANNER.bytesPerSecond(now)));
    }
}
