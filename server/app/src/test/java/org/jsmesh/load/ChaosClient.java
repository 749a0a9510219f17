package org.jsmesh.load;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.HttpTimeoutException;
import java.time.Duration;
import java.util.HexFormat;
import java.util.Random;
import java.util.TreeMap;
import java.util.concurrent.Callable;

/**
 * Downloads one model after the other, in ranges, and follows whatever the server says: come later, gone, changed. Only
 * two things are wrong: bytes that are not those that their address names, and an answer that never comes.
 */
final class ChaosClient implements Callable<ChaosClient> {
    private static final ObjectMapper JSON = new ObjectMapper();
    private static final Duration PATIENCE = Duration.ofSeconds(60);
    private static final int LARGEST_RANGE = 20_000;

    private final HttpClient client;
    private final URI models;
    private final String[] ids;
    private final Random random;
    private final long endNanos;

    final TreeMap<Integer, Integer> statuses = new TreeMap<>();
    int finished;
    int broken;
    String wrong;

    ChaosClient(HttpClient client, URI models, String[] ids, long seed, long endNanos) {
        this.client = client;
        this.models = models;
        this.ids = ids;
        this.endNanos = endNanos;
        random = new Random(seed);
    }

    @Override
    public ChaosClient call() throws InterruptedException {
        while (System.nanoTime() < endNanos && wrong == null) {
            try {
                String id = ids[random.nextInt(ids.length)];
                if (!download(id)) Thread.sleep(50 + random.nextInt(100));
            } catch (HttpTimeoutException e) {
                wrong = "an answer did not come within " + PATIENCE;
            } catch (IOException e) {
                broken++;
                Thread.sleep(100);
            }
        }
        return this;
    }

    /** Whether the whole archive has come; false when the server had something else to say. */
    boolean download(String id) throws IOException, InterruptedException {
        URI manifestAt = models.resolve(id + "/manifest.json");
        HttpResponse<byte[]> answer = get(manifestAt, null, null);
        if (answer.statusCode() != 200) return false;
        JsonNode manifest = JSON.readTree(answer.body());
        String sha256 = manifest.path("archiveSha256").asText();
        URI archiveAt = manifestAt.resolve(manifest.path("archiveUrl").asText());
        long length = manifest.path("bytes").asLong();
        ByteArrayOutputStream archive = new ByteArrayOutputStream();
        while (archive.size() < length) {
            long last = Math.min(length, archive.size() + 1L + random.nextInt(LARGEST_RANGE)) - 1;
            HttpResponse<byte[]> part = get(archiveAt, archive.size() + "-" + last, '"' + sha256 + '"');
            if (part.statusCode() != 206) return false;
            if (part.body().length != last + 1 - archive.size()) wrong = "a part of another length than announced";
            archive.writeBytes(part.body());
        }
        String got = HexFormat.of().formatHex(Model.newDigest().digest(archive.toByteArray()));
        if (!got.equals(sha256)) wrong = archiveAt + " gave the archive " + got;
        finished++;
        return wrong == null;
    }

    private HttpResponse<byte[]> get(URI uri, String range, String tag) throws IOException, InterruptedException {
        HttpRequest.Builder request = HttpRequest.newBuilder(uri).timeout(PATIENCE);
        if (range != null) request.header("Range", "bytes=" + range).header("If-Range", tag);
        HttpResponse<byte[]> answer = client.send(request.build(), HttpResponse.BodyHandlers.ofByteArray());
        statuses.merge(answer.statusCode(), 1, Integer::sum);
        return answer;
    }
}
