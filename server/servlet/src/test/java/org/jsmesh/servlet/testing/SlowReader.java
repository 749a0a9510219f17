package org.jsmesh.servlet.testing;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.URI;
import java.nio.charset.StandardCharsets;

/** A client that asks for much and reads when it is told to. */
public final class SlowReader implements AutoCloseable {
    private final Socket socket = new Socket();

    /** Sends the request and reads nothing. */
    public SlowReader(URI root, String path) throws IOException {
        this(root, path, 1);
    }

    /** Sends the request several times at once. */
    public SlowReader(URI root, String path, int times) throws IOException {
        // A small window, so that the server cannot leave the answer with the kernel.
        socket.setReceiveBufferSize(8 << 10);
        socket.connect(new InetSocketAddress(root.getHost(), root.getPort()));
        socket.setSoTimeout(30_000);
        String first = "GET /" + path + " HTTP/1.1\r\nHost: test\r\n\r\n";
        String last = "GET /" + path + " HTTP/1.1\r\nHost: test\r\nConnection: close\r\n\r\n";
        String request = first.repeat(times - 1) + last;
        socket.getOutputStream().write(request.getBytes(StandardCharsets.US_ASCII));
    }

    /** The status line and the fields, read byte by byte so that nothing of the body is taken. */
    public String header() throws IOException {
        StringBuilder text = new StringBuilder();
        InputStream in = socket.getInputStream();
        while (text.indexOf("\r\n\r\n") < 0) {
            int next = in.read();
            if (next < 0) throw new IOException("the answer ends in its header: " + text);
            text.append((char) next);
        }
        return text.toString();
    }

    /** Everything that comes until the connection is closed or cut. */
    public byte[] body() {
        ByteArrayOutputStream body = new ByteArrayOutputStream();
        byte[] block = new byte[1 << 16];
        try {
            InputStream in = socket.getInputStream();
            for (int n = in.read(block); n >= 0; n = in.read(block)) body.write(block, 0, n);
        } catch (IOException e) {
            // Cut; what came before counts.
        }
        return body.toByteArray();
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }
}
