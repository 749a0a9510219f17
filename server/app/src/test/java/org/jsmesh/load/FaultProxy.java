package org.jsmesh.load;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.util.Random;
import org.jsmesh.load.net.EventLoop;

/**
 * Stands between viewers and server, cuts some connections at a random byte and holds others for seconds. Lives on a
 * loop of its own.
 */
final class FaultProxy implements AutoCloseable {
    private static final int PIPE_BYTES = 16384;
    private static final double MOST_BYTES_BEFORE = 400_000;

    private final EventLoop loop;
    private final ServerSocketChannel listener;
    private final InetSocketAddress target;
    private final InjectedFaults faults;
    private final Random random;
    private final int faultPercent;
    private final double longestStallMillis;

    FaultProxy(InetSocketAddress target, InjectedFaults faults, LoadSettings settings) throws IOException {
        this.target = target;
        this.faults = faults;
        random = new Random(settings.seed());
        faultPercent = settings.faultPercent();
        longestStallMillis = 4 * settings.waitMillis();
        listener = ServerSocketChannel.open();
        listener.bind(new InetSocketAddress("127.0.0.1", 0), 1024);
        listener.configureBlocking(false);
        loop = new EventLoop("load-proxy");
        loop.submit(() -> {
            try {
                loop.register(listener, SelectionKey.OP_ACCEPT, key -> accept());
            } catch (IOException e) {
                throw new IllegalStateException(e);
            }
        });
    }

    InetSocketAddress address() throws IOException {
        return (InetSocketAddress) listener.getLocalAddress();
    }

    @Override
    public void close() {
        loop.close();
    }

    private void accept() {
        SocketChannel viewer = null;
        try {
            while ((viewer = listener.accept()) != null) new Pair(viewer);
        } catch (IOException e) {
            EventLoop.closeQuietly(viewer);
        }
    }

    /** A connection on each side. */
    private final class Pair {
        private final SocketChannel viewer;
        private final SocketChannel server = SocketChannel.open();
        private final SocketAddress address;
        private final SelectionKey viewerKey;
        private final SelectionKey serverKey;
        private final ByteBuffer up = ByteBuffer.allocate(PIPE_BYTES).flip();
        private final ByteBuffer down = ByteBuffer.allocate(PIPE_BYTES).flip();
        private long faultAfter = Long.MAX_VALUE;
        private boolean stall;
        private boolean held;
        private boolean closed;

        Pair(SocketChannel viewer) throws IOException {
            this.viewer = viewer;
            address = viewer.getRemoteAddress();
            if (random.nextInt(100) < faultPercent) {
                // Small counts as often as large ones: heads and first batches are to be hit too.
                faultAfter = (long) Math.pow(MOST_BYTES_BEFORE, random.nextDouble());
                stall = random.nextBoolean();
            }
            for (SocketChannel channel : new SocketChannel[] {viewer, server}) {
                channel.configureBlocking(false);
                channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
            }
            viewer.setOption(StandardSocketOptions.SO_SNDBUF, PIPE_BYTES);
            server.setOption(StandardSocketOptions.SO_RCVBUF, 1 << 16);
            InetAddress source = ((InetSocketAddress) address).getAddress();
            server.bind(new InetSocketAddress(source, 0));
            boolean connected = server.connect(target);
            viewerKey = loop.register(viewer, connected ? SelectionKey.OP_READ : 0, key -> ready());
            serverKey =
                    loop.register(server, connected ? SelectionKey.OP_READ : SelectionKey.OP_CONNECT, key -> ready());
        }

        private void ready() {
            if (closed) return;
            try {
                if (serverKey.isConnectable()) {
                    if (!server.finishConnect()) return;
                    serverKey.interestOps(SelectionKey.OP_READ);
                    viewerKey.interestOps(SelectionKey.OP_READ);
                }
                if (!held && server.isConnected()) pump();
            } catch (IOException e) {
                close(false);
            }
        }

        private void pump() throws IOException {
            boolean upWaits = copy(viewer, up, server, Integer.MAX_VALUE);
            if (closed) return;
            boolean downWaits = copy(server, down, viewer, (int) Math.min(faultAfter, Integer.MAX_VALUE));
            if (closed) return;
            if (faultAfter == 0) {
                fault();
                if (held || closed) return;
            }
            viewerKey.interestOps((upWaits ? 0 : SelectionKey.OP_READ) | (downWaits ? SelectionKey.OP_WRITE : 0));
            serverKey.interestOps((downWaits ? 0 : SelectionKey.OP_READ) | (upWaits ? SelectionKey.OP_WRITE : 0));
        }

        /** Copies what can be copied at once; true when bytes wait for the receiver. */
        private boolean copy(SocketChannel from, ByteBuffer pipe, SocketChannel to, int most) throws IOException {
            int left = most;
            while (true) {
                while (pipe.hasRemaining()) {
                    int limit = pipe.limit();
                    pipe.limit(pipe.position() + Math.min(pipe.remaining(), left));
                    int n = to.write(pipe);
                    pipe.limit(limit);
                    left -= n;
                    if (from == server && faultAfter != Long.MAX_VALUE) faultAfter -= n;
                    if (left == 0) return false;
                    if (n == 0) return true;
                }
                pipe.clear();
                int n = from.read(pipe);
                pipe.flip();
                if (n == 0) return false;
                if (n < 0) {
                    close(false);
                    return false;
                }
            }
        }

        private void fault() {
            faultAfter = Long.MAX_VALUE;
            if (!stall) {
                faults.proxyCuts.incrementAndGet();
                faults.mark(address, Double.POSITIVE_INFINITY);
                close(random.nextBoolean());
                return;
            }
            double until = EventLoop.millis() + (.1 + .9 * random.nextDouble()) * longestStallMillis;
            faults.proxyStalls.incrementAndGet();
            faults.mark(address, until);
            held = true;
            viewerKey.interestOps(0);
            serverKey.interestOps(0);
            loop.at(until, () -> {
                held = false;
                ready();
            });
        }

        private void close(boolean reset) {
            closed = true;
            try {
                if (reset) viewer.setOption(StandardSocketOptions.SO_LINGER, 0);
            } catch (IOException e) {
                // closing is all that is left to do
            }
            EventLoop.closeQuietly(viewer);
            EventLoop.closeQuietly(server);
        }
    }
}
