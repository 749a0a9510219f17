package org.jsmesh.s3.testing;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import software.amazon.awssdk.auth.credentials.AwsBasicCredentials;
import software.amazon.awssdk.auth.credentials.StaticCredentialsProvider;
import software.amazon.awssdk.http.urlconnection.UrlConnectionHttpClient;
import software.amazon.awssdk.regions.Region;
import software.amazon.awssdk.services.s3.S3Client;

/**
 * A service that speaks S3, in a process of its own, on this machine alone. One serves all tests of a JVM and ends with
 * that.
 */
public final class S3Mock {
    private static final Path JAR = Path.of("server/s3/target/s3mock/s3mock-exec.jar");
    private static final Pattern STARTED = Pattern.compile("started on ports? .*?(\\d+) \\(http\\)");
    private static final AtomicInteger BUCKETS = new AtomicInteger();

    private static S3Mock shared;

    private final URI endpoint;
    private final S3Client client;

    private S3Mock(URI endpoint) {
        this.endpoint = endpoint;
        client = S3Client.builder()
                .httpClientBuilder(UrlConnectionHttpClient.builder())
                .endpointOverride(endpoint)
                .forcePathStyle(true)
                .region(Region.US_EAST_1)
                .credentialsProvider(StaticCredentialsProvider.create(AwsBasicCredentials.create("a", "b")))
                .build();
    }

    /** Starts it at the first call, and tells the SDK in this JVM of it by system properties. */
    public static synchronized S3Mock shared() {
        try {
            if (shared == null) shared = start();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        System.setProperty("aws.endpointUrlS3", shared.endpoint.toString());
        System.setProperty("aws.accessKeyId", "a");
        System.setProperty("aws.secretAccessKey", "b");
        return shared;
    }

    private static S3Mock start() throws IOException {
        Path root = Files.createTempDirectory("jsm-s3mock");
        Process process = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-XX:TieredStopAtLevel=1",
                        "-XX:+UseSerialGC",
                        "-Xmx512m",
                        "-Djava.io.tmpdir=" + root,
                        "-jar",
                        jar().toString(),
                        "--server.address=127.0.0.1",
                        "--server.port=0",
                        "--com.adobe.testing.s3mock.http-port=0",
                        "--com.adobe.testing.s3mock.store.root=" + root.resolve("buckets"))
                .redirectErrorStream(true)
                .start();
        Runtime.getRuntime().addShutdownHook(new Thread(() -> end(process, root)));
        BufferedReader out = process.inputReader(StandardCharsets.UTF_8);
        StringBuilder said = new StringBuilder();
        for (String line; (line = out.readLine()) != null; ) {
            said.append(line).append('\n');
            Matcher started = STARTED.matcher(line);
            if (!started.find()) continue;
            drain(out);
            return new S3Mock(URI.create("http://127.0.0.1:" + started.group(1)));
        }
        throw new IOException("the S3 mock has ended:\n" + said);
    }

    private static void end(Process process, Path root) {
        process.destroyForcibly().onExit().join();
        try (Stream<Path> left = Files.walk(root)) {
            for (Path file : left.sorted(Comparator.reverseOrder()).toList()) Files.delete(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void drain(BufferedReader out) {
        Thread reader = new Thread(() -> out.lines().forEach(line -> {}), "s3mock output");
        reader.setDaemon(true);
        reader.start();
    }

    /** Tests of any module find it. */
    private static Path jar() throws IOException {
        for (Path folder = Path.of("").toAbsolutePath(); folder != null; folder = folder.getParent()) {
            if (Files.exists(folder.resolve(JAR))) return folder.resolve(JAR);
        }
        throw new IOException(JAR + " is missing. Build the module server/s3 before (mvn -pl server/s3 -am package)");
    }

    /** The address of the service. */
    public URI endpoint() {
        return endpoint;
    }

    /** Asks the service by other ways than the classes under test. */
    public S3Client client() {
        return client;
    }

    /** Makes an empty bucket; its name. */
    public String bucket() {
        String name = "bucket-" + ProcessHandle.current().pid() + "-" + BUCKETS.incrementAndGet();
        client.createBucket(b -> b.bucket(name));
        return name;
    }

    /** What tells the SDK of it in other processes. */
    public Map<String, String> environment() {
        return Map.of(
                "AWS_ENDPOINT_URL_S3",
                endpoint.toString(),
                "AWS_ACCESS_KEY_ID",
                "a",
                "AWS_SECRET_ACCESS_KEY",
                "b",
                "AWS_REGION",
                "us-east-1");
    }
}
