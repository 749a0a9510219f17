package org.jsmesh.app.server;

import java.nio.ByteBuffer;
import java.util.concurrent.TimeUnit;
import javax.net.ssl.SSLEngine;
import javax.net.ssl.SSLEngineResult;
import javax.net.ssl.SSLException;
import org.eclipse.jetty.io.EndPoint;
import org.eclipse.jetty.io.ssl.SslConnection;
import org.eclipse.jetty.server.Connector;
import org.eclipse.jetty.server.SslConnectionFactory;
import org.eclipse.jetty.util.ssl.SslContextFactory;

/**
 * TLS with short records on connections that are slow or have just begun. A client can read a record only when it has
 * arrived whole. With records of 16 KiB a client at 256 kbit/s sees nothing for half a second, a quarter of its wait,
 * and then a lump. A connection that carries 8 Mbit/s gets the longest records, because they cost the server less.
 */
public final class ShortRecords extends SslConnectionFactory {
    public static final int RECORD_BYTES = 4096;
    /**
     * Least bytes within {@link #LOOK_NANOS} of a fast connection; more than the kernel takes at once from a slow one.
     */
    private static final int FAST_BYTES = 1 << 18;

    private static final long LOOK_NANOS = TimeUnit.MILLISECONDS.toNanos(250);

    ShortRecords(SslContextFactory.Server tls, String nextProtocol) {
        super(tls, nextProtocol);
    }

    @Override
    protected SslConnection newSslConnection(Connector connector, EndPoint endPoint, SSLEngine engine) {
        return new Connection(connector, endPoint, engine);
    }

    private final class Connection extends SslConnection {
        private long lookNanos = System.nanoTime();
        private long bytes;
        private boolean fast;

        Connection(Connector connector, EndPoint endPoint, SSLEngine engine) {
            super(
                    connector.getByteBufferPool(),
                    connector.getExecutor(),
                    getSslContextFactory(),
                    endPoint,
                    engine,
                    isDirectBuffersForEncryption(),
                    isDirectBuffersForDecryption());
        }

        @Override
        protected SSLEngineResult wrap(SSLEngine engine, ByteBuffer[] input, ByteBuffer output) throws SSLException {
            long now = System.nanoTime();
            if (now - lookNanos > LOOK_NANOS) {
                fast = bytes >= FAST_BYTES && now - lookNanos < 2 * LOOK_NANOS;
                bytes = 0;
                lookNanos = now;
            }
            SSLEngineResult result = fast ? engine.wrap(input, output) : wrapOne(engine, input, output);
            bytes += result.bytesConsumed();
            return result;
        }

        /** Shows the engine no more than goes into one short record. */
        private static SSLEngineResult wrapOne(SSLEngine engine, ByteBuffer[] input, ByteBuffer output)
                throws SSLException {
            int room = RECORD_BYTES;
            for (int i = 0; i < input.length; i++) {
                if (input[i].remaining() < room) {
                    room -= input[i].remaining();
                    continue;
                }
                int limit = input[i].limit();
                input[i].limit(input[i].position() + room);
                try {
                    return engine.wrap(input, 0, i + 1, output);
                } finally {
                    input[i].limit(limit);
                }
            }
            return engine.wrap(input, output);
        }
    }
}
