package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.test.SampleModels;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A file gives the same mesh, notes and messages whether it is in memory or comes in portions. */
class StreamedReadingTest {
    private static final int VARIANTS = 60;

    @Test
    void shouldReadSamplesInPortionsAsInMemory() throws IOException {
        for (Path file : SampleModels.own()) {
            byte[] content = Files.readAllBytes(file);
            assertSame(file.getFileName().toString(), content, 1000);
            assertSame(file.getFileName().toString(), content, Integer.MAX_VALUE);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"ply", "obj", "stl", "off", "m"})
    void shouldReadWhatIsWrittenInPortionsAsInMemory(String extension) throws IOException {
        Path octopus = SampleModels.project().resolve("models/octopus.ply");
        Mesh mesh = ModelReader.read("octopus.ply", Files.readAllBytes(octopus), ResourceResolver.NONE)
                .mesh();
        MemoryFiles files = new MemoryFiles();
        String name = "octopus." + extension;
        ModelWriter.write(mesh, ModelFormat.ofName(name), name, files);
        assertSame(name, files.find(name).orElseThrow(), 4099);
    }

    /** As a file is that somebody writes anew meanwhile. */
    @ParameterizedTest
    @ValueSource(strings = {"ply", "obj", "stl"})
    void shouldTakeNoPartOfAFileForTheWhole(String extension) throws IOException {
        byte[] content = extension.equals("ply") ? plyText("\n") : extension.equals("stl") ? stlText("\n") : objText();
        String name = "a." + extension;
        ModelReader.read(name, new PortionedSource(content, 777), ResourceResolver.NONE);
        ByteSource cut = new ByteSource() {
            @Override
            public long length() {
                return content.length;
            }

            @Override
            public InputStream from(long offset) {
                int there = content.length * 3 / 4;
                return new ByteArrayInputStream(content, (int) offset, Math.max(0, there - (int) offset));
            }
        };
        assertThatThrownBy(() -> ModelReader.read(name, cut, ResourceResolver.NONE))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("cut");
    }

    private static byte[] objText() {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < 30_000; i++)
            text.append("v ").append(i).append(" 0 1\nv 0 ").append(i).append(" 0\nf 1 -1 -2\n");
        return text.toString().getBytes(StandardCharsets.US_ASCII);
    }

    @Test
    void shouldReadTextsOfManyLinesAndOfOne() throws IOException {
        for (String between : List.of("\n", "\r\n", "\r", " ")) {
            assertSame("a.ply", plyText(between), 777);
            if (!between.isBlank() || between.length() == 2 || between.equals("\n"))
                assertSame("a.stl", stlText(between), 777);
        }
    }

    /** More values than a window holds, all lines ended alike; the header's end in lines. */
    private static byte[] plyText(String between) {
        int count = 40_000;
        StringBuilder text = new StringBuilder("ply\nformat ascii 1.0\nelement vertex " + count
                + "\nproperty float x\nproperty float y\nproperty float z\nelement face " + (count - 2)
                + "\nproperty list uchar int vertex_indices\nend_header\n");
        for (int v = 0; v < count; v++)
            text.append(v % 97 / 8f).append(' ').append(v / 97).append(" -1e-3").append(between);
        for (int f = 0; f < count - 2; f++)
            text.append("3 ")
                    .append(f)
                    .append(' ')
                    .append(f + 1)
                    .append(' ')
                    .append(f + 2)
                    .append(between);
        return text.append("7 7").toString().getBytes(StandardCharsets.US_ASCII);
    }

    private static byte[] stlText(String end) {
        StringBuilder text = new StringBuilder("solid large" + end);
        for (int f = 0; f < 5000; f++) {
            text.append("facet normal 0 0 1").append(end).append("outer loop").append(end);
            for (int i = 0; i < 3; i++)
                text.append("vertex ")
                        .append(f + i)
                        .append(' ')
                        .append(f % 7 * i)
                        .append(" 0.5")
                        .append(end);
            text.append("endloop").append(end).append("endfacet").append(end);
        }
        return text.append("endsolid large").append(end).toString().getBytes(StandardCharsets.US_ASCII);
    }

    @Test
    void shouldReadAnObjWithALongLineAndAFillingOfNuls() throws IOException {
        StringBuilder text = new StringBuilder("#").append("-".repeat(600_000)).append("\n");
        for (int v = 0; v < 30_000; v++)
            text.append("v ").append(v % 173).append(' ').append(v / 173).append(" 0\n");
        text.append("f");
        for (int v = 0; v < 30_000; v++)
            text.append(v % 7 == 0 ? " \\\n " : " ").append(v + 1);
        text.append("\n#MRGB ff010203ff040506\n#MRGB ff0708\nf 1 2 3");
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        bytes.write(text.toString().getBytes(StandardCharsets.US_ASCII));
        bytes.write(new byte[150_000]);
        bytes.write(0x1A);
        assertSame("a.obj", bytes.toByteArray(), 1013);
        assertSame("b.obj", new byte[150_000], 1013);
    }

    @Test
    void shouldTellTheStartOfBinaryDataBehindACarriageReturn() throws IOException {
        for (String end : List.of("\r", "\r\n", "\n")) {
            String header = String.join(
                    end,
                    "ply",
                    "format binary_little_endian 1.0",
                    "element vertex 3",
                    "property uchar x",
                    "property uchar y",
                    "property uchar z",
                    "element face 1",
                    "property list uchar uchar vertex_indices",
                    "end_header");
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            bytes.write((header + end).getBytes(StandardCharsets.US_ASCII));
            bytes.write(new byte[] {10, 0, 0, 1, 0, 0, 0, 1, 0, 3, 0, 1, 2});
            assertSame("a.ply", bytes.toByteArray(), 1);
            bytes.write(5);
            assertSame("b.ply", bytes.toByteArray(), 2);
        }
    }

    @Test
    void shouldRefuseWhatIsDamagedInPortionsAsInMemory() throws IOException {
        Random random = new Random(18);
        for (Path seed : seeds()) {
            byte[] content = Files.readAllBytes(seed);
            String name = seed.getFileName().toString();
            assertSame(name, content, 1);
            for (int i = 0; i < VARIANTS; i++) assertSame(name, changed(content, random), 1 + random.nextInt(9));
        }
    }

    private static List<Path> seeds() throws IOException {
        Path folder = SampleModels.project().resolve("core/src/test/resources/org/jsmesh/mesh/io");
        try (Stream<Path> files = Files.walk(folder)) {
            List<Path> seeds = files.filter(Files::isRegularFile).sorted().toList();
            assertThat(seeds).hasSizeGreaterThan(10);
            return seeds;
        }
    }

    private static byte[] changed(byte[] content, Random random) {
        byte[] bytes = content.clone();
        for (int n = random.nextInt(4); n >= 0 && bytes.length > 1; n--) {
            int at = random.nextInt(bytes.length);
            int kind = random.nextInt(4);
            if (kind == 0) bytes = Arrays.copyOf(bytes, at);
            else if (kind == 1) bytes[at] = (byte) random.nextInt();
            else if (kind == 2) bytes[at] = (byte) "\n\r 0-9\\#\0".charAt(random.nextInt(9));
            else bytes = doubled(bytes, at, random.nextInt(bytes.length));
        }
        return bytes;
    }

    private static byte[] doubled(byte[] bytes, int a, int b) {
        byte[] more = Arrays.copyOf(bytes, bytes.length + Math.abs(a - b));
        System.arraycopy(bytes, Math.min(a, b), more, bytes.length, Math.abs(a - b));
        return more;
    }

    private static void assertSame(String name, byte[] content, int portion) throws IOException {
        ByteSource portioned = new PortionedSource(content, portion);
        assertThat(outcome(name, portioned)).isEqualTo(outcome(name, ByteSource.of(content)));
    }

    private static List<String> outcome(String name, ByteSource content) throws IOException {
        List<String> outcome = new ArrayList<>();
        try {
            ModelFile file = ModelReader.read(name, content, ResourceResolver.NONE);
            Mesh mesh = file.mesh();
            outcome.add(file.format() + " " + file.notes());
            outcome.add(mesh.faces() + " " + mesh.vertices() + " " + mesh.wedges() + " "
                    + mesh.materials().size());
            outcome.add(MeshIdentity.sha256(mesh));
            outcome.add(Integer.toString(Arrays.hashCode(mesh.positions())));
            outcome.add(Integer.toString(Arrays.hashCode(mesh.faceWedges())));
        } catch (ModelFormatException e) {
            outcome.add(e.getMessage());
        }
        return outcome;
    }

    @Test
    void shouldCloseWhatItOpensAlsoWhereAFileIsDamaged() throws IOException {
        byte[] whole = plyText("\n");
        for (byte[] content : List.of(whole, Arrays.copyOf(whole, whole.length / 2))) {
            List<String> open = new ArrayList<>();
            ByteSource source = new ByteSource() {
                @Override
                public long length() {
                    return content.length;
                }

                @Override
                public InputStream from(long offset) {
                    String name = "stream " + open.size();
                    open.add(name);
                    return new FilterInputStream(new PortionedSource(content, 5000).from(offset)) {
                        @Override
                        public void close() {
                            open.remove(name);
                        }
                    };
                }
            };
            outcome("a.ply", source);
            assertThat(open).isEmpty();
        }
    }
}
