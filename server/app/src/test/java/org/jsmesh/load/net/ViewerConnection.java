package org.jsmesh.load.net;

import java.net.SocketAddress;
import java.nio.ByteBuffer;

/** A connection of one viewer, with one request at a time. Used on its loop alone. */
public interface ViewerConnection {
    /** What arrives. After {@link #onBroken} nothing more does. */
    interface Listener {
        void onHead(ResponseHead head);

        /** Bytes of the body; whoever does not take them all skips them. */
        void onBody(ByteBuffer bytes);

        void onEnd(ResponseHead head);

        /** Bytes came of a body that was given up. */
        void onLateBody(int bytes);

        /** The connection is no more; also told when no request was under way. */
        void onBroken(String why);
    }

    /** The viewer's end, by which a proxy knows the connection. */
    SocketAddress address();

    /** Sends a request after a round trip; one more for the first, as the connection has to be made. */
    void send(RequestHead request);

    /** Gives up the request under way; of its answer nothing more is told. The connection may end with it. */
    void cancel();

    void close();

    /** Whether another request needs another connection. */
    boolean isClosed();
}
