package org.jsmesh.session.testing;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.Socket;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.jsmesh.session.link.ShapedLink;

/** One connection through a {@link ShapingProxy}, with a thread per direction. */
final class ProxyConnection {
    private static final String STATUS_AFTER = "HTTP/1.1 ";

    private final Socket client;
    private final Socket server;
    private final int number;
    private final ShapedLink link;
    private final ExchangeLog exchanges;
    private final LinkFaults faults;
    private final Queue<Integer> unanswered = new ConcurrentLinkedQueue<>();

    ProxyConnection(
            Socket client, Socket server, int number, ShapedLink link, ExchangeLog exchanges, LinkFaults faults) {
        this.client = client;
        this.server = server;
        this.number = number;
        this.link = link;
        this.exchanges = exchanges;
        this.faults = faults;
    }

    void start() {
        ShapingProxy.start("proxy-up-" + number, () -> run(this::requests));
        ShapingProxy.start("proxy-down-" + number, () -> run(this::answers));
    }

    private interface Direction {
        void copy() throws IOException;
    }

    private void run(Direction direction) {
        try {
            direction.copy();
        } catch (IOException e) {
            // one side broke: so does the other
        } finally {
            ShapingProxy.closeQuietly(client);
            ShapingProxy.closeQuietly(server);
        }
    }

    private void requests() throws IOException {
        InputStream in = client.getInputStream();
        OutputStream out = server.getOutputStream();
        HttpHeadReader head = new HttpHeadReader();
        byte[] buffer = new byte[8192];
        long body = 0;
        int n;
        while ((n = in.read(buffer)) > 0) {
            for (int i = 0; i < n; i++) {
                if (body > 0) body--;
                else if (head.accept(buffer[i])) {
                    body = head.length();
                    unanswered.add(exchanges.begin(number, head));
                }
            }
            link.delay();
            out.write(buffer, 0, n);
            out.flush();
        }
    }

    private void answers() throws IOException {
        InputStream in = server.getInputStream();
        OutputStream out = client.getOutputStream();
        HttpHeadReader head = new HttpHeadReader();
        byte[] buffer = new byte[16384];
        int exchange = -1;
        long body = 0;
        int headBytes = 0;
        int n;
        while ((n = in.read(buffer, 0, link.portion())) > 0) {
            int at = 0;
            while (at < n) {
                int from = at;
                if (body == 0) {
                    boolean complete = false;
                    while (at < n && !complete) {
                        if (faults.isHeadCut(headBytes)) {
                            out.write(buffer, from, at - from);
                            breakOff(out);
                            return;
                        }
                        if (isRefused()) refuse(buffer, at, headBytes);
                        headBytes++;
                        complete = head.accept(buffer[at++]);
                    }
                    if (complete) {
                        headBytes = 0;
                        exchange = answered(head);
                        body = head.length();
                    }
                } else {
                    int most = (int) Math.min(body, n - at);
                    int pass = passOn(exchange, most, buffer, at);
                    at += pass;
                    body -= pass;
                    if (pass < most) {
                        link.carry(at - from);
                        out.write(buffer, from, at - from);
                        breakOff(out);
                        return;
                    }
                }
                link.carry(at - from);
                out.write(buffer, from, at - from);
            }
            out.flush();
        }
    }

    /** The end of this connection: at once, or when the client loses patience. */
    private void breakOff(OutputStream out) throws IOException {
        out.flush();
        faults.keepSilent(client);
    }

    /** Makes a byte of a head one of a 500 that no cache keeps: {@code Cache-Control} gets another name. */
    private static void refuse(byte[] buffer, int at, int headBytes) {
        int digit = headBytes - STATUS_AFTER.length();
        if (digit >= 0 && digit < 3) buffer[at] = (byte) "500".charAt(digit);
        if (at >= 2 && buffer[at - 2] == '\n' && buffer[at - 1] == 'C' && buffer[at] == 'a') buffer[at] = 'X';
    }

    /** Whether the answer that begins is to be a 500. */
    private boolean isRefused() {
        return faults.isRefused(exchanges.get(unanswered.element()).target());
    }

    private int answered(HttpHeadReader head) {
        int status = Integer.parseInt(head.word(1));
        String range = head.field("content-range");
        long from = range == null || !range.startsWith("bytes ") || range.startsWith("bytes *")
                ? 0
                : Long.parseLong(range.substring(6, range.indexOf('-')));
        int exchange = unanswered.remove();
        exchanges.answered(exchange, status, from);
        return exchange;
    }

    private int passOn(int exchange, int bytes, byte[] buffer, int at) {
        int pass = faults.pass(bytes);
        ProxiedExchange e = exchanges.get(exchange);
        faults.spoil(buffer, at, pass, e.fromByte() + e.bodyBytes());
        exchanges.passed(exchange, pass);
        return pass;
    }
}
