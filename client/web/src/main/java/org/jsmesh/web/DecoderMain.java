package org.jsmesh.web;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.display.DrawnArrays;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.plan.BatchRequest;
import org.jsmesh.plan.RoundPlanner;
import org.teavm.jso.JSExport;
import org.teavm.jso.typedarrays.Int8Array;

/**
 * What the worker calls. One archive at a time; {@link #open} starts the next one. Bytes go in and arrays come out
 * through one buffer that Java and JavaScript both see, {@link #staging}, in portions of at most its size: on
 * WebAssembly it lies in linear memory, which may move, so ask for it anew after every call.
 *
 * <p>No exception leaves these methods for bad bytes: they answer {@link #FAILED}, and {@link #error} says what
 * happened.
 */
public final class DecoderMain {
    /** Answer of a method that failed. */
    static final int FAILED = -1;

    private static final int STAGING_BYTES = 1 << 20;
    private static final ByteBuffer STAGING =
            ByteBuffer.allocateDirect(STAGING_BYTES).order(ByteOrder.LITTLE_ENDIAN);

    private static DecodingSession session = new DecodingSession();
    private static final RoundPlanner PLANNER = new RoundPlanner();
    private static DrawnArrays drawn;
    private static String error;

    private DecoderMain() {}

    public static void main(String[] args) {}

    /** Forgets the archive before and starts with the first byte of the next one. The throughput estimate stays. */
    @JSExport
    public static void open() {
        session = new DecodingSession();
        drawn = null;
        error = null;
    }

    /** The buffer through which bytes go in and arrays come out. */
    @JSExport
    public static Int8Array staging() {
        return Int8Array.fromJavaBuffer(STAGING);
    }

    /**
     * Decodes the first bytes of the buffer.
     *
     * @return batches applied so far, or {@link #FAILED}
     */
    @JSExport
    public static int feed(int length) {
        byte[] bytes = new byte[length];
        STAGING.clear();
        STAGING.get(bytes);
        try {
            return session.feed(bytes);
        } catch (MalformedStreamException | RuntimeException e) {
            error = e.getMessage() == null ? "the decoder stopped" : e.getMessage();
            return FAILED;
        }
    }

    /** Why the last call failed, or null. */
    @JSExport
    public static String error() {
        return error;
    }

    /** The header with the index as JSON (see {@link HeaderJson}), or null until its first part has arrived. */
    @JSExport
    public static String header() {
        ArchiveHeader header = session.header();
        return header == null ? null : HeaderJson.of(header);
    }

    /** True when the last batch is applied. */
    @JSExport
    public static boolean isComplete() {
        return session.isComplete();
    }

    /**
     * Prepares the arrays of the mesh shown now; {@link #count} and {@link #copy} then hand them out.
     *
     * @return render vertices, or {@link #FAILED} before the base has arrived
     */
    @JSExport
    public static int draw() {
        if (session.header() == null || session.batches() == 0) return FAILED;
        try {
            drawn = session.draw();
            return drawn.vertices();
        } catch (RuntimeException e) {
            error = e.getMessage() == null ? "the mesh cannot be drawn" : e.getMessage();
            return FAILED;
        }
    }

    /** Elements of an array that {@link #draw} prepared: see {@link DrawnArrays} for the numbers. */
    @JSExport
    public static int count(int array) {
        return drawn.count(array);
    }

    /**
     * Copies a portion of an array into the buffer.
     *
     * @param from the first element
     * @return elements copied: as many as fit
     */
    @JSExport
    public static int copy(int array, int from) {
        STAGING.clear();
        return drawn.copy(array, from, STAGING);
    }

    /** Gives the arrays back to the garbage collector. */
    @JSExport
    public static void release() {
        drawn = null;
    }

    /**
     * Paths of the textures that can be shown, one per line: of those that have arrived whole, then of previews, each
     * followed by a tab and its width.
     */
    @JSExport
    public static String textures() {
        return session.texturePaths();
    }

    /** Bytes of the image file behind one of these lines. */
    @JSExport
    public static int textureBytes(int texture) {
        return session.texture(texture).length;
    }

    /** Copies a portion of such a file into the buffer and says how many bytes that are. */
    @JSExport
    public static int copyTexture(int texture, int from) {
        byte[] bytes = session.texture(texture);
        int length = Math.min(STAGING_BYTES, bytes.length - from);
        STAGING.clear();
        STAGING.put(bytes, from, length);
        return length;
    }

    /** Identity of the mesh decoded so far, computed from its faces; null when it cannot be computed. */
    @JSExport
    public static String sha256() {
        try {
            return session.sha256();
        } catch (RuntimeException e) {
            error = e.getMessage();
            return null;
        }
    }

    /**
     * A user starts to wait for {@code waitMillis} milliseconds of a clock that stands at {@code now}. A response under
     * way belongs to the round.
     */
    @JSExport
    public static void beginRound(double now, double waitMillis) {
        PLANNER.beginRound(now, waitMillis);
    }

    /**
     * The next request of the round as {@code from end fromBatch endBatch bytesPerSecond waitMillis}, or null when the
     * round asks for no more.
     */
    @JSExport
    public static String nextRequest(double now, double receivedBytes) {
        BatchRequest r = PLANNER.next(now, session.index(), (long) receivedBytes);
        if (r == null) return null;
        return r.fromByte() + " " + r.endByte() + " " + r.fromBatch() + " " + r.endBatch() + " " + r.bytesPerSecond()
                + " " + r.waitMillis();
    }

    /** Whether what is there is to be shown now, though a response is under way. */
    @JSExport
    public static boolean isOver(double now) {
        return PLANNER.isOver(now, session.batches() > 0);
    }

    /** A request is sent. */
    @JSExport
    public static void beginResponse(double now) {
        PLANNER.sent(now);
    }

    /** Bytes of the response arrived. */
    @JSExport
    public static void arrived(double now, int bytes) {
        PLANNER.arrived(now, bytes);
    }

    /** The response ended; it teaches the estimate unless it came from a cache. */
    @JSExport
    public static void endResponse(boolean cached) {
        PLANNER.ended(cached);
    }

    /** Whether the rest of a response is read on after the round. */
    @JSExport
    public static boolean mayGoOn(double now, double bytesLeft) {
        return PLANNER.mayGoOn(now, (long) bytesLeft);
    }

    /** The estimate of the throughput; 0 while nothing is known. */
    @JSExport
    public static double bytesPerSecond(double now) {
        return PLANNER.bytesPerSecond(now);
    }
}
