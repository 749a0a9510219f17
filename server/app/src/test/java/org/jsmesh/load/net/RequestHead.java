package org.jsmesh.load.net;

import java.nio.charset.StandardCharsets;
import java.util.Map;

/**
 * A GET of either protocol.
 *
 * @param fields beside the host
 */
public record RequestHead(String host, String target, Map<String, String> fields) {
    /** As HTTP/1.1 writes it. */
    byte[] http1() {
        StringBuilder text = new StringBuilder("GET " + target + " HTTP/1.1\r\nHost: " + host + "\r\n");
        fields.forEach(
                (name, value) -> text.append(name).append(": ").append(value).append("\r\n"));
        return text.append("\r\n").toString().getBytes(StandardCharsets.ISO_8859_1);
    }
}
