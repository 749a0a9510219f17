package org.jsmesh.app.server;

import java.util.Locale;
import java.util.Map;
import java.util.Timer;
import java.util.TimerTask;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.LongSupplier;
import java.util.logging.Filter;
import java.util.logging.Formatter;
import java.util.logging.Handler;
import java.util.logging.Level;
import java.util.logging.LogRecord;
import java.util.logging.Logger;

/**
 * Keeps the program's log readable whatever clients send. Of warnings of one kind (one logger, level and type of
 * exception) it lets a few through in a minute, counts the others, and tells their number when the minute is over. It
 * cuts long messages, and writes what a terminal would obey, and ends of lines, as escapes. Thread-safe.
 */
public final class CalmLog {
    private static final int MOST_OF_A_KIND = 20;
    private static final long WINDOW_NANOS = 60_000_000_000L;
    private static final int LONGEST = 1000;
    private static final char DELETE = 127;
    private static final char LAST_CONTROL = 0x9f;

    private record Kind(String logger, Level level, Class<?> thrown) {}

    private static final class Window {
        private long begin;
        private int told;
        private long left;
    }

    private final Handler handler;
    private final Filter before;
    private final LongSupplier nanos;
    private final Map<Kind, Window> windows = new ConcurrentHashMap<>();

    private CalmLog(Handler handler, LongSupplier nanos) {
        this.handler = handler;
        this.nanos = nanos;
        before = handler.getFilter();
        handler.setFilter(this::passes);
        handler.setFormatter(new Escaping(handler.getFormatter()));
    }

    /** Calms what the handlers of all loggers write, once for the process. */
    public static void install() {
        for (Handler handler : Logger.getLogger("").getHandlers()) {
            if (handler.getFormatter() instanceof Escaping) continue;
            CalmLog calm = calm(handler, System::nanoTime);
            Timer timer = new Timer("jsm-log", true);
            TimerTask tell = new TimerTask() {
                @Override
                public void run() {
                    calm.tell();
                }
            };
            timer.schedule(tell, WINDOW_NANOS / 1_000_000, WINDOW_NANOS / 1_000_000);
        }
    }

    static CalmLog calm(Handler handler, LongSupplier nanos) {
        return new CalmLog(handler, nanos);
    }

    private boolean passes(LogRecord message) {
        if (before != null && !before.isLoggable(message)) return false;
        if (message.getLevel().intValue() < Level.WARNING.intValue()) return true;
        Throwable thrown = message.getThrown();
        Kind kind = new Kind(message.getLoggerName(), message.getLevel(), thrown == null ? null : thrown.getClass());
        Window window = windows.computeIfAbsent(kind, k -> new Window());
        synchronized (window) {
            long now = nanos.getAsLong();
            if (window.told == 0 || now - window.begin >= WINDOW_NANOS) {
                tell(kind, window);
                window.begin = now;
                window.told = 0;
            }
            if (window.told < MOST_OF_A_KIND) {
                window.told++;
                return true;
            }
            window.left++;
            return false;
        }
    }

    /** Tells how many messages were left out in minutes that are over. */
    void tell() {
        windows.forEach((kind, window) -> {
            synchronized (window) {
                if (nanos.getAsLong() - window.begin >= WINDOW_NANOS) tell(kind, window);
            }
        });
    }

    private void tell(Kind kind, Window window) {
        if (window.left == 0) return;
        String what = kind.thrown() == null ? "" : " with " + kind.thrown().getSimpleName();
        LogRecord summary =
                new LogRecord(Level.INFO, window.left + " more messages of " + kind.logger() + what + " were left out");
        summary.setLoggerName(kind.logger());
        window.left = 0;
        handler.publish(summary);
    }

    /** Formats a message whose text is short and printable; the trace of an exception keeps its lines. */
    private static final class Escaping extends Formatter {
        private final Formatter formatter;

        Escaping(Formatter formatter) {
            this.formatter = formatter;
        }

        @Override
        public String format(LogRecord message) {
            LogRecord safe = new LogRecord(message.getLevel(), printable(formatMessage(message)));
            safe.setLoggerName(message.getLoggerName());
            safe.setInstant(message.getInstant());
            safe.setSourceClassName(message.getSourceClassName());
            safe.setSourceMethodName(message.getSourceMethodName());
            if (message.getThrown() != null) safe.setThrown(new Told(message.getThrown()));
            return formatter.format(safe);
        }
    }

    static String printable(String text) {
        if (text == null) return "null";
        int length = Math.min(text.length(), LONGEST);
        StringBuilder printable = new StringBuilder(length);
        for (int i = 0; i < length; i++) {
            char c = text.charAt(i);
            boolean obeyed = c < ' ' || c >= DELETE && c <= LAST_CONTROL || c == '\u2028' || c == '\u2029';
            if (obeyed) printable.append(String.format(Locale.ROOT, "\\u%04x", (int) c));
            else printable.append(c);
        }
        return length < text.length() ? printable + "… (" + text.length() + " characters)" : printable.toString();
    }

    /** An exception with a printable message and the trace of another one. */
    private static final class Told extends Throwable {
        private static final long serialVersionUID = 1L;
        private final String type;

        Told(Throwable told) {
            super(
                    told.getMessage() == null ? null : printable(told.getMessage()),
                    told.getCause() == null ? null : new Told(told.getCause()));
            type = told.getClass().getName();
            setStackTrace(told.getStackTrace());
        }

        @Override
        public synchronized Throwable fillInStackTrace() {
            return this;
        }

        @Override
        public String toString() {
            return getMessage() == null ? type : type + ": " + getMessage();
        }
    }
}
