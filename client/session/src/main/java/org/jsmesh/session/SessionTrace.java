package org.jsmesh.session;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializationFeature;
import java.io.IOException;
import java.io.OutputStream;
import java.util.List;

/**
 * What a session did: a row per round and a row per request, both in time order. Its JSON has exactly these names.
 *
 * @param rounds in time order
 * @param requests in time order
 */
public record SessionTrace(List<RoundReport> rounds, List<RequestReport> requests) {
    /**
     * Copies the lists.
     *
     * @param rounds see {@link #rounds()}
     * @param requests see {@link #requests()}
     */
    public SessionTrace {
        rounds = List.copyOf(rounds);
        requests = List.copyOf(requests);
    }

    /**
     * Writes the trace as UTF-8 JSON and leaves the stream open.
     *
     * @param out takes the bytes
     * @throws IOException when they cannot be written
     */
    public void writeJson(OutputStream out) throws IOException {
        out.write(new ObjectMapper().enable(SerializationFeature.INDENT_OUTPUT).writeValueAsBytes(this));
        out.write('\n');
    }
}
