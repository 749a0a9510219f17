package org.jsmesh.app.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Requests of HTTP/1.1 that mean harm: each is refused shortly, tells nothing, and harms nobody else. */
@Tag("slow")
class HostileRequestsTest extends GuardedServer {
    private static final String END = "Host: h\r\nConnection: close\r\n\r\n";

    @ParameterizedTest
    @ValueSource(
            strings = {
                "/../../../../etc/passwd",
                "/m/../../../../etc/passwd",
                "/m/%2e%2e/%2e%2e/%2e%2e/etc/passwd",
                "/m/%2E%2E%2F%2e%2e%2fetc%2fpasswd",
                "/m/..%2f..%2fetc%2fpasswd",
                "/m/%252e%252e%252f%252e%252e%252fetc%252fpasswd",
                "/m/..%5c..%5cetc%5cpasswd",
                "/m/..\\..\\etc\\passwd",
                "/m/%c0%ae%c0%ae/%c0%ae%c0%ae/etc/passwd",
                "/m/%e0%80%ae%e0%80%ae/etc/passwd",
                "/m/%f0%80%80%ae/etc/passwd",
                "/m/%uff0e%uff0e/etc/passwd",
                "/m/%u002e%u002e/etc/passwd",
                "/m/..;/..;/etc/passwd",
                "/m/..;a=b/..;c=d/etc/passwd",
                "/m/bumpy;x=/../../etc/passwd",
                "/m/bumpy%00.jsm",
                "/m/%00/manifest.json",
                "/m/bumpy%0d%0aSet-Cookie:%20a=b",
                "/m/bumpy%0aX: y",
                "/m//bumpy//manifest.json/..//..//",
                "/m/./././bumpy/./x",
                "/m/.%2e/.%2e/etc/passwd",
                "/m/%2e./%2e./etc/passwd",
                "/m/%%32%65%%32%65/etc/passwd",
                "/m/%",
                "/m/%2",
                "/m/%zz",
                "/m/bumpy.jsm",
                "/m/models/bumpy.jsm",
                "/models/bumpy.jsm",
                "/WEB-INF/web.xml",
                "/web-inf/web.xml",
                "/%57EB-INF/web.xml",
                "/WEB-INF;/web.xml",
                "/META-INF/MANIFEST.MF",
                "/META-INF/resources/jsm/index.html",
                "/viewer/../META-INF/MANIFEST.MF",
                "/viewer/..%2f..%2fMETA-INF/MANIFEST.MF",
                "/viewer/",
                "/org/jsmesh/app/Jsm.class",
                "//etc/passwd",
                "/\\etc\\passwd",
                "/file:///etc/passwd",
                "/.git/config",
                "/.%00/",
                "/m/~/.ssh/id_rsa"
            })
    void shouldFollowNoPathOutOfTheCatalogue(String target) throws Exception {
        String answer = exchange("GET " + target + " HTTP/1.1\r\n" + END);
        assertThat(answer).matches("(?s)HTTP/1\\.1 (400|404) .*");
        assertTellsNothing(answer);
        assertThat(answer).contains("{\"error\":").doesNotContain("Set-Cookie");
        assertStillServes();
    }

    private static void assertTellsNothing(String answer) {
        assertThat(answer)
                .doesNotContain("root:", folder.toString(), "Exception", "\tat ", "org.eclipse", "java.")
                .doesNotContainIgnoringCase("jetty")
                .doesNotContain("Server:");
    }

    static List<String> ranges() {
        String single = IntStream.range(0, 1000).mapToObj(i -> i + "-" + i).collect(Collectors.joining(","));
        return List.of(
                single,
                "0-,".repeat(1500) + "0-",
                "0-99,50-149,0-99,50-149",
                "-1,-2,-3,-4",
                "0-0,-1",
                "0-18446744073709551615,1-",
                "99999999999999999999999999-",
                "-99999999999999999999999999999999",
                "--1",
                "-0",
                "0--1",
                "5-4",
                "0x0-0x10",
                "0-1;2-3",
                "\u0661-\u0662",
                " , , 0-1",
                "-");
    }

    /** An answer is never larger than the archive, however its bytes are asked for. */
    @ParameterizedTest
    @MethodSource("ranges")
    void shouldNotMultiplyBytes(String range) throws Exception {
        String answer = exchange("GET " + archivePath + " HTTP/1.1\r\nRange: bytes=" + range + "\r\n" + END);
        assertThat(answer).matches("(?s)HTTP/1\\.1 (200|206|400|416|431) .*").doesNotContain("multipart");
        assertThat(answer.length()).isLessThan(archive.length + 2000);
        assertTellsNothing(answer.substring(0, Math.min(answer.length(), 800)));
        assertStillServes();
    }

    @Test
    void shouldTakeNoMoreThanOneHeaderMayHold() throws Exception {
        String many =
                IntStream.range(0, 5000).mapToObj(i -> "X" + i + ": y\r\n").collect(Collectors.joining());
        for (String request : List.of(
                "GET /" + "a".repeat(20_000) + " HTTP/1.1\r\n" + END,
                "GET /m/?" + "a=b&".repeat(5000) + " HTTP/1.1\r\n" + END,
                "GET /m/ HTTP/1.1\r\nX: " + "a".repeat(20_000) + "\r\n" + END,
                "GET /m/ HTTP/1.1\r\n" + "X".repeat(20_000) + ": a\r\n" + END,
                "GET /m/ HTTP/1.1\r\nCookie: " + "a=b; ".repeat(5000) + "\r\n" + END,
                "GET /m/ HTTP/1.1\r\n" + many + END,
                "A".repeat(20_000))) {
            String answer = exchange(request);
            assertThat(answer).matches("(?s)(HTTP/1\\.1 (400|414|431) .*)?");
            assertTellsNothing(answer);
        }
        assertStillServes();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "GET\r\n\r\n",
                "GET /m/\r\n\r\n",
                "GET /m/ HTTP/9.9\r\nHost: h\r\n\r\n",
                "GET /m/ HTTP/1.1\r\n\r\n",
                "GET /m/ HTTP/1.1\r\nHost: h\r\nHost: i\r\nConnection: close\r\n\r\n",
                "GET /m/ HTTP/1.1\r\nHost: h/../x\r\nConnection: close\r\n\r\n",
                "GET /m/ HTTP/1.1\r\nHost : h\r\nConnection: close\r\n\r\n",
                "GET /m/ HTTP/1.1\r\n Host: h\r\nConnection: close\r\n\r\n",
                "GET /m/ HTTP/1.1\r\nHost: h\r\nX: a\r\n folded\r\nConnection: close\r\n\r\n",
                "GET /m/ HTTP/1.1\r\nHost: h\r\nX: a\0b\r\nConnection: close\r\n\r\n",
                "GET /m/ HTTP/1.1\r\nHost: h\r\n: empty\r\nConnection: close\r\n\r\n",
                "G\0T /m/ HTTP/1.1\r\nHost: h\r\nConnection: close\r\n\r\n",
                "\u0016\u0003\u0001\u0002\0\u0001\0\u0001\u00fc\u0003\u0003" + "\r\n\r\n",
                "PRI * HTTP/2.0\r\n\r\nXX\r\n\r\n",
                "\r\n\r\n\r\nNONSENSE\r\n\r\n",
                "POST /m/ HTTP/1.1\r\nHost: h\r\nContent-Length: -1\r\n\r\n",
                "POST /m/ HTTP/1.1\r\nHost: h\r\nContent-Length: 1, 2\r\n\r\n",
                "POST /m/ HTTP/1.1\r\nHost: h\r\nContent-Length: 99999999999999999999\r\n\r\n",
                "POST /m/ HTTP/1.1\r\nHost: h\r\nContent-Length: +5\r\n\r\nabcde",
                "POST /m/ HTTP/1.1\r\nHost: h\r\nTransfer-Encoding: chunked\r\nConnection: close\r\n\r\nzz\r\nabc\r\n0\r\n\r\n",
                "POST /m/ HTTP/1.1\r\nHost: h\r\nTransfer-Encoding: chunked\r\nConnection: close\r\n\r\nffffffffffffffffff\r\n",
                "POST /m/ HTTP/1.1\r\nHost: h\r\nTransfer-Encoding: chunked\r\nConnection: close\r\n\r\n-1\r\n\r\n",
                "POST /m/ HTTP/1.1\r\nHost: h\r\nTransfer-Encoding: gzip, nothing\r\nConnection: close\r\n\r\n",
                "POST /m/ HTTP/1.1\r\nHost: h\r\nExpect: the-unexpected\r\nContent-Length: 3\r\nConnection: close\r\n\r\nabc",
                "CONNECT h:80 HTTP/1.1\r\nHost: h\r\nConnection: close\r\n\r\n",
                "TRACE /m/ HTTP/1.1\r\nHost: h\r\nCookie: secret\r\nConnection: close\r\n\r\n"
            })
    void shouldRefuseWhatIsNoRequest(String request) throws Exception {
        String answer = exchange(request);
        assertThat(answer)
                .matches("(?s)(HTTP/1\\.1 (4\\d\\d|501|505) .*|.{0,64})")
                .doesNotContain("secret");
        assertTellsNothing(answer);
        assertStillServes();
    }

    /** What a proxy in front may take for the body of one request is never taken for another request. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "Content-Length: 6\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n",
                "Transfer-Encoding: chunked\r\nContent-Length: 6\r\n\r\n0\r\n\r\n",
                "Content-Length: 0\r\nContent-Length: 44\r\n\r\n",
                "Transfer-Encoding: chunked\r\nTransfer-Encoding: identity\r\n\r\n0\r\n\r\n",
                "Transfer-Encoding: xchunked\r\n\r\n0\r\n\r\n",
                "Transfer-Encoding : chunked\r\n\r\n0\r\n\r\n",
                "Transfer-Encoding: chunked\r\n\r\n0\n\n",
                "Transfer-Encoding: chunked\r\n\r\n1;\nx\r\n0\r\n\r\n"
            })
    void shouldNotTakeABodyForARequest(String rest) throws Exception {
        try (Socket socket = connect()) {
            send(socket, "POST /m/bumpy HTTP/1.1\r\nHost: h\r\n" + rest);
            send(socket, "GET /m/smuggled/manifest.json HTTP/1.1\r\nHost: h\r\n\r\n");
            socket.shutdownOutput();
            String answer = new String(readToEnd(socket), StandardCharsets.ISO_8859_1);
            assertThat(answer.split("HTTP/1\\.1 ", -1).length - 1).isLessThanOrEqualTo(1);
            assertThat(answer).matches("(?s)(HTTP/1\\.1 (4\\d\\d|501) .*)?");
        }
        assertStillServes();
    }

    @Test
    void shouldSurviveClientsThatGoAwayAnywhere() throws Exception {
        String request = "GET " + archivePath + " HTTP/1.1\r\nHost: h\r\nRange: bytes=0-\r\n\r\n";
        for (int length = 0; length <= request.length(); length += 5) {
            try (Socket socket = connect()) {
                send(socket, request.substring(0, length));
                if (length % 2 == 0) socket.setSoLinger(true, 0); // a reset instead of an end
            }
        }
        assertStillServes();
    }

    @Test
    void shouldHoldNoThreadForThoseWhoAskOnAndOnAndReadNothing() throws Exception {
        List<Socket> sockets = new ArrayList<>();
        try {
            for (int i = 0; i < 100; i++) {
                Socket socket = connect();
                sockets.add(socket);
                send(socket, pipelined(20));
                // Errors are small; they must not be waited for either.
                send(socket, "GET /m/bumpy/" + "0".repeat(64) + ".jsm HTTP/1.1\r\nHost: h\r\n\r\n");
            }
            assertStillServes();
            byte[] all = sockets.get(0).getInputStream().readNBytes(3 * archive.length);
            assertThat(indexOf(all, Arrays.copyOf(archive, 1000))).isPositive();
        } finally {
            for (Socket socket : sockets) socket.close();
        }
        assertStillServes();
    }

    private static int indexOf(byte[] text, byte[] part) {
        for (int i = 0; i + part.length <= text.length; i++) {
            if (Arrays.equals(text, i, i + part.length, part, 0, part.length)) return i;
        }
        return -1;
    }

    @Test
    void shouldNotWaitForBodiesThatNobodyWants() throws Exception {
        List<Socket> sockets = new ArrayList<>();
        try {
            // More than there are threads.
            for (int i = 0; i < 300; i++) {
                Socket socket = connect();
                sockets.add(socket);
                send(socket, "PUT /m/bumpy HTTP/1.1\r\nHost: h\r\nContent-Length: 5000\r\n\r\nno more");
            }
            assertStillServes();
        } finally {
            for (Socket socket : sockets) socket.close();
        }
    }
}
