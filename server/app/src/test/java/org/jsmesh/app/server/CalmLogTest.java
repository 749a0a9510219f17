package org.jsmesh.app.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.atomic.AtomicLong;
import java.util.logging.Level;
import java.util.logging.LogRecord;
import java.util.logging.SimpleFormatter;
import java.util.logging.StreamHandler;
import org.junit.jupiter.api.Test;

/** A log that clients cannot fill. */
class CalmLogTest {
    private static final long MINUTE = 60_000_000_000L;

    private final ByteArrayOutputStream out = new ByteArrayOutputStream();
    private final StreamHandler handler = new StreamHandler(out, new SimpleFormatter());
    private final AtomicLong nanos = new AtomicLong();
    private final CalmLog calm = CalmLog.calm(handler, nanos::get);

    private void log(Level level, String logger, String text, Throwable thrown) {
        LogRecord message = new LogRecord(level, text);
        message.setLoggerName(logger);
        message.setThrown(thrown);
        handler.publish(message);
    }

    private String text() {
        handler.flush();
        return out.toString(StandardCharsets.UTF_8);
    }

    private long lines(String words) {
        return text().lines().filter(line -> line.contains(words)).count();
    }

    @Test
    void shouldTellAFewOfAKindAndTheNumberOfTheOthers() {
        for (int i = 0; i < 100_000; i++) log(Level.WARNING, "http", "Bad host " + i, null);
        log(Level.WARNING, "http", "another kind", new IOException("cut"));
        log(Level.WARNING, "store", "another place", null);
        assertThat(lines("Bad host ")).isEqualTo(20);
        assertThat(text()).contains("another kind", "another place");
        calm.tell();
        assertThat(text()).doesNotContain("more messages");
        nanos.addAndGet(MINUTE);
        calm.tell();
        calm.tell();
        assertThat(lines("99980 more messages of http were left out")).isEqualTo(1);
        log(Level.WARNING, "http", "Bad host again", null);
        assertThat(lines("Bad host again")).isEqualTo(1);
    }

    @Test
    void shouldTellTheNumberWhenTheNextOneComes() {
        for (int i = 0; i < 30; i++) log(Level.SEVERE, "http", "Bad host", new IOException("cut"));
        nanos.addAndGet(MINUTE);
        log(Level.SEVERE, "http", "Bad host", new IOException("cut"));
        assertThat(lines("10 more messages of http with IOException were left out"))
                .isEqualTo(1);
    }

    @Test
    void shouldTellAllThatTheServerDoes() {
        for (int i = 0; i < 1000; i++) log(Level.INFO, "store", "Encoding " + i, null);
        assertThat(lines("Encoding ")).isEqualTo(1000);
    }

    @Test
    void shouldWriteNothingThatATerminalObeysAndNoLineOfAClient() {
        String hostile = "Bad host [a\r\n2026-11-22 SEVERE: all is lost\u001b[31m\u0007\u009b1m\u2028]";
        log(Level.WARNING, "http", hostile, new IOException(hostile, new IOException(hostile)));
        assertThat(text())
                .contains("Bad host [a\\u000d\\u000a2026", "java.io.IOException: Bad host [a\\u000d", "Caused by: ");
        assertThat(text().lines()).noneMatch(line -> line.startsWith("2026-11-22 SEVERE"));
        assertThat(text()).doesNotContain("\u001b", "\u0007", "\u009b", "\u2028");
        log(Level.WARNING, "http", "a".repeat(8000), null);
        assertThat(text()).contains("aaa… (8000 characters)").doesNotContain("a".repeat(1001));
    }
}
