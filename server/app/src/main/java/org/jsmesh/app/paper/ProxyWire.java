package org.jsmesh.app.paper;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import org.jsmesh.session.link.ShapingPipe;

/** Servers in this process, behind proxies that keep to the rate of the link. */
final class ProxyWire implements Wire {
    /** After a pause, a link carries at once what it carries in so long, or so many bytes. */
    private static final int BURST_MILLIS = 2;

    private static final int BURST_BYTES = 160;

    private static final double OPEN = 1e12;

    private final PaperServer server;
    private final ShapingPipe archives;
    private final ShapingPipe text;

    ProxyWire(Path folder) throws IOException {
        server = PaperServer.start(folder, "127.0.0.1");
        ShapingPipe first = null;
        try {
            first = ShapingPipe.to(server.archives());
            text = ShapingPipe.to(server.text());
            archives = first;
        } catch (IOException | RuntimeException e) {
            try (server) {
                if (first != null) first.close();
            }
            throw e;
        }
    }

    @Override
    public void shape(LinkKind link) {
        double bytesPerSecond = link.bitsPerSecond() / 8;
        long burst = Math.max(BURST_MILLIS, Math.round(1000 * BURST_BYTES / bytesPerSecond));
        for (ShapingPipe pipe : new ShapingPipe[] {archives, text})
            pipe.bytesPerSecond(bytesPerSecond).delayMillis(link.delayMillis()).burstMillis(burst);
    }

    @Override
    public void open() {
        for (ShapingPipe pipe : new ShapingPipe[] {archives, text})
            pipe.bytesPerSecond(OPEN).delayMillis(0);
    }

    @Override
    public URI archives() {
        return archives.through(server.archives());
    }

    @Override
    public URI text() {
        return text.through(server.text());
    }

    @Override
    public long carriedBytes() {
        return archives.carriedBytes() + text.carriedBytes();
    }

    @Override
    public boolean hasRoundTrips() {
        return true;
    }

    @Override
    public String described() {
        return "a proxy in the measuring process keeps to the rate of the bytes of the connection, and holds requests"
                + " back for the round trip";
    }

    @Override
    public void close() throws IOException {
        try (server;
                text) {
            archives.close();
        }
    }
}
