package org.jsmesh.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.zip.GZIPOutputStream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.io.ModelFile;
import org.jsmesh.mesh.io.ModelFormat;
import org.jsmesh.mesh.io.ModelFormatException;
import org.jsmesh.mesh.io.ResourceResolver;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Models that are packed by gzip or in a ZIP archive. */
class PackedModelTest {
    private static final String OFF = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    private static final String OBJ = "mtllib Chair.mtl\nusemtl wood\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    private static final String MTL = "newmtl wood\nKd 1 0 0\nmap_Kd tex\\wood.png\n";

    @TempDir
    Path folder;

    private static byte[] gzip(byte[] content) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (GZIPOutputStream packed = new GZIPOutputStream(out)) {
            packed.write(content);
        }
        return out.toByteArray();
    }

    private static byte[] zip(String... namesAndTexts) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (ZipOutputStream zip = new ZipOutputStream(out)) {
            for (int i = 0; i < namesAndTexts.length; i += 2) {
                zip.putNextEntry(new ZipEntry(namesAndTexts[i]));
                zip.write(namesAndTexts[i + 1].getBytes(StandardCharsets.UTF_8));
            }
        }
        return out.toByteArray();
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    private static ModelFile read(String name, byte[] content) throws IOException {
        return ModelFiles.read(name, content, ResourceResolver.NONE);
    }

    private static ModelFormatException refusal(String name, byte[] content) {
        return catchThrowableOfType(ModelFormatException.class, () -> read(name, content));
    }

    @ParameterizedTest
    @ValueSource(strings = {"a.off.gz", "a.OFF.GZ", "a.off", "a.gz", "body"})
    void shouldReadGzipWhateverTheName(String name) throws IOException {
        ModelFile file = read(name, gzip(bytes(OFF)));
        assertThat(file.format()).isEqualTo(ModelFormat.OFF);
        assertThat(file.mesh().faces()).isEqualTo(1);
    }

    @Test
    void shouldFindCompanionsBesideAGzipFile() throws IOException {
        Files.write(folder.resolve("chair.obj.gz"), gzip(bytes(OBJ)));
        Files.writeString(folder.resolve("Chair.mtl"), MTL);
        assertThat(ModelFiles.read(folder.resolve("chair.obj.gz"))
                        .mesh()
                        .materials()
                        .get(0)
                        .parameter("Kd"))
                .containsExactly(1, 0, 0);
    }

    @ParameterizedTest
    @CsvSource({
        "chair.obj,Chair.mtl,tex/wood.png",
        "chair/chair.obj,chair/Chair.mtl,chair/tex/wood.png",
        "chair/chair.obj,chair/chair.MTL,chair/TEX/Wood.PNG",
        "chair/chair.obj,chair/Chair.mtl,textures/wood.png",
        "a/b/chair.obj,a/b/Chair.mtl,a/b/wood.png"
    })
    void shouldReadTheModelOfAZipArchiveWithItsCompanions(String model, String library, String texture)
            throws IOException {
        byte[] content = zip(
                "__MACOSX/" + model,
                "x",
                model.replace("chair.obj", "._x.obj"),
                "x",
                "readme.txt",
                "x",
                model,
                OBJ,
                library,
                MTL,
                texture,
                "PNG");
        ModelFile file = read("chair.zip", content);
        assertThat(file.mesh().materials().get(0).name()).isEqualTo("wood");
        assertThat(file.mesh().textures())
                .singleElement()
                .satisfies(t -> assertThat(t.bytes()).isEqualTo(bytes("PNG")));
    }

    @Test
    void shouldReadWhatIsPackedTwice() throws IOException {
        byte[] off = gzip(bytes(OFF));
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (ZipOutputStream zip = new ZipOutputStream(out)) {
            zip.putNextEntry(new ZipEntry("a.off.gz"));
            zip.write(off);
        }
        assertThat(read("a.zip", out.toByteArray()).mesh().faces()).isEqualTo(1);
        assertThat(read("a.zip.gz", gzip(zip("a.off", OFF))).mesh().faces()).isEqualTo(1);
        assertThat(refusal("a.gz", gzip(gzip(off))).reason()).isEqualTo("the content is compressed with gzip");
    }

    @Test
    void shouldRefuseArchivesWithoutOneModel() throws IOException {
        assertThat(refusal("a.zip", zip("x.txt", "x")))
                .hasMessage(
                        "a.zip: the ZIP archive holds no model files. Pack one model with its materials and images.");
        assertThat(refusal("a.zip", zip("x/a.obj", "x", "b.ply", "y")).reason())
                .isEqualTo("the ZIP archive holds 2 model files (x/a.obj, b.ply)");
        assertThat(refusal("a.zip", Arrays.copyOf(zip("a.off", OFF), 60)).reason())
                .isEqualTo("the ZIP archive is damaged or cut off");
    }

    @ParameterizedTest
    @ValueSource(strings = {"../x.obj", "/etc/x.obj", "a/../../x.obj", "..\\x.obj"})
    void shouldLeadToNoFileOutsideOfTheArchive(String name) throws IOException {
        Files.writeString(folder.resolve("Chair.mtl"), MTL);
        Path zip = Files.write(folder.resolve("a.zip"), zip(name, OBJ.replace("Chair.mtl", "../Chair.mtl")));
        assertThat(ModelFiles.read(zip).mesh().materials().get(0).parameters()).isEmpty();
        assertThat(folder.resolve("x.obj")).doesNotExist();
    }

    @Test
    void shouldRefuseWhatUnpacksToMoreThanAllowed() throws IOException {
        ModelEncoding encoding = new ModelEncoding(EncoderSettings.defaults()).withMostBytes(1000);
        byte[] large = bytes(OFF + "#".repeat(1000));
        for (byte[] content : new byte[][] {gzip(large), zip("a.off", new String(large, StandardCharsets.UTF_8))}) {
            ModelFormatException refusal = catchThrowableOfType(
                    ModelFormatException.class,
                    () -> encoding.encode("a", content, ResourceResolver.NONE, ProgressListener.NONE));
            assertThat(refusal.reason()).endsWith("unpacks to more bytes than allowed");
        }
        byte[] companion = zip("chair.obj", OBJ, "Chair.mtl", MTL + "#".repeat(1000));
        ModelFormatException refusal = catchThrowableOfType(
                ModelFormatException.class,
                () -> encoding.encode("a.zip", companion, ResourceResolver.NONE, ProgressListener.NONE));
        assertThat(refusal).hasMessageStartingWith("a.zip, Chair.mtl: the ZIP archive unpacks to more bytes");
    }

    /** A model of 2 MB, of which gzip leaves three quarters. */
    private static byte[] large() {
        byte[] comment = new byte[2_000_000];
        Random random = new Random(1);
        for (int i = 0; i < comment.length; i++) comment[i] = (byte) ('0' + random.nextInt(64));
        return bytes(OFF + "#" + new String(comment, StandardCharsets.US_ASCII));
    }

    @Test
    void shouldCountAllLayersTogether() throws IOException {
        byte[] twice = gzip(gzip(large()));
        ModelEncoding encoding = new ModelEncoding(EncoderSettings.defaults());
        assertThat(encoding.withMostBytes(4_000_000)
                        .encode("a", twice, ResourceResolver.NONE, ProgressListener.NONE)
                        .bytes())
                .isNotEmpty();
        ModelFormatException refusal = catchThrowableOfType(
                ModelFormatException.class,
                () -> encoding.withMostBytes(3_000_000)
                        .encode("a", twice, ResourceResolver.NONE, ProgressListener.NONE));
        assertThat(refusal.reason()).endsWith("unpacks to more bytes than allowed");
    }

    @Test
    void shouldStopCountingWhenCancelled() throws IOException {
        byte[] content = gzip(large());
        AtomicInteger asked = new AtomicInteger();
        ProgressListener cancelling = new ProgressListener() {
            @Override
            public void progress(String stage, double fraction) {}

            @Override
            public boolean isCancelled() {
                return asked.getAndIncrement() > 0;
            }
        };
        ModelEncoding encoding = new ModelEncoding(EncoderSettings.defaults());
        assertThatThrownBy(() -> encoding.encode("a", content, ResourceResolver.NONE, cancelling))
                .isInstanceOf(CancellationException.class)
                .hasMessage("reading was cancelled");
    }

    @Test
    void shouldGiveAPackedModelTheArchiveOfTheModel() throws IOException {
        ModelEncoding encoding = new ModelEncoding(EncoderSettings.defaults());
        byte[] plain = encoding.encode("a.off", bytes(OFF), ResourceResolver.NONE, ProgressListener.NONE)
                .bytes();
        for (byte[] content : new byte[][] {gzip(bytes(OFF)), zip("a.off", OFF)}) {
            assertThat(encoding.encode("b", content, ResourceResolver.NONE, ProgressListener.NONE)
                            .bytes())
                    .isEqualTo(plain);
        }
    }

    @Test
    void shouldFindGzipFilesInFoldersAndNameTheirArchivesAfterTheModel() throws IOException {
        Files.write(folder.resolve("a.off.gz"), gzip(bytes(OFF)));
        Files.write(folder.resolve("b.txt.gz"), gzip(bytes("text")));
        Path out = folder.resolve("out");
        assertThat(EncodePlan.of(java.util.List.of(folder), out, e -> {}))
                .extracting(EncodeJob::output)
                .containsExactly(out.resolve("a.jsm"));
    }
}
