package org.jsmesh.app.server;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.LongAdder;
import org.eclipse.jetty.http.HttpHeader;
import org.eclipse.jetty.server.Request;

/**
 * One line of JSON per request, written by a thread of its own: {@code time, remote, method, path, query, protocol,
 * status, bytes, range, firstByteMillis, millis, aborted}. When lines come faster than they can be written, the log
 * loses and counts some rather than delay requests. It also counts lines that cannot be written. Thread-safe.
 */
public final class AccessLog implements Exchange.Listener, AutoCloseable {
    private static final Logger LOG = System.getLogger(AccessLog.class.getName());
    private static final int QUEUE = 1 << 14;
    private static final int TOO_FAST = 429;

    /** Lines a second of requests that came too fast. */
    private static final int MOST_REFUSALS = 100;

    private static final long SECOND_NANOS = 1_000_000_000L;

    /** Of what a client sends, in one field. */
    private static final int LONGEST = 1000;

    private static final String END = "";
    private static final long CLOSING_SECONDS = 5;

    private final BlockingQueue<String> lines = new ArrayBlockingQueue<>(QUEUE);
    private final LongAdder lost = new LongAdder();
    private final AtomicInteger refusals = new AtomicInteger();
    private final AtomicLong refusalNanos = new AtomicLong(System.nanoTime());
    private final OutputStream out;
    private final boolean closing;
    private final Thread writer;

    private AccessLog(OutputStream out, boolean closing) {
        this.out = out;
        this.closing = closing;
        writer = new Thread(this::write, "jsm-access-log");
        writer.setDaemon(true);
    }

    /** Appends to the file. */
    public static AccessLog to(Path file) throws IOException {
        return to(Files.newOutputStream(file, StandardOpenOption.CREATE, StandardOpenOption.APPEND));
    }

    /** Writes to a stream and closes it. */
    public static AccessLog to(OutputStream out) {
        return new AccessLog(out, true).start();
    }

    /** Writes to a stream that stays open. */
    public static AccessLog to(PrintStream stream) {
        return new AccessLog(stream, false).start();
    }

    private AccessLog start() {
        writer.start();
        return this;
    }

    public long lost() {
        return lost.sum();
    }

    @Override
    public void ended(Exchange exchange) {
        boolean told = exchange.status() != TOO_FAST || isToTell(System.nanoTime());
        if (!told || !lines.offer(line(exchange))) lost.increment();
    }

    /** Whoever asks too fast shall not fill the disk instead. */
    private boolean isToTell(long now) {
        long since = refusalNanos.get();
        if (now - since >= SECOND_NANOS && refusalNanos.compareAndSet(since, now)) refusals.set(0);
        return refusals.incrementAndGet() <= MOST_REFUSALS;
    }

    static String line(Exchange exchange) {
        Request request = exchange.request();
        StringBuilder json = new StringBuilder(256).append('{');
        // Time of the end: the line tells what happened until then.
        text(json, "time", Instant.now().truncatedTo(ChronoUnit.MILLIS).toString());
        text(json, "remote", exchange.client().address());
        text(json, "method", request.getMethod());
        text(json, "path", request.getHttpURI().getPath());
        text(json, "query", withoutSignature(request.getHttpURI().getQuery()));
        text(json, "protocol", request.getConnectionMetaData().getHttpVersion().asString());
        value(json, "status", Integer.toString(exchange.status()));
        value(json, "bytes", Long.toString(exchange.sentBytes()));
        text(json, "range", request.getHeaders().get(HttpHeader.RANGE));
        long first = exchange.firstByteAfterNanos();
        value(json, "firstByteMillis", first < 0 ? "null" : millis(first));
        value(json, "millis", millis(exchange.durationNanos()));
        value(json, "aborted", Boolean.toString(exchange.isAborted()));
        json.setCharAt(json.length() - 1, '}');
        return json.append('\n').toString();
    }

    /** Whoever reads the log shall not be able to use the addresses in it. */
    private static String withoutSignature(String query) {
        return query == null || !query.contains("signature=")
                ? query
                : query.replaceAll("signature=[^&]*", "signature=");
    }

    private static String millis(long nanos) {
        long micros = Math.max(0, nanos / 1000);
        return micros / 1000 + "." + Long.toString(1000 + micros % 1000).substring(1);
    }

    private static void value(StringBuilder json, String name, String value) {
        json.append('"').append(name).append("\":").append(value).append(',');
    }

    private static void text(StringBuilder json, String name, String value) {
        json.append('"').append(name).append("\":");
        if (value == null) json.append("null");
        else quote(json, value);
        json.append(',');
    }

    /** Keeps whatever a client sends within its line and its quotes, and free of characters that a terminal obeys. */
    private static void quote(StringBuilder json, String text) {
        json.append('"');
        int length = Math.min(text.length(), LONGEST);
        for (int i = 0; i < length; i++) {
            char c = text.charAt(i);
            if (c == '"' || c == '\\') json.append('\\').append(c);
            else if (c >= ' ' && c < 127) json.append(c);
            else json.append(String.format(Locale.ROOT, "\\u%04x", (int) c));
        }
        if (length < text.length()) json.append("...");
        json.append('"');
    }

    private void write() {
        List<String> taken = new ArrayList<>();
        boolean failed = false;
        try {
            boolean open = true;
            while (open) {
                taken.clear();
                taken.add(lines.take());
                lines.drainTo(taken);
                if (taken.remove(END)) open = false;
                failed = !write(taken, failed);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /**
     * Writes all lines at once, or says that it cannot, because the disk may be full now and have room later.
     *
     * @param again whether the last write failed, and may have left a part of a line
     */
    private boolean write(List<String> taken, boolean again) {
        if (taken.isEmpty()) return true;
        String text = (again ? "\n" : "") + String.join("", taken);
        try {
            out.write(text.getBytes(StandardCharsets.US_ASCII));
            out.flush();
            return true;
        } catch (IOException e) {
            lost.add(taken.size());
            if (!again) LOG.log(Level.ERROR, "The access log cannot be written; lines are lost", e);
            return false;
        }
    }

    @Override
    public void close() throws IOException {
        try {
            if (!lines.offer(END, CLOSING_SECONDS, TimeUnit.SECONDS)) writer.interrupt();
            writer.join(1000 * CLOSING_SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        if (closing) out.close();
    }
}
