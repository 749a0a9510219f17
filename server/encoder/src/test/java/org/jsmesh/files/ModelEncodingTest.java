package org.jsmesh.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CancellationException;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.mesh.io.ByteSource;
import org.jsmesh.mesh.io.ModelFormat;
import org.jsmesh.mesh.io.ModelFormatException;
import org.jsmesh.mesh.io.ResourceResolver;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ModelEncodingTest {
    private static final String OBJ = "mtllib a.mtl\nusemtl m\no part\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 9 9 9\nf 1 2 3\n";

    private final ModelEncoding encoding = new ModelEncoding(EncoderSettings.defaults());

    @TempDir
    private Path folder;

    private Path model() throws IOException {
        Files.writeString(folder.resolve("a.mtl"), "newmtl m\nmap_Kd a.png\n");
        Files.write(folder.resolve("a.png"), new byte[] {1, 2, 3});
        return Files.writeString(folder.resolve("a.obj"), OBJ);
    }

    @Test
    void shouldTellOfItsStagesInOrder() throws IOException {
        Set<String> stages = new LinkedHashSet<>();
        encoding.write(model(), folder.resolve("a.jsm"), (stage, fraction) -> stages.add(stage));
        assertThat(stages).startsWith("reading", "textures", "cleaning").endsWith("writing");
    }

    @Test
    void shouldGiveTheNotesOfReaderAndEncoder() throws IOException {
        assertThat(encoding.encode(model(), ProgressListener.NONE).notes())
                .containsExactly(Note.dropped("1 vertex that no face refers to dropped.", 1, "vertex 3"));
    }

    @Test
    void shouldTakeAStream() throws IOException {
        EncodedArchive expected = encoding.encode(model(), ProgressListener.NONE);
        InputStream content = new ByteArrayInputStream(OBJ.getBytes(StandardCharsets.UTF_8));
        EncodedArchive archive = encoding.encode("a.obj", content, new FolderResources(folder), ProgressListener.NONE);
        assertThat(archive.bytes()).isEqualTo(expected.bytes());
    }

    @Test
    void shouldTakeBytesAndCompanionsFromAnywhere() throws IOException {
        EncodedArchive expected = encoding.encode(model(), ProgressListener.NONE);
        ResourceResolver companions = new FolderResources(folder);
        List<String> asked = new ArrayList<>();
        EncodedArchive archive = encoding.encode(
                "a.obj",
                OBJ.getBytes(StandardCharsets.UTF_8),
                path -> {
                    asked.add(path);
                    return companions.find(path);
                },
                ProgressListener.NONE);
        assertThat(asked).containsExactly("a.mtl", "a.png");
        assertThat(archive.bytes()).isEqualTo(expected.bytes());
        assertThat(archive.notes()).isEqualTo(expected.notes());
    }

    @Test
    void shouldTakeWhatIsNotInMemory() throws IOException {
        EncodedArchive expected = encoding.encode(model(), ProgressListener.NONE);
        byte[] content = OBJ.getBytes(StandardCharsets.UTF_8);
        ByteSource source = new ByteSource() {
            @Override
            public long length() {
                return content.length;
            }

            @Override
            public InputStream from(long offset) {
                return new ByteArrayInputStream(content, (int) offset, content.length - (int) offset);
            }
        };
        EncodedArchive archive = encoding.encode("a.obj", source, new FolderResources(folder), ProgressListener.NONE);
        assertThat(archive.bytes()).isEqualTo(expected.bytes());
    }

    @Test
    void shouldTellTheAxisThatPointsUpFromTheFormatUnlessItIsSaid() throws IOException {
        Path obj = model();
        Path glb = folder.resolve("a.glb");
        ModelFiles.write(ModelFiles.read(obj).mesh(), glb, ModelFormat.GLB);
        ModelEncoding said = new ModelEncoding(EncoderSettings.defaults().withUp(UpAxis.Z));
        assertThat(up(encoding, obj)).isEqualTo(UpAxis.UNKNOWN);
        assertThat(up(encoding, glb)).isEqualTo(UpAxis.Y);
        assertThat(up(said, obj)).isEqualTo(UpAxis.Z);
        assertThat(up(said, glb)).isEqualTo(UpAxis.Z);
    }

    private static UpAxis up(ModelEncoding encoding, Path model) throws IOException {
        return encoding.encode(model, ProgressListener.NONE).header().up();
    }

    @Test
    void shouldUseTheHelpersGiven() throws IOException {
        int[] tasks = {0};
        ModelEncoding helped = new ModelEncoding(EncoderSettings.defaults().withThreads(3)).withHelpers(task -> {
            tasks[0]++;
            task.run();
        });
        assertThat(helped.encode(model(), ProgressListener.NONE).bytes())
                .isEqualTo(encoding.encode(model(), ProgressListener.NONE).bytes());
        assertThat(tasks[0]).isPositive();
    }

    @Test
    void shouldRefuseMoreFacesThanAllowed() throws IOException {
        Path two = Files.writeString(folder.resolve("two.obj"), OBJ + "f 2 3 4\n");
        assertThatThrownBy(() -> encoding.withMostFaces(1).encode(two, ProgressListener.NONE))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("the model has 2 faces, more than the 1 allowed. Give a smaller model");
        assertThat(encoding.withMostFaces(2)
                        .encode(two, ProgressListener.NONE)
                        .header()
                        .faces())
                .isEqualTo(2);
        assertThatThrownBy(() -> encoding.withMostFaces(0)).hasMessageContaining("0");
    }

    @Test
    void shouldLeaveNothingBehindWhenItFails() throws IOException {
        Path archive = folder.resolve("out/a.jsm");
        Path bad = Files.writeString(folder.resolve("bad.obj"), "v 0 0\n");
        assertThatThrownBy(() -> encoding.write(bad, archive, ProgressListener.NONE))
                .isInstanceOf(ModelFormatException.class)
                .hasMessageContaining("line 1");
        assertThatThrownBy(() -> encoding.write(model(), archive, cancelledAt("writing")))
                .isInstanceOf(CancellationException.class);
        assertThat(archive.getParent()).doesNotExist();
        assertThatThrownBy(() -> encoding.write(model(), folder, cancelledAt("reading")))
                .isInstanceOf(FileSystemException.class)
                .hasMessageContaining("is a folder");
    }

    private static ProgressListener cancelledAt(String last) {
        return new ProgressListener() {
            @Override
            public void step(String stage, double fraction) {
                if (stage.equals(last)) throw new CancellationException(stage);
            }

            @Override
            public void progress(String stage, double fraction) {}
        };
    }
}
