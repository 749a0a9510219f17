package org.jsmesh.web;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.teavm.jso.typedarrays.Int8Array;

/**
 * What the methods do that the worker of the workshop calls. Files go in and come out through one buffer that Java and
 * JavaScript share, {@link #staging}, in portions of at most its size. Everything else is a number or JSON text, as
 * {@link Answer} says. Below, the answer is the value.
 */
final class WorkshopCalls {
    private static final int STAGING_BYTES = 1 << 20;
    static final ByteBuffer STAGING = ByteBuffer.allocateDirect(STAGING_BYTES).order(ByteOrder.LITTLE_ENDIAN);

    private static final HeardProgress PROGRESS = new HeardProgress();
    private static Workshop workshop = new Workshop();

    private WorkshopCalls() {}

    /** Forgets all files. */
    static String open() {
        return Answer.done(() -> workshop = new Workshop());
    }

    /** The buffer through which files go in and come out. */
    static Int8Array staging() {
        return Int8Array.fromJavaBuffer(STAGING);
    }

    /** Begins a file that is given, of so many bytes; {@link #append} brings them. */
    static String begin(String name, int bytes) {
        return Answer.done(() -> workshop.begin(name, bytes));
    }

    /** Takes the first bytes of the buffer for the next ones of the file. */
    static String append(int length) {
        return Answer.done(() -> {
            STAGING.clear();
            workshop.append(STAGING, length);
        });
    }

    /**
     * Writes the original of an archive as a model file, whose name tells the format. Answers {@code {"files":
     * [{"name": …, "bytes": …}], "notes": […]}}: the model file is the first, and the notes say what it does not hold.
     */
    static String decode(String name, String fileName) {
        return Answer.of(json -> workshop.decode(name, fileName, json));
    }

    /** Encodes a model file, with the other files beside it. Answers the same: the archive is the only file. */
    static String encode(String name, int mostFaces) {
        return Answer.of(json -> workshop.encode(name, mostFaces, PROGRESS, json));
    }

    /** What is being done, for whoever hears from {@link #encode} how far it is. */
    static String stage() {
        return Answer.of(json -> json.text(PROGRESS.stage()));
    }

    /** Copies a portion of a file into the buffer; answers how many bytes of it are left from there on. */
    static String copy(int file, int from) {
        return Answer.of(json -> {
            byte[] bytes = workshop.file(file);
            if (from < 0 || from > bytes.length) throw new WrongCallException("file " + file + " has no byte " + from);
            STAGING.clear();
            STAGING.put(bytes, from, Math.min(STAGING_BYTES, bytes.length - from));
            json.number(bytes.length - from);
        });
    }
}
