package org.jsmesh.app.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.InputStream;
import java.lang.management.BufferPoolMXBean;
import java.lang.management.ManagementFactory;
import java.net.Socket;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Memory of a server whose readers take their time: it must not hold what they have not taken. */
@Tag("slow")
class SlowReadersTest extends GuardedServer {
    private static final int READERS = 300;

    /**
     * Buffers for headers, and what describes a request and a connection on both sides; far below a portion of an
     * archive.
     */
    private static final long BYTES_PER_READER = 100 << 10;

    @Test
    void shouldHoldNextToNothingForASlowReader() throws Exception {
        assertStillServes();
        long before = usedBytes();
        List<Socket> readers = new ArrayList<>();
        try {
            for (int i = 0; i < READERS; i++) {
                Socket reader = connect();
                readers.add(reader);
                send(reader, requestLarge());
                assertThat(reader.getInputStream().read()).isEqualTo('H');
            }
            assertStillServes();
            // The answer that has just been read may be counted for a moment yet.
            Await.until(
                    "the readers alone",
                    () -> server.metrics().text().contains("jsm_requests_running " + READERS + ".0\n"));
            assertThat(usedBytes() - before).isLessThan(READERS * BYTES_PER_READER);
            byte[] all = readToEnd(readers.get(READERS - 1));
            byte[] end = Arrays.copyOfRange(all, all.length - large.length, all.length);
            assertThat(Arrays.equals(end, large)).isTrue();
        } finally {
            for (Socket reader : readers) reader.close();
        }
    }

    /** Heap that lives, and memory outside of it. */
    private static long usedBytes() throws InterruptedException {
        for (int i = 0; i < 3; i++) {
            System.gc();
            Thread.sleep(50);
        }
        long used = ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed();
        for (BufferPoolMXBean pool : ManagementFactory.getPlatformMXBeans(BufferPoolMXBean.class)) {
            if (pool.getName().equals("direct")) used += pool.getMemoryUsed();
        }
        return used;
    }

    @Test
    void shouldSendToManyAtOnceWithoutMixingThemUp() throws Exception {
        List<Socket> readers = new ArrayList<>();
        try {
            for (int i = 0; i < 20; i++) {
                Socket reader = connect();
                readers.add(reader);
                int from = 1_000_000 + 100_000 * i;
                send(
                        reader,
                        requestLarge()
                                .replace(
                                        "Host: h\r\n",
                                        "Host: h\r\nRange: bytes=" + from + "-" + (from + 499_999) + "\r\n"));
            }
            for (int i = 0; i < readers.size(); i++) {
                InputStream in = readers.get(i).getInputStream();
                byte[] all = in.readAllBytes();
                int from = 1_000_000 + 100_000 * i;
                byte[] body = Arrays.copyOfRange(all, all.length - 500_000, all.length);
                assertThat(Arrays.equals(body, Arrays.copyOfRange(large, from, from + 500_000)))
                        .isTrue();
            }
        } finally {
            for (Socket reader : readers) reader.close();
        }
    }
}
