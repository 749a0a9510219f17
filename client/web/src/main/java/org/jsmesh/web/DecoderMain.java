package org.jsmesh.web;

import org.teavm.jso.JSExport;
import org.teavm.jso.typedarrays.Int8Array;

/** The whole decoder, as the worker calls it. */
public final class DecoderMain {
    private DecoderMain() {}

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

    /** See {@link DecoderCalls#feed}. */
    @JSExport
    public static String feed(int length) {
        return DecoderCalls.feed(length);
    }

    /** See {@link DecoderCalls#header}. */
    @JSExport
    public static String header() {
        return DecoderCalls.header();
    }

    /** See {@link DecoderCalls#isComplete}. */
    @JSExport
    public static String isComplete() {
        return DecoderCalls.isComplete();
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

    /** See {@link DecoderCalls#images}. */
    @JSExport
    public static String images() {
        return DecoderCalls.images();
    }

    /** See {@link DecoderCalls#copyImage}. */
    @JSExport
    public static String copyImage(int image, int from) {
        return DecoderCalls.copyImage(image, from);
    }

    /** See {@link DecoderCalls#sha256}. */
    @JSExport
    public static String sha256() {
        return DecoderCalls.sha256();
    }

    /** See {@link DecoderCalls#proof}. */
    @JSExport
    public static String proof() {
        return DecoderCalls.proof();
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
