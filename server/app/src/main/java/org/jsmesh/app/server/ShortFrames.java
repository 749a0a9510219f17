package org.jsmesh.app.server;

import org.eclipse.jetty.http2.HTTP2Session;
import org.eclipse.jetty.http2.api.Session;
import org.eclipse.jetty.http2.api.server.ServerSessionListener;
import org.eclipse.jetty.http2.frames.SettingsFrame;
import org.eclipse.jetty.http2.generator.Generator;
import org.eclipse.jetty.http2.server.HTTP2ServerConnectionFactory;
import org.eclipse.jetty.io.EndPoint;
import org.eclipse.jetty.server.Connector;
import org.eclipse.jetty.server.HttpConfiguration;

/**
 * HTTP/2 with short frames of data. Some clients, the JDK's among them, hand a frame on only when it has arrived whole:
 * see {@link ShortRecords}.
 */
final class ShortFrames extends HTTP2ServerConnectionFactory {
    /** Small enough for a record to hold a whole frame wherever it begins. */
    private static final int FRAME_BYTES = ShortRecords.RECORD_BYTES / 2 - 9;

    ShortFrames(HttpConfiguration configuration) {
        super(configuration);
    }

    @Override
    protected ServerSessionListener newSessionListener(Connector connector, EndPoint endPoint) {
        return new HTTPServerSessionListener(endPoint) {
            @Override
            public void onSettings(Session session, SettingsFrame frame) {
                shorten(session);
            }
        };
    }

    /** Call it when the client has said how long a frame may be. */
    static void shorten(Session session) {
        Generator generator = ((HTTP2Session) session).getGenerator();
        generator.setMaxFrameSize(Math.min(generator.getMaxFrameSize(), FRAME_BYTES));
    }
}
