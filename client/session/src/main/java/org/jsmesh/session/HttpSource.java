package org.jsmesh.session;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpHeaders;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.time.Duration;
import java.util.Locale;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.plan.BatchRequest;

/**
 * An archive behind HTTP: addressed directly, or through a manifest. Asks for ranges with {@code If-Range}, or lets the
 * servlet's {@code patches} resource plan. Speaks HTTP/2 where the server offers it under TLS, else HTTP/1.1.
 */
final class HttpSource implements ArchiveSource {
    /** Nobody in front of a picture waits longer for one answer. */
    private static final int MOST_RETRY_SECONDS = 30;

    private static final Pattern HASHED = Pattern.compile("(.*/([0-9a-f]{64}))\\.jsm");
    private static final Pattern BATCHES = Pattern.compile("(?:.*/)?batches/(\\d{1,9})-(\\d{1,9})");

    private final HttpClient client;
    private final SteadyClock clock;
    private final boolean serverPlan;
    private final boolean http2;
    private final Consumer<RequestReport> requests;
    private final ManifestRequest.Preparing preparing;
    private final long stallMillis;
    private final URI location;
    private boolean throughManifest;
    private Manifest manifest;

    HttpSource(
            URI location,
            SessionOptions options,
            SteadyClock clock,
            Consumer<RequestReport> requests,
            ManifestRequest.Preparing preparing) {
        this.location = location;
        this.clock = clock;
        this.requests = requests;
        this.preparing = preparing;
        stallMillis = options.stallMillis();
        serverPlan = options.serverPlan();
        http2 = options.http2();
        throughManifest = location.getPath() != null && location.getPath().endsWith(".json");
        client = HttpClient.newBuilder()
                .followRedirects(HttpClient.Redirect.NORMAL)
                .connectTimeout(Duration.ofMillis(options.stallMillis()))
                .build();
    }

    @Override
    public void locate(BooleanSupplier cancelled) throws IOException {
        if (throughManifest && manifest == null) manifest = Manifest.parse(location, readManifest(cancelled));
    }

    @Override
    public URI address() {
        return archive();
    }

    @Override
    public boolean isRenewed(BooleanSupplier cancelled) throws IOException {
        if (manifest == null) return false;
        Manifest now = Manifest.parse(location, readManifest(cancelled));
        boolean renewed = !now.archiveSha256().equals(manifest.archiveSha256());
        manifest = now;
        return renewed;
    }

    private URI archive() {
        return manifest != null ? manifest.archive() : location;
    }

    /** The JDK's client would offer an upgrade to a server without TLS. RFC 9113 has given the upgrade up. */
    private HttpRequest.Builder request(URI address) {
        boolean offered = http2 && "https".equals(address.getScheme());
        return HttpRequest.newBuilder(address)
                .version(offered ? HttpClient.Version.HTTP_2 : HttpClient.Version.HTTP_1_1);
    }

    @Override
    public ArchiveBody open(long fromByte, long endByte, String entityTag) {
        HttpRequest.Builder request = request(archive()).header("Range", Ranges.header(fromByte, endByte));
        if (entityTag != null) request.header("If-Range", entityTag);
        return new HttpBody(request.build(), info -> head(info, fromByte), clock).send(client);
    }

    @Override
    public boolean isPlanning() {
        return serverPlan;
    }

    @Override
    public ArchiveBody openPlanned(BatchRequest plan) {
        Matcher m = HASHED.matcher(archive().getRawPath());
        String base = m.matches() ? m.group(1) : archive().getRawPath();
        String signed = archive().getRawQuery() == null ? "" : archive().getRawQuery() + "&";
        URI patches = archive()
                .resolve(base + "/patches?" + signed + "from=" + plan.fromBatch() + "&bytesPerSecond="
                        + plan.bytesPerSecond() + "&waitMillis=" + plan.waitMillis());
        return new HttpBody(request(patches).build(), info -> plannedHead(patches, info, plan), clock).send(client);
    }

    private ArchiveBody.Head plannedHead(URI patches, HttpResponse.ResponseInfo info, BatchRequest plan)
            throws IOException {
        if (info.statusCode() != 200) {
            if (info.statusCode() != 404) checkStatus(patches, info);
            throw FetchException.gone(
                    patches.toString(),
                    "the server answers " + info.statusCode(),
                    "it does not plan batches itself: let the client plan");
        }
        checkContent(patches, info.headers());
        Matcher m =
                BATCHES.matcher(info.headers().firstValue("Content-Location").orElse(""));
        if (m.matches() && Integer.parseInt(m.group(1)) != plan.fromBatch()) {
            throw FetchException.lasting(
                    patches.toString(),
                    "the server sent batches " + m.group(1) + "-" + m.group(2),
                    "let the client plan");
        }
        long length = info.headers().firstValueAsLong("Content-Length").orElse(-1);
        return new ArchiveBody.Head(plan.fromByte(), length < 0 ? -1 : plan.fromByte() + length, -1, null, true);
    }

    private ArchiveBody.Head head(HttpResponse.ResponseInfo info, long fromByte) throws IOException {
        HttpHeaders headers = info.headers();
        String tag = Ranges.strongTag(headers.firstValue("ETag").orElse(null));
        if (info.statusCode() == 416) {
            if (fromByte > 0)
                throw new ArchiveChangedException(archive().toString(), "byte " + fromByte + " lies behind its end");
            throw FetchException.lasting(archive().toString(), "is empty", "ask the publisher for the archive");
        }
        checkStatus(archive(), info);
        checkContent(archive(), headers);
        if (info.statusCode() == 206) {
            Ranges.ContentRange range =
                    Ranges.parse(headers.firstValue("Content-Range").orElse(""));
            if (range == null || range.fromByte() != fromByte) {
                throw FetchException.lasting(
                        archive().toString(),
                        "the server sent another range than asked for",
                        "use a server that answers one range as RFC 9110 says");
            }
            return new ArchiveBody.Head(fromByte, range.toByte(), range.archiveBytes(), tag, true);
        }
        long length = headers.firstValueAsLong("Content-Length").orElse(-1);
        return new ArchiveBody.Head(0, length, length, tag, false);
    }

    private static void checkStatus(URI uri, HttpResponse.ResponseInfo info) throws FetchException {
        int status = info.statusCode();
        if (status == 200 || status == 206) return;
        String what = "the server answers " + status;
        if (status == 408 || status == 429 || status >= 500)
            throw FetchException.passing(
                    uri.toString(), what, "try again later", retryAfterMillis(status, info.headers()));
        if (status == 404 || status == 410) throw FetchException.gone(uri.toString(), what, "check the address");
        throw FetchException.lasting(uri.toString(), what, "check the address and your rights");
    }

    /** How long a busy server asks for, or one that encodes, in milliseconds (RFC 9110, 10.2.3); dates are not read. */
    static long retryAfterMillis(int status, HttpHeaders headers) {
        if (status != 202 && status != 429 && status != 503) return 0;
        String seconds = headers.firstValue("Retry-After").orElse("").trim();
        if (!seconds.matches("[0-9]{1,9}")) return 0;
        return 1000L * Math.min(Integer.parseInt(seconds), MOST_RETRY_SECONDS);
    }

    private void checkContent(URI uri, HttpHeaders headers) throws FetchException {
        String encoding =
                headers.firstValue("Content-Encoding").orElse("identity").toLowerCase(Locale.ROOT);
        if (!encoding.equals("identity")) {
            throw FetchException.lasting(
                    uri.toString(),
                    "the server compresses the archive (" + encoding + ")",
                    "turn Content-Encoding off for .jsm files");
        }
        String type = headers.firstValue("Content-Type").orElse("").toLowerCase(Locale.ROOT);
        if (type.startsWith("text/html")) {
            throw FetchException.lasting(
                    uri.toString(),
                    "is a page, not an archive",
                    "give the address of a .jsm file or of a manifest.json");
        }
        if (type.startsWith("application/json") && !throughManifest) {
            throughManifest = true;
            throw FetchException.passing(uri.toString(), "is JSON", "it is read as a manifest", FetchException.AT_ONCE);
        }
    }

    private byte[] readManifest(BooleanSupplier cancelled) throws IOException {
        return new ManifestRequest(client, request(location), clock, requests, preparing, stallMillis).read(cancelled);
    }

    @Override
    public BatchIndex promisedIndex() {
        return manifest == null ? null : manifest.index();
    }

    @Override
    public String archiveSha256() {
        if (manifest != null) return manifest.archiveSha256();
        Matcher m = HASHED.matcher(location.getPath() == null ? "" : location.getPath());
        return m.matches() ? m.group(2) : null;
    }

    @Override
    public String meshSha256() {
        return manifest == null ? null : manifest.meshSha256();
    }

    @Override
    public String modelSha256() {
        return manifest == null ? null : manifest.modelSha256();
    }

    @Override
    public String name() {
        return location.toString();
    }
}
