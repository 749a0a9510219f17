package org.jsmesh.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jsmesh.archive.Provenance;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.io.ModelFile;
import org.jsmesh.mesh.io.ModelFormat;
import org.jsmesh.mesh.io.ModelReader;
import org.jsmesh.mesh.io.ModelWriter;
import org.jsmesh.web.testing.Browser;
import org.jsmesh.web.testing.PageServer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The workshop in the browser writes the same files as the library on HotSpot, and encodes the same mesh. */
class WorkshopParityTest {
    private static final Path MODELS = Path.of("../../models");

    @TempDir
    static Path profile;

    @Test
    void shouldWriteTheSameFilesAndEncodeTheSameMesh() throws IOException {
        try (Browser browser = new Browser(profile);
                PageServer server = new PageServer()) {
            server.put("/blank.html", "<!doctype html><title>workshop</title><link rel=icon href=data:,>".getBytes());
            Mesh amphora = read("amphora.obj").mesh();
            byte[] painted = encode(amphora);
            server.put("/amphora.jsm", painted);
            byte[] coloured = encode(TestShapes.COLOURED.mesh());
            server.put("/coloured.jsm", coloured);
            for (String name : List.of("amphora.obj", "amphora.mtl", "amphora.png"))
                server.put("/" + name, Files.readAllBytes(MODELS.resolve(name)));
            browser.open(server.address("/blank.html"));
            for (String extension : List.of("obj", "ply", "stl", "off", "m"))
                assertThatFilesAgree(browser, painted, "amphora." + extension);
            for (String extension : List.of("ply", "stl"))
                assertThatFilesAgree(browser, coloured, "coloured." + extension);
            // TeaVM writes some tiny numbers with a digit more than they need.
            for (String extension : List.of("obj", "off", "m"))
                assertThatMeshesAgree(browser, coloured, "coloured." + extension);
            Map<String, byte[]> archive = made(browser, """
                    const given = [];
                    for (const path of ['amphora.obj', 'amphora.mtl', 'amphora.png'])
                      given.push({ path, file: await (await fetch('/' + path)).blob() });
                    const work = { model: 'amphora.obj', given, mostFaces: 20000 };
                    """);
            assertThat(archive).containsOnlyKeys("amphora.jsm");
            Mesh encoded = decode(archive.get("amphora.jsm"));
            assertThat(MeshIdentity.sha256(encoded)).isEqualTo(MeshIdentity.sha256(decode(painted)));
            assertThat(encoded.textures())
                    .singleElement()
                    .satisfies(picture ->
                            assertThat(picture.bytes()).isEqualTo(Files.readAllBytes(MODELS.resolve("amphora.png"))));
        }
    }

    private static void assertThatFilesAgree(Browser browser, byte[] archive, String fileName) throws IOException {
        Map<String, byte[]> expected = written(archive, fileName);
        Map<String, byte[]> files = decoded(browser, archive, fileName);
        assertThat(files.keySet()).as(fileName).isEqualTo(expected.keySet());
        expected.forEach((name, bytes) ->
                assertThat(Arrays.equals(files.get(name), bytes)).as(name).isTrue());
    }

    private static void assertThatMeshesAgree(Browser browser, byte[] archive, String fileName) throws IOException {
        Mesh expected = read(fileName, written(archive, fileName));
        Mesh mesh = read(fileName, decoded(browser, archive, fileName));
        assertThat(MeshIdentity.sha256(mesh)).as(fileName).isEqualTo(MeshIdentity.sha256(expected));
    }

    private static Map<String, byte[]> written(byte[] archive, String fileName) throws IOException {
        Map<String, byte[]> files = new LinkedHashMap<>();
        ModelWriter.write(
                decode(archive), ModelFormat.toWrite(fileName), fileName, name -> new ByteArrayOutputStream() {
                    @Override
                    public void close() {
                        files.put(name, toByteArray());
                    }
                });
        return files;
    }

    private static Map<String, byte[]> decoded(Browser browser, byte[] archive, String fileName) {
        String url = "/" + fileName.substring(0, fileName.indexOf('.')) + ".jsm";
        return made(
                browser,
                "const work = { place: { archiveUrl: new URL('%s', location.href).href }, bytes: %d, fileName: '%s' };"
                        .formatted(url, archive.length, fileName));
    }

    private static Mesh read(String fileName, Map<String, byte[]> files) throws IOException {
        return ModelReader.read(fileName, files.get(fileName), path -> Optional.ofNullable(files.get(path)))
                .mesh();
    }

    /** What the worker makes of the work that a script defines. */
    private static Map<String, byte[]> made(Browser browser, String work) {
        List<?> files = (List<?>) browser.call(work + """
                const worker = new Worker('/modules/page/local/workshop-worker.js', { type: 'module' });
                const made = new Promise((resolve, reject) => {
                  worker.onmessage = ({ data }) => {
                    if (data.error) reject(new Error(data.error));
                    else if (data.files) resolve(data); // others tell how far it is
                  };
                  worker.onerror = (event) => reject(new Error(event.message));
                });
                worker.postMessage(work);
                const { files } = await made;
                worker.terminate();
                return files.map(({ name, bytes }) => {
                  let text = '';
                  for (let at = 0; at < bytes.length; at += 4096) text += String.fromCharCode(...bytes.subarray(at, at + 4096));
                  return [name, btoa(text)];
                });
                """);
        Map<String, byte[]> made = new LinkedHashMap<>();
        for (Object file : files) {
            List<?> pair = (List<?>) file;
            made.put((String) pair.get(0), Base64.getDecoder().decode((String) pair.get(1)));
        }
        return made;
    }

    private static ModelFile read(String name) throws IOException {
        return ModelReader.read(name, Files.readAllBytes(MODELS.resolve(name)), path -> {
            Path file = MODELS.resolve(path);
            return Files.exists(file) ? Optional.of(Files.readAllBytes(file)) : Optional.empty();
        });
    }

    private static byte[] encode(Mesh mesh) {
        return new MeshEncoder(EncoderSettings.defaults())
                .encode(mesh, Provenance.NONE, List.of(), ProgressListener.NONE)
                .bytes();
    }

    private static Mesh decode(byte[] archive) throws IOException {
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(archive, 0, archive.length);
        assertThat(decoder.isComplete()).isTrue();
        return decoder.meshInOrder();
    }
}
