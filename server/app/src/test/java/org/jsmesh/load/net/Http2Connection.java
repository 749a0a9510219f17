package org.jsmesh.load.net;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.eclipse.jetty.http.HttpField;
import org.eclipse.jetty.http.HttpFields;
import org.eclipse.jetty.http.HttpURI;
import org.eclipse.jetty.http.HttpVersion;
import org.eclipse.jetty.http.MetaData;
import org.eclipse.jetty.http2.ErrorCode;
import org.eclipse.jetty.http2.frames.DataFrame;
import org.eclipse.jetty.http2.frames.Frame;
import org.eclipse.jetty.http2.frames.GoAwayFrame;
import org.eclipse.jetty.http2.frames.HeadersFrame;
import org.eclipse.jetty.http2.frames.PingFrame;
import org.eclipse.jetty.http2.frames.PrefaceFrame;
import org.eclipse.jetty.http2.frames.PushPromiseFrame;
import org.eclipse.jetty.http2.frames.ResetFrame;
import org.eclipse.jetty.http2.frames.SettingsFrame;
import org.eclipse.jetty.http2.frames.WindowUpdateFrame;
import org.eclipse.jetty.http2.generator.Generator;
import org.eclipse.jetty.http2.hpack.HpackEncoder;
import org.eclipse.jetty.http2.hpack.HpackException;
import org.eclipse.jetty.http2.parser.Parser;
import org.eclipse.jetty.io.ByteBufferPool;
import org.eclipse.jetty.io.RetainableByteBuffer;

/**
 * HTTP/2 without encryption that is known beforehand, with windows like a browser's. A request is given up by a reset
 * of its stream, and the connection is used on.
 */
public final class Http2Connection implements ViewerConnection {
    private static final int LARGEST_HEAD = 16384;
    /** Of the connection before anything is granted; RFC 9113, 6.9.2. */
    private static final int FIRST_WINDOW = 65_535;

    private static final int LEAST_WINDOW = 1 << 18;
    /** Windows hold what the link carries in so many round trips, as browsers widen them where they hold it back. */
    private static final int TRIPS = 4;

    private final Listener listener;
    private final LinkedSocket socket;
    private final Parser parser = new Parser(ByteBufferPool.NON_POOLING, LARGEST_HEAD);
    private final Generator generator = new Generator(ByteBufferPool.NON_POOLING, false, 0);
    private final int windowBytes;
    private final ReceiveWindow connectionWindow;
    private final Set<Integer> cancelled = new HashSet<>();
    private int lastStream = -1;
    private boolean goesAway;
    // Of the request under way.
    private int stream;
    private ReceiveWindow window;
    private ResponseHead head;
    private long bodyLeft;

    /**
     * Starts to connect.
     *
     * @param source the viewer's own address
     * @throws IOException when that is refused at once
     */
    public Http2Connection(EventLoop loop, InetAddress source, InetSocketAddress target, Link link, Listener listener)
            throws IOException {
        this.listener = listener;
        windowBytes = (int) Math.max(LEAST_WINDOW, TRIPS * link.carries(link.roundTripMillis()));
        connectionWindow = new ReceiveWindow(windowBytes);
        socket = new LinkedSocket(loop, source, target, link, new LinkedSocket.Listener() {
            @Override
            public void onBytes(ByteBuffer bytes) {
                parser.parse(bytes);
            }

            @Override
            public void onBroken(String why) {
                listener.onBroken(why);
            }
        });
        parser.init(new Frames());
    }

    @Override
    public SocketAddress address() {
        return socket.address();
    }

    @Override
    public void send(RequestHead request) {
        if (stream != 0) throw new IllegalStateException("a request is under way");
        HttpFields.Mutable fields = HttpFields.build();
        request.fields().forEach(fields::put);
        HttpURI uri = HttpURI.from("http://" + request.host() + request.target());
        MetaData.Request get = new MetaData.Request("GET", uri, HttpVersion.HTTP_2, fields);
        boolean first = lastStream < 0;
        lastStream += 2;
        stream = lastStream;
        window = new ReceiveWindow(windowBytes);
        head = null;
        HeadersFrame headers = new HeadersFrame(stream, get, null, true);
        if (!first) {
            write(headers);
            return;
        }
        Map<Integer, Integer> settings =
                Map.of(SettingsFrame.ENABLE_PUSH, 0, SettingsFrame.INITIAL_WINDOW_SIZE, windowBytes);
        write(
                new PrefaceFrame(),
                new SettingsFrame(settings, false),
                new WindowUpdateFrame(0, windowBytes - FIRST_WINDOW),
                headers);
    }

    private void write(Frame... frames) {
        RetainableByteBuffer.DynamicCapacity bytes = new RetainableByteBuffer.DynamicCapacity();
        try {
            for (Frame frame : frames) generator.control(bytes, frame);
        } catch (HpackException e) {
            throw new IllegalStateException("a request that cannot be written", e);
        }
        socket.send(ByteBuffer.wrap(bytes.takeByteArray()));
    }

    @Override
    public void cancel() {
        if (stream == 0) return;
        cancelled.add(stream);
        write(new ResetFrame(stream, ErrorCode.CANCEL_STREAM_ERROR.code));
        stream = 0;
    }

    @Override
    public void close() {
        socket.close();
    }

    @Override
    public boolean isClosed() {
        return socket.isClosed() || goesAway && stream == 0;
    }

    private void broken(String why) {
        close();
        listener.onBroken(why);
    }

    private void grant(int id, ReceiveWindow granted) {
        int bytes = granted.grant();
        if (bytes > 0) write(new WindowUpdateFrame(id, bytes));
    }

    private void ended() {
        if (bodyLeft != 0) {
            broken("an answer that ends " + bodyLeft + " bytes before its end");
            return;
        }
        stream = 0;
        if (goesAway) close();
        listener.onEnd(head);
    }

    /** What the server sends. The parser goes on with what it has when the connection has been closed meanwhile. */
    private final class Frames implements Parser.Listener {
        @Override
        public void onHeaders(HeadersFrame frame) {
            int id = frame.getStreamId();
            if (socket.isClosed() || isOfCancelled(id, frame.isEndStream())) return;
            if (!(frame.getMetaData() instanceof MetaData.Response response)) {
                broken("trailers, or a request");
                return;
            }
            if (response.getStatus() / 100 == 1) return;
            if (head != null) {
                broken("two heads of one answer");
                return;
            }
            head = head(response);
            bodyLeft = head.length();
            if (bodyLeft < 0) {
                broken("an answer without a length, status " + head.status());
                return;
            }
            listener.onHead(head);
            if (frame.isEndStream() && !socket.isClosed() && stream == id) ended();
        }

        private ResponseHead head(MetaData.Response response) {
            Map<String, String> fields = new HashMap<>();
            for (HttpField field : response.getHttpFields())
                fields.put(field.getName().toLowerCase(Locale.ROOT), field.getValue());
            return new ResponseHead(response.getStatus(), fields);
        }

        @Override
        public void onData(DataFrame frame) {
            if (socket.isClosed()) return;
            int id = frame.getStreamId();
            int bytes = frame.remaining();
            if (!connectionWindow.take(frame.flowControlLength())) {
                broken("more bytes than the connection's window holds");
                return;
            }
            grant(0, connectionWindow);
            if (cancelled.contains(id)) listener.onLateBody(bytes);
            if (isOfCancelled(id, frame.isEndStream())) return;
            if (head == null || !window.take(frame.flowControlLength())) {
                broken(head == null ? "a body without a head" : "more bytes than the stream's window holds");
                return;
            }
            bodyLeft -= bytes;
            if (bodyLeft < 0) {
                broken("more bytes than its length says");
                return;
            }
            if (bytes > 0) listener.onBody(frame.getByteBuffer());
            if (socket.isClosed() || stream != id) return;
            if (frame.isEndStream()) ended();
            else grant(id, window);
        }

        /** Whether a frame belongs to a request that was given up, and not to the one under way. */
        private boolean isOfCancelled(int id, boolean last) {
            if (id == stream) return false;
            if (!cancelled.contains(id)) broken("a frame of stream " + id + ", which nobody asked for");
            if (last) cancelled.remove(id);
            return true;
        }

        @Override
        public void onReset(ResetFrame frame) {
            if (socket.isClosed() || isOfCancelled(frame.getStreamId(), true)) return;
            broken("the server reset the stream: " + ErrorCode.toString(frame.getError(), "" + frame.getError()));
        }

        @Override
        public void onSettings(SettingsFrame frame) {
            if (socket.isClosed() || frame.isReply()) return;
            Integer table = frame.getSettings().get(SettingsFrame.HEADER_TABLE_SIZE);
            if (table != null) {
                HpackEncoder encoder = generator.getHpackEncoder();
                encoder.setMaxTableCapacity(table);
                encoder.setTableCapacity(Math.min(table, encoder.getTableCapacity()));
            }
            write(new SettingsFrame(Map.of(), true));
        }

        @Override
        public void onPing(PingFrame frame) {
            if (!socket.isClosed() && !frame.isReply()) write(new PingFrame(frame.getPayload(), true));
        }

        @Override
        public void onGoAway(GoAwayFrame frame) {
            if (socket.isClosed()) return;
            goesAway = true;
            String why = "the server goes away: " + ErrorCode.toString(frame.getError(), "" + frame.getError());
            if (stream == 0 || stream > frame.getLastStreamId()) broken(why);
        }

        @Override
        public void onPushPromise(PushPromiseFrame frame) {
            if (!socket.isClosed()) broken("a push, which nobody wants");
        }

        @Override
        public void onStreamFailure(int id, int error, String reason) {
            if (!socket.isClosed()) broken("a frame of stream " + id + " that is wrong: " + reason);
        }

        @Override
        public void onConnectionFailure(int error, String reason) {
            if (!socket.isClosed()) broken("bytes that are no HTTP/2: " + reason);
        }
    }
}
