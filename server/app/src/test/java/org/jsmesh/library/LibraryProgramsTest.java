package org.jsmesh.library;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jsmesh.app.Bumpy;
import org.jsmesh.app.Cli;
import org.jsmesh.files.ArchiveFile;
import org.jsmesh.files.ModelFiles;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.test.SampleModels;
import org.jsmesh.test.source.JavaProgram;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The programs of {@code docs/library.md}, each in a process of its own. Those for Tomcat and Spring Boot are compiled
 * by a test of the servlet module, which has these on its class path.
 */
@Tag("slow")
class LibraryProgramsTest {
    private static final Path DOCUMENT = SampleModels.project().resolve("docs/library.md");
    private static final Path MODEL = SampleModels.project().resolve("models/amphora.obj");
    private static final Duration PATIENCE = Duration.ofSeconds(60);
    private static final Pattern CATALOGUE = Pattern.compile("the catalogue is at (\\S+)\\R");
    private static final Pattern BATCHES = Pattern.compile("(\\d+) batches: (\\d+) faces");

    /** The model as the command encodes it. */
    private static Path encoded;

    @TempDir
    private static Path shared;

    @TempDir
    private Path folder;

    @BeforeAll
    static void encode() {
        encoded = shared.resolve("amphora.jsm");
        Cli.ok("encode", MODEL, "-o", encoded);
    }

    @Test
    void shouldHoldNoProgramThatNoTestCompiles() throws Exception {
        assertThat(JavaProgram.in(DOCUMENT))
                .extracting(JavaProgram::name)
                .containsExactly(
                        "Encode",
                        "EncodeBytes",
                        "EncodeService",
                        "Decode",
                        "Serve",
                        "ServeByTomcat",
                        "ModelsConfiguration");
    }

    @Test
    void shouldEncodeAFileAsTheCommandDoes() throws Exception {
        Path archive = folder.resolve("archive.jsm");
        List<String> lines = run(compiled("Encode").process(folder, MODEL, archive), 0);
        assertThat(archive).hasSameBinaryContentAs(encoded);
        assertThat(ArchiveFile.read(archive).header().images()).isNotEmpty();
        assertThat(lines)
                .last()
                .isEqualTo(ModelFiles.read(MODEL).mesh().faces() + " faces, " + Files.size(encoded) + " bytes");
    }

    @Test
    @Tag("long")
    void shouldEncodeBytesAsTheCommandDoes() throws Exception {
        Path archive = folder.resolve("archive.jsm");
        ProcessBuilder process = compiled("EncodeBytes").process(folder, "amphora.obj", MODEL.getParent(), archive);
        assertThat(run(process.redirectInput(MODEL.toFile()), 0)).isEmpty();
        assertThat(archive).hasSameBinaryContentAs(encoded);
    }

    @Test
    void shouldEncodeForServicesAsTheCommandDoes() throws Exception {
        Path model = Bumpy.write(folder.resolve("torus.ply"), 60);
        Cli.ok("encode", model, "-o", folder.resolve("torus.jsm"));
        Path archive = folder.resolve("archive.jsm");
        assertThat(run(compiled("EncodeService").process(folder, model, archive), 0))
                .isEmpty();
        assertThat(archive).hasSameBinaryContentAs(folder.resolve("torus.jsm"));
    }

    @Test
    void shouldShowMoreFacesWithEveryBatchAndEndWithTheOriginal() throws Exception {
        List<String> lines = run(compiled("Decode").process(folder, encoded.toUri()), 0);
        int lastBatches = 0;
        int lastFaces = 0;
        for (String line : lines.subList(0, lines.size() - 1)) {
            Matcher shown = BATCHES.matcher(line);
            assertThat(shown.matches()).as(line).isTrue();
            assertThat(Integer.parseInt(shown.group(1))).as(line).isGreaterThan(lastBatches);
            assertThat(Integer.parseInt(shown.group(2))).as(line).isGreaterThanOrEqualTo(lastFaces);
            lastBatches = Integer.parseInt(shown.group(1));
            lastFaces = Integer.parseInt(shown.group(2));
        }
        ArchiveFile archive = ArchiveFile.read(encoded);
        assertThat(lines).hasSizeGreaterThan(archive.batches() / 4);
        assertThat(lines.get(0)).isNotEqualTo(lines.get(lines.size() - 2));
        assertThat(lastBatches).isEqualTo(archive.batches());
        assertThat(lastFaces).isEqualTo(ModelFiles.read(MODEL).mesh().faces());
        assertThat(lines)
                .last()
                .isEqualTo(MeshIdentity.sha256(ModelFiles.read(MODEL).mesh()) + " is the original");
    }

    @Test
    void shouldSayThatAnArchiveIsCut() throws Exception {
        byte[] half = Arrays.copyOf(Files.readAllBytes(encoded), (int) Files.size(encoded) / 2);
        Path cut = Files.write(folder.resolve("cut.jsm"), half);
        assertThat(run(compiled("Decode").process(folder, cut.toUri()), 1))
                .anyMatch(line -> line.endsWith("the archive is cut after " + half.length + " bytes"))
                .noneMatch(line -> line.contains("the original"));
    }

    @Test
    void shouldServeModelsInAJettyOfOnesOwn() throws Exception {
        Path models = Files.createDirectory(folder.resolve("models"));
        Files.copy(encoded, models.resolve("amphora.jsm"));
        ProcessBuilder builder = compiled("Serve").process(folder, models, 0);
        // The cache folder of whoever runs the tests is none of their business.
        for (String variable : List.of("XDG_CACHE_HOME", "LOCALAPPDATA"))
            builder.environment().put(variable, folder.toString());
        Path output = folder.resolve("output.txt");
        Process server = builder.redirectOutput(output.toFile()).start();
        try {
            URI catalogueAt = address(server, output);
            assertThat(catalogueAt.getHost()).isEqualTo("localhost");
            ObjectMapper json = new ObjectMapper();
            JsonNode catalogue = json.readTree(get(catalogueAt));
            URI manifestAt =
                    catalogueAt.resolve(catalogue.at("/models/0/manifestUrl").asText());
            JsonNode manifest = json.readTree(get(manifestAt));
            assertThat(get(manifestAt.resolve(manifest.get("archiveUrl").asText())))
                    .isEqualTo(Files.readAllBytes(encoded));
        } finally {
            server.destroyForcibly();
            assertThat(server.waitFor(PATIENCE.toSeconds(), TimeUnit.SECONDS)).isTrue();
        }
    }

    /** What the server says of itself as soon as it serves. */
    private static URI address(Process server, Path output) throws Exception {
        long end = System.nanoTime() + PATIENCE.toNanos();
        while (server.isAlive() && System.nanoTime() < end) {
            Matcher said = CATALOGUE.matcher(Files.readString(output));
            if (said.find()) return URI.create(said.group(1));
            Thread.sleep(20);
        }
        throw new AssertionError("no address: " + Files.readString(output));
    }

    private static byte[] get(URI address) throws Exception {
        HttpResponse<byte[]> answer = HttpClient.newHttpClient()
                .send(
                        HttpRequest.newBuilder(address).timeout(PATIENCE).build(),
                        HttpResponse.BodyHandlers.ofByteArray());
        assertThat(answer.statusCode()).as(address.toString()).isEqualTo(200);
        return answer.body();
    }

    private JavaProgram compiled(String name) throws IOException {
        JavaProgram program = JavaProgram.in(DOCUMENT, name);
        assertThat(program.compile(folder)).isEmpty();
        return program;
    }

    /** The lines that a program prints. */
    private List<String> run(ProcessBuilder builder, int code) throws Exception {
        Path output = folder.resolve("output.txt");
        Process process = builder.redirectOutput(output.toFile()).start();
        boolean ended = process.waitFor(PATIENCE.toSeconds(), TimeUnit.SECONDS);
        process.destroyForcibly();
        assertThat(ended).as(Files.readString(output)).isTrue();
        assertThat(process.exitValue()).as(Files.readString(output)).isEqualTo(code);
        return Files.readAllLines(output);
    }
}
