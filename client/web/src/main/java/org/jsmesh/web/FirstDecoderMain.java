package org.jsmesh.web;

import org.teavm.jso.JSExport;
import org.teavm.jso.typedarrays.Int8Array;

/**
 * The first decoder, as the worker calls it: what shows the base and the first splits. It is the whole decoder without
 * what {@code FirstDecoderParts} leaves out when it is compiled, so that a slow connection brings it soon. It says
 * where it knows no further; the whole decoder begins again with the first byte.
 */
public final class FirstDecoderMain {
    private FirstDecoderMain() {}

    public static void main(String[] args) {}

    /** See {@link DecoderCalls#open}. */
    @JSExport
    public static String open() {
        return DecoderCalls.open();
    }

    /** See {@link DecoderCalls#staging}. */
    @JSExport
    public static Int8Array staging() {
        return DecoderCalls.staging();
    }

    /** See {@link DecoderCalls#feedFirst}. */
    @JSExport
    public static String feed(int length) {
        return DecoderCalls.feedFirst(length);
    }

    /** See {@link DecoderCalls#firstHeader}. */
    @JSExport
    public static String header() {
        return DecoderCalls.firstHeader();
    }

    /** See {@link DecoderCalls#refine}. */
    @JSExport
    public static String refine() {
        return DecoderCalls.refine();
    }

    /** See {@link DecoderCalls#copy}. */
    @JSExport
    public static String copy(int from) {
        return DecoderCalls.copy(from);
    }

    /** See {@link DecoderCalls#beginRound}. */
    @JSExport
    public static String beginRound(double now, double waitMillis) {
        return DecoderCalls.beginRound(now, waitMillis);
    }

    /** See {@link DecoderCalls#nextRequest}. */
    @JSExport
    public static String nextRequest(double now, double receivedBytes) {
        return DecoderCalls.nextRequest(now, receivedBytes);
    }

    /** See {@link DecoderCalls#isOver}. */
    @JSExport
    public static String isOver(double now) {
        return DecoderCalls.isOver(now);
    }

    /** See {@link DecoderCalls#beginResponse}. */
    @JSExport
    public static String beginResponse(double now) {
        return DecoderCalls.beginResponse(now);
    }

    /** See {@link DecoderCalls#arrived}. */
    @JSExport
    public static String arrived(double now, int bytes) {
        return DecoderCalls.arrived(now, bytes);
    }

    /** See {@link DecoderCalls#endResponse}. */
    @JSExport
    public static String endResponse(boolean cached) {
        return DecoderCalls.endResponse(cached);
    }

    /** See {@link DecoderCalls#mayGoOn}. */
    @JSExport
    public static String mayGoOn(double now, double bytesLeft) {
        return DecoderCalls.mayGoOn(now, bytesLeft);
    }

    /** See {@link DecoderCalls#bytesPerSecond}. */
    @JSExport
    public static String bytesPerSecond(double now) {
        return DecoderCalls.bytesPerSecond(now);
    }
}
