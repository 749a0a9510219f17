package org.jsmesh.web;

import org.teavm.jso.JSExport;
import org.teavm.jso.typedarrays.Int8Array;

/** Makes model files of archives, and archives of model files, as the worker calls it. */
public final class WorkshopMain {
    private WorkshopMain() {}

    public static void main(String[] args) {}

    /** See {@link WorkshopCalls#open}. */
    @JSExport
    public static String open() {
        return WorkshopCalls.open();
    }

    /** See {@link WorkshopCalls#staging}. */
    @JSExport
    public static Int8Array staging() {
        return WorkshopCalls.staging();
    }

    /** See {@link WorkshopCalls#begin}. */
    @JSExport
    public static String begin(String name, int bytes) {
        return WorkshopCalls.begin(name, bytes);
    }

    /** See {@link WorkshopCalls#append}. */
    @JSExport
    public static String append(int length) {
        return WorkshopCalls.append(length);
    }

    /** See {@link WorkshopCalls#decode}. */
    @JSExport
    public static String decode(String name, String fileName) {
        return WorkshopCalls.decode(name, fileName);
    }

    /** See {@link WorkshopCalls#encode}. */
    @JSExport
    public static String encode(String name, int mostFaces) {
        return WorkshopCalls.encode(name, mostFaces);
    }

    /** See {@link WorkshopCalls#stage}. */
    @JSExport
    public static String stage() {
        return WorkshopCalls.stage();
    }

    /** See {@link WorkshopCalls#copy}. */
    @JSExport
    public static String copy(int file, int from) {
        return WorkshopCalls.copy(file, from);
    }
}
