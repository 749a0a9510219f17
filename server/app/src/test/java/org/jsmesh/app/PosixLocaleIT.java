package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * {@code jsm.jar} under the POSIX locale, in which Java takes file names for ASCII. It is the locale of services and
 * containers that set none.
 */
@EnabledOnOs(OS.LINUX)
@Timeout(180)
class PosixLocaleIT {
    private static final String TRIANGLE = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

    /** The names of a model, 测试模型.off, and of a folder, 模, as an address has them. */
    private static final String MODEL = "%E6%B5%8B%E8%AF%95%E6%A8%A1%E5%9E%8B.off";

    private static final String FOLDER = "%E6%A8%A1";

    @TempDir
    private Path folder;

    private Path models;

    @BeforeEach
    void writeModels() throws IOException {
        models = Files.createDirectory(folder.resolve("models"));
        Files.writeString(models.resolve("plain.off"), TRIANGLE);
        Files.writeString(in(models, MODEL), TRIANGLE);
        Files.writeString(Files.createDirectory(in(models, FOLDER)).resolve("inner.off"), TRIANGLE);
    }

    /** By an address, because the locale of the tests need not hold the name either. */
    private static Path in(Path place, String encodedName) {
        return Path.of(URI.create(place.toUri() + encodedName));
    }

    @Test
    void shouldServeTheOtherModelsAndNameThoseThatItSkips() throws Exception {
        Process server = start("LC_ALL=C", "serve", models.toString(), "--port", "0", "--cache", folder + "/cache");
        try (BufferedReader out = reader(server)) {
            List<String> said = new ArrayList<>();
            URI root = null;
            while (root == null) {
                String line = out.readLine();
                assertThat(line).as("the server ended, said %s", said).isNotNull();
                said.add(line);
                if (line.startsWith("http://")) root = URI.create(line);
            }
            assertThat(said).anySatisfy(line -> assertThat(line).contains(MODEL, "WARNING", "LC_ALL=C.UTF-8"));
            assertThat(said).anySatisfy(line -> assertThat(line).contains(FOLDER + "/:", "WARNING", "LC_ALL=C.UTF-8"));
            String catalogue = get(root.resolve("m/"));
            assertThat(new ObjectMapper().readTree(catalogue).findValuesAsText("id"))
                    .containsExactly("plain");
            assertThat(get(root.resolve("m/plain/manifest.json"))).contains("\"faces\":1");
        } finally {
            server.destroyForcibly();
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"LC_ALL=C", "LC_ALL=POSIX", "LANG="})
    void shouldEncodeTheOtherModelsAndNameThoseThatItSkips(String locale) throws Exception {
        Path archives = folder.resolve("archives");
        String said = run(1, locale, "encode", models.toString(), "-o", archives.toString());
        assertThat(said).contains(MODEL + ": is skipped", FOLDER + "/: is skipped", "Set a locale", "LC_ALL=C.UTF-8");
        assertThat(archives.resolve("plain.jsm")).isRegularFile();
        assertThat(archives.toFile().list()).containsExactly("plain.jsm");
    }

    @Test
    void shouldEncodeAllWhereTheLocaleHoldsTheNames() throws Exception {
        Path archives = folder.resolve("archives");
        run(0, "LC_ALL=C.UTF-8", "encode", models.toString(), "-o", archives.toString());
        assertThat(in(archives, MODEL.replace(".off", ".jsm"))).isRegularFile();
        assertThat(in(archives, FOLDER).resolve("inner.jsm")).isRegularFile();
    }

    @Test
    void shouldSayWhatIsWrongWhenNothingElseIsThere() throws Exception {
        Files.delete(models.resolve("plain.off"));
        String said = run(1, "LC_ALL=C", "encode", models.toString(), "-o", folder + "/archives");
        assertThat(said).contains(MODEL + ": is skipped", "holds no model file");
    }

    @Test
    void shouldSayWhatIsWrongWithAnArgument() throws Exception {
        // The shell gives the name's bytes, which no argument from here could hold in any locale.
        for (String command : List.of("encode \"$1\"/*.off -o x", "info \"$1\"/*.off")) {
            Files.deleteIfExists(models.resolve("plain.off"));
            Process process = process(
                    "LC_ALL=C", "sh", "-c", "exec \"$0\" -jar \"$2\" " + command, java(), models.toString(), jar());
            assertThat(await(2, process))
                    .contains("the locale of this process cannot hold this name", "LC_ALL=C.UTF-8");
        }
    }

    @Test
    void shouldLeaveModelsOfASiteThatItCannotName() throws Exception {
        Path site = folder.resolve("site");
        run(0, "LC_ALL=C.UTF-8", "encode", models.toString(), "--site", site.toString());
        String before = Files.readString(site.resolve("m/index.json"));
        assertThat(before).contains("plain", "测试模型-off-", "模--inner-off-");
        String said = run(1, "LC_ALL=C", "encode", models.toString(), "--site", site.toString(), "--prune");
        assertThat(said).contains("--prune takes nothing off the site");
        assertThat(site.resolve("m/index.json")).hasContent(before);
    }

    private static String run(int code, String locale, String... arguments) throws Exception {
        return await(code, start(locale, arguments));
    }

    private static String await(int code, Process process) throws Exception {
        try (BufferedReader out = reader(process)) {
            String said = String.join("\n", out.lines().toList());
            assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
            assertThat(process.exitValue()).as(said).isEqualTo(code);
            return said;
        } finally {
            process.destroyForcibly();
        }
    }

    private static BufferedReader reader(Process process) {
        return new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
    }

    private static Process start(String locale, String... arguments) throws IOException {
        List<String> line = new ArrayList<>(List.of(java(), "-jar", jar()));
        line.addAll(List.of(arguments));
        return process(locale, line.toArray(String[]::new));
    }

    private static Process process(String locale, String... line) throws IOException {
        ProcessBuilder builder = new ProcessBuilder(line).redirectErrorStream(true);
        builder.environment().keySet().removeIf(name -> name.startsWith("LC_") || name.equals("LANG"));
        String[] variable = locale.split("=", 2);
        builder.environment().put(variable[0], variable[1]);
        return builder.start();
    }

    private static String java() {
        return Path.of(System.getProperty("java.home"), "bin", "java").toString();
    }

    private static String jar() {
        return Path.of("target", "jsm.jar").toString();
    }

    private static String get(URI address) throws Exception {
        HttpRequest request = HttpRequest.newBuilder(address).build();
        List<HttpResponse<String>> answers = new ArrayList<>();
        // A model is encoded first.
        Await.until("an answer to " + address, () -> {
            answers.add(HttpClient.newHttpClient().send(request, HttpResponse.BodyHandlers.ofString()));
            return answers.get(answers.size() - 1).statusCode() != 202;
        });
        HttpResponse<String> answer = answers.get(answers.size() - 1);
        assertThat(answer.statusCode()).as(answer.body()).isEqualTo(200);
        return answer.body();
    }
}
