package org.jsmesh.session;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.zip.GZIPInputStream;

/**
 * Asks for a manifest. A server that has to encode the model first says how far that is (202); it is asked again until
 * the manifest is there. An answer may neither be endless nor stop coming.
 */
final class ManifestRequest {
    /** Hears how far a server is with a model that it has to encode first. */
    interface Preparing {
        /** @param fraction of the stage, 0 to 1 */
        void heard(String stage, double fraction);
    }

    private static final int LARGEST = 1 << 24;
    private static final int LEAST_BYTES_PER_MILLI = 1;
    private static final long FIRST_PAUSE_MILLIS = 250;

    private final HttpClient client;
    private final HttpRequest request;
    private final SteadyClock clock;
    private final Consumer<RequestReport> requests;
    private final Preparing preparing;
    private final long stallMillis;
    private final URI location;

    /** @param stallMillis that an answer may take, besides a millisecond for each byte */
    ManifestRequest(
            HttpClient client,
            HttpRequest.Builder request,
            SteadyClock clock,
            Consumer<RequestReport> requests,
            Preparing preparing,
            long stallMillis) {
        this.client = client;
        this.request = request.header("Accept", "application/json")
                .header("Accept-Encoding", "gzip")
                .build();
        this.clock = clock;
        this.requests = requests;
        this.preparing = preparing;
        this.stallMillis = stallMillis;
        location = this.request.uri();
    }

    byte[] read(BooleanSupplier cancelled) throws IOException {
        for (long pause = FIRST_PAUSE_MILLIS; ; pause *= 2) {
            HttpResponse<byte[]> response = ask(cancelled);
            int status = response.statusCode();
            long wait = HttpSource.retryAfterMillis(status, response.headers());
            if (status == 202) {
                tell(response);
                Waiting.pause(wait > 0 ? wait : Math.min(pause, 4000), cancelled);
                continue;
            }
            if (status == 200) return bounded(unpacked(response));
            String what = "the server answers " + status;
            if (status == 408 || status == 429 || status >= 500)
                throw FetchException.passing(location.toString(), what, "try again later", wait);
            throw FetchException.lasting(location.toString(), what, "check the address");
        }
    }

    private HttpResponse<byte[]> ask(BooleanSupplier cancelled) throws IOException {
        double start = clock.millis();
        BoundedBody body = new BoundedBody(LARGEST);
        CompletableFuture<HttpResponse<byte[]>> exchange = client.sendAsync(request, info -> body);
        BooleanSupplier late =
                () -> clock.millis() - start > stallMillis + (double) body.received() / LEAST_BYTES_PER_MILLI;
        HttpResponse<byte[]> response;
        try {
            response = Waiting.await(exchange, () -> cancelled.getAsBoolean() || late.getAsBoolean());
        } catch (CancellationException e) {
            if (cancelled.getAsBoolean() || !late.getAsBoolean()) throw e;
            throw FetchException.passing(location.toString(), "the answer does not come", "try again later", e);
        }
        double end = clock.millis();
        boolean byHttp2 = response.version() == HttpClient.Version.HTTP_2;
        requests.accept(new RequestReport(
                location.toString(), null, (long) start, (long) end, (long) end, response.body().length, byHttp2));
        return response;
    }

    private void tell(HttpResponse<byte[]> response) throws IOException {
        try {
            JsonNode state = new ObjectMapper().readTree(bounded(unpacked(response)));
            preparing.heard(
                    state.path("stage").asText("waiting"),
                    state.path("fraction").asDouble(0));
        } catch (com.fasterxml.jackson.core.JsonProcessingException e) {
            preparing.heard("waiting", 0);
        }
    }

    /** Reads at most a byte more than a manifest may have. */
    private byte[] unpacked(HttpResponse<byte[]> response) throws FetchException {
        String encoding = response.headers().firstValue("Content-Encoding").orElse("identity");
        if (!encoding.equalsIgnoreCase("gzip")) return response.body();
        try (GZIPInputStream in = new GZIPInputStream(new ByteArrayInputStream(response.body()))) {
            return in.readNBytes(LARGEST + 1);
        } catch (IOException e) {
            throw FetchException.passing(location.toString(), "is compressed badly", "try again later", e);
        }
    }

    private byte[] bounded(byte[] body) throws FetchException {
        if (body.length > LARGEST)
            throw FetchException.lasting(location.toString(), "is too large for a manifest", "check the address");
        return body;
    }
}
