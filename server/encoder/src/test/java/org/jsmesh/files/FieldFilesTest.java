package org.jsmesh.files;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.io.ModelFormat;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The right result for each model of {@code files} in the {@link FieldFolder}: what its archive gives back, and notes.
 */
class FieldFilesTest {
    private static final List<Row> TABLE = List.of(
            far("far_from_origin.obj"),
            far("far_from_origin_double.ply"),
            cube("lf_header_crlf_end.ply"),
            cube("vt_vn_not_there.obj").note("(?i).*normals?.*|.*texture coordinates?.*|.*v[tn].*"),
            cube("vn_index_zero.obj").note("(?i).*normal.*").also(FieldChecks::oneNormalIsAbsent),
            cube("nan_in_unused_vertex.obj").note("(?i).*vert.*"),
            sphere("face_colours.ply").also(FieldChecks::hasAMaterialPerFaceColour),
            sphere("colours_ushort.ply").also(FieldChecks::hasColoursOf16Bits),
            sphere("colours_0_to_255.obj").also(FieldChecks::hasColoursUpTo255),
            cube("off_keyword_glued.off"),
            cube("lookup/mtl_other_case.obj").note("(?i).*paint\\.mtl.*").also(FieldChecks::hasItsTexture),
            cube("lookup/texture_other_case.obj").also(FieldChecks::hasItsTexture),
            new Row("materials/materials.obj", 6336, 148.6533, -1, -5.6, -1, 7.9, 1, 1)
                    .note(".*nowhere\\.png.*")
                    .also(FieldChecks::looksAsItsMaterialsSay),
            new Row("smoothing_groups.obj", 128, 22.68966, -.95106, -.95106, -1, 3.35106, .95106, 1)
                    .also(FieldChecks::isFacettedOnTheLeftAndSmoothOnTheRight),
            new Row("more_rows_than_counted.ply", 10, 5, 0, 0, 0, 1, 1, 1).note(".*\\b(2|two)\\b.*"),
            cube("scalars.ply").also(FieldChecks::hasScalars),
            cube("count_zero.stl").note("(?i).*(count|number of).*"),
            cube("unknown_header_line.ply").note(".*Created.*|(?i).*header line.*"),
            cube("gzipped.ply.gz"),
            cube("groups.obj").also(FieldChecks::hasGroups),
            cube("q13_this_macro.ply").also(FieldChecks::hasItsTexture),
            cube("测试模型.off"));

    /** Files beside the models that belong to them. */
    private static final Set<String> COMPANIONS = Set.of("README.md", "mtl", "png", "tga", "bmp");

    @TempDir
    private Path folder;

    /** What is right of one file; {@code also} looks at the mesh that its archive gives back. */
    record Row(String file, int faces, double area, double[] bounds, List<String> notes, List<Check> checks) {
        Row(String file, int faces, double area, double... bounds) {
            this(file, faces, area, bounds, List.of(), List.of());
        }

        Row note(String pattern) {
            return new Row(file, faces, area, bounds, List.of(pattern), checks);
        }

        Row also(Check check) {
            return new Row(file, faces, area, bounds, notes, List.of(check));
        }

        @Override
        public String toString() {
            return file;
        }
    }

    private interface Check {
        void accept(Mesh mesh) throws IOException;
    }

    private static Row cube(String file) {
        return new Row(file, 12, 6, 0, 0, 0, 1, 1, 1);
    }

    private static Row sphere(String file) {
        return new Row(file, 528, 12.38777, -1, -1, -1, 1, 1, 1);
    }

    private static Row far(String file) {
        return new Row(file, 12, 6e-6, 450000.123, 5411000.456, 312.789, 450000.124, 5411000.457, 312.790);
    }

    static List<Row> table() {
        return TABLE;
    }

    @Test
    void shouldKnowEveryModelOfTheFolder() throws IOException {
        Path files = FieldFolder.of("files");
        Set<String> found;
        try (Stream<Path> walk = Files.walk(files)) {
            found = walk.filter(Files::isRegularFile)
                    .map(files::relativize)
                    .map(PathNames::withSlashes)
                    .filter(name -> !COMPANIONS.contains(name.substring(name.lastIndexOf('.') + 1))
                            && !COMPANIONS.contains(name))
                    .collect(Collectors.toSet());
        }
        assertThat(found).isEqualTo(TABLE.stream().map(Row::file).collect(Collectors.toSet()));
    }

    @ParameterizedTest
    @MethodSource("table")
    void shouldGiveTheRightResult(Row row) throws IOException {
        Path file = FieldFolder.of("files").resolve(row.file);
        EncodedArchive archive = new ModelEncoding(EncoderSettings.defaults()).encode(file, ProgressListener.NONE);
        Mesh mesh = ArchiveFile.of(archive.bytes()).original(ProgressListener.NONE);
        assertThat(mesh.faces()).isEqualTo(row.faces);
        assertThat(FieldChecks.area(mesh)).isCloseTo(row.area, FieldChecks.near(row.area));
        double size = row.bounds[3] - row.bounds[0];
        assertThat(FieldChecks.bounds(mesh)).containsExactly(row.bounds, FieldChecks.near(size));
        List<String> texts = archive.notes().stream().map(Note::text).toList();
        for (String pattern : row.notes)
            assertThat(texts).as("notes").anySatisfy(text -> assertThat(text).matches(pattern));
        for (Check check : row.checks) check.accept(mesh);
    }

    @ParameterizedTest
    @MethodSource("table")
    void shouldProveTheFileAfterItCameBack(Row row) throws IOException {
        Path file = FieldFolder.of("files").resolve(row.file);
        Mesh read = ModelFiles.read(file).mesh();
        EncodedArchive archive = new ModelEncoding(EncoderSettings.defaults()).encode(file, ProgressListener.NONE);
        Mesh mesh = ArchiveFile.of(archive.bytes()).original(ProgressListener.NONE);
        assertThat(archive.header().meshSha256()).isEqualTo(MeshIdentity.sha256(mesh));
        assertThat(MeshIdentity.sha256(mesh)).isEqualTo(MeshIdentity.sha256(read));
    }

    /** What the written file says, for those where its text is part of the right result. */
    @Test
    void shouldWriteBackWhatItRead() throws IOException {
        assertThat(written("far_from_origin.obj", ModelFormat.OBJ)).contains("v 450000.123 5411000.456 312.789");
        assertThat(written("far_from_origin_double.ply", ModelFormat.PLY)).contains("property double x");
        assertThat(written("scalars.ply", ModelFormat.PLY))
                .contains("property float confidence", "property ushort label");
        assertThat(written("q13_this_macro.ply", ModelFormat.PLY)).containsPattern("comment TextureFile \\S+_A\\.png");
        assertThat(written("groups.obj", ModelFormat.OBJ)).contains("o Body", "g wheel left", "g wheel right", "s 1");
    }

    private String written(String name, ModelFormat format) throws IOException {
        Path file = FieldFolder.of("files").resolve(name);
        byte[] archive = new ModelEncoding(EncoderSettings.defaults())
                .encode(file, ProgressListener.NONE)
                .bytes();
        Path out = folder.resolve("out." + format.extension());
        ModelFiles.write(ArchiveFile.of(archive).original(ProgressListener.NONE), out, format);
        return new String(Files.readAllBytes(out), java.nio.charset.StandardCharsets.ISO_8859_1);
    }
}
