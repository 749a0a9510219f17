package org.jsmesh.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.io.ModelFile;
import org.jsmesh.mesh.io.ModelFormatException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The right result for each model of {@code gltf} in the {@link FieldFolder}. Most are one sphere of radius 1. */
class FieldGltfTest {
    private static final double AREA = 12.43456;

    /** Reasons of those that are refused. */
    private static final Map<String, String> REFUSED = Map.of(
            "points.glb", "no triangles",
            "mode-7.glb", "no triangles",
            "required-unknown.glb", "ACME_mesh_folding",
            "draco-optional.glb", "KHR_draco_mesh_compression");

    private static final List<Row> TABLE = List.of(
            row("accessor-min-int").gltf("{}"),
            row("alpha-cutoff-null").gltf("{\"alphaMode\":\"MASK\",\"alphaCutoff\":0.9,.*}"),
            row("alphaMode-lower").gltf("{\"alphaMode\":\"BLEND\"}").note("Alpha modes.*blend.*"),
            row("anim-bad-interp").note("Animations dropped."),
            row("anim-pointer")
                    .note("Extensions not read: KHR_animation_pointer.")
                    .note("Animations dropped."),
            row("base-1ulp").gltf(".*\\[1,0.6,0.1,1\\].*").note("Values .*clamped.*baseColorFactor.*"),
            row("blend-texture").gltf(".*\"alphaMode\":\"BLEND\".*").images("image0.png"),
            row("bufferview-target-0"),
            row("camera-unused-type").note("Cameras dropped: camera 0."),
            row("clamp-nearest").gltf(".*\"wrapS\":33071,\"wrapT\":33648.*").images("image0.png"),
            row("colour-ushort").channel("COLOR_0", Channel.Type.UINT16),
            row("custom-attributes").channel("_TEMPERATURE", Channel.Type.FLOAT32),
            row("emissive").gltf("{\"emissiveFactor\":\\[0,1,0\\],.*"),
            row("empty-animations"),
            row("extension-textures")
                    .gltf(
                            ".*clearcoatTexture\":\\{\"index\":\\{\"source\":0.*sheenColorTexture\":\\{\"index\":\\{\"source\":1.*")
                    .images("image0.png", "image1.png"),
            row("factor-colour-linear").gltf(".*0.2159.*"),
            row("flip-scale-zero").area(-1).bounds(-1, 0, -1, 1, 0, 1),
            row("image-mime-webp").images("image0.png"),
            row("instanced-1000")
                    .faces(720_000)
                    .bounds(-1, -1, -1, 23.5, 23.5, 23.5)
                    .note("999 repeats of meshes expanded.*"),
            row("material-strength").gltf(".*\"emissiveStrength\":5.*"),
            row("mesh-weights-empty"),
            row("metadata")
                    .names("Body")
                    .gltf(".*\"extras\":\\{\"vendor\":\"v\"\\}.*")
                    .note("Cameras dropped: camera 0.")
                    .note("Extras dropped: asset, node 0, mesh 0.")
                    .note("Metadata of the file dropped: copyright 2026 Someone, CC-BY."),
            row("metal-minus0eps").gltf(".*\"metallicFactor\":0}}").note("Values .*clamped.*metallicFactor.*"),
            row("mixed-normals").faces(1440).bounds(-1, -1, -1, 3.5, 1, 1).absent("NORMAL"),
            row("mixed-uv")
                    .faces(1440)
                    .bounds(-1, -1, -1, 3.5, 1, 1)
                    .absent("TEXCOORD_0")
                    .images("image0.png"),
            row("morph-weight").note("Morph targets dropped."),
            row("mr-texture").gltf(".*metallicRoughnessTexture.*").images("image0.png"),
            row("name-duplicates").faces(1440).bounds(-1, -1, -1, 4, 1, 1),
            row("negative-scale").area(-1).bounds(2, -2, -1, 4, 2, 1),
            row("node-children-empty"),
            row("occlusion-strength-2")
                    .gltf(".*\"strength\":1}}")
                    .note("Values .*clamped.*")
                    .images("image0.png"),
            row("opaque-alpha").gltf("{\"alphaMode\":\"OPAQUE\".*"),
            row("rough-1ulp").gltf(".*\"roughnessFactor\":1}}").note("Values .*clamped.*roughnessFactor.*"),
            row("skin-node-transform").channel("JOINTS_0", Channel.Type.UINT8).note("Skins dropped.*"),
            row("specgloss-only")
                    .gltf(".*\"diffuseTexture\":\\{\"index\":\\{\"source\":0.*")
                    .images("image0.png"),
            row("tangents").channel("TANGENT", Channel.Type.FLOAT32),
            row("tex-blue").images("image0.png"),
            row("tex-red").images("image0.png"),
            row("texture-transform").gltf(".*\"rotation\":0.5.*").images("image0.png"),
            row("texture-transform-required").gltf(".*\"rotation\":0.5.*").images("image0.png"),
            row("two-scenes").note("Of 2 scenes one read."),
            row("unlit").gltf("{\"extensions\":\\{\"KHR_materials_unlit\":\\{}}.*"),
            row("uv1-only")
                    .gltf(".*\"texCoord\":1.*")
                    .channel("TEXCOORD_1", Channel.Type.FLOAT32)
                    .images("image0.png"),
            row("vertex-colour-linear").channel("COLOR_0", Channel.Type.FLOAT32),
            row("webp-as-source").images("image0.webp"),
            row("webp-fallback")
                    .gltf(".*\"EXT_texture_webp\":\\{\"source\":1}.*")
                    .images("image0.png", "image1.webp"),
            new Row("zero-extent3.obj", 12, 0, new double[6], List.of(), List.of(), List.of()));

    /** What is right of one file; an area below 0 is not looked at. */
    record Row(
            String file,
            int faces,
            double area,
            double[] bounds,
            List<String> notes,
            List<String> images,
            List<Check> checks) {
        Row faces(int count) {
            return new Row(file, count, AREA * count / 720, bounds, notes, images, checks);
        }

        Row area(double size) {
            return new Row(file, faces, size, bounds, notes, images, checks);
        }

        Row bounds(double... corners) {
            return new Row(file, faces, area, corners, notes, images, checks);
        }

        Row note(String pattern) {
            return new Row(file, faces, area, bounds, with(notes, pattern), images, checks);
        }

        Row images(String... paths) {
            return new Row(file, faces, area, bounds, notes, List.of(paths), checks);
        }

        Row gltf(String pattern) {
            String whole = pattern.startsWith("{") ? "\\" + pattern : pattern;
            return also(mesh -> assertThat(mesh.materials().get(0).gltf()).matches(whole));
        }

        Row channel(String name, Channel.Type type) {
            return also(mesh -> assertThat(named(mesh, name).type()).isEqualTo(type));
        }

        Row absent(String name) {
            return also(mesh -> {
                Channel channel = named(mesh, name);
                for (int c = 0; c < 3 * mesh.faces(); c++) {
                    boolean second = mesh.coordinate(mesh.vertex(c / 3, c % 3), 0) > 1.2;
                    assertThat(channel.isAbsent(mesh.faceWedges()[c])).isEqualTo(second);
                }
            });
        }

        Row names(String... labels) {
            return also(mesh ->
                    assertThat(mesh.faceChannel(FaceChannel.OBJECT).labels()).containsExactly(labels));
        }

        private Row also(Check check) {
            return new Row(file, faces, area, bounds, notes, images, with(checks, check));
        }

        private static <T> List<T> with(List<T> list, T more) {
            return Stream.concat(list.stream(), Stream.of(more)).toList();
        }

        @Override
        public String toString() {
            return file;
        }
    }

    private interface Check {
        void accept(Mesh mesh);
    }

    private static Row row(String name) {
        double[] bounds = {-1, -1, -1, 1, 1, 1};
        return new Row(name + ".glb", 720, AREA, bounds, List.of(), List.of(), List.of());
    }

    private static Channel named(Mesh mesh, String name) {
        return mesh.channels().stream()
                .filter(channel -> channel.name().equals(name))
                .findFirst()
                .orElseThrow(() -> new AssertionError("no channel " + name));
    }

    static List<Row> table() {
        return TABLE;
    }

    static Set<String> refused() {
        return REFUSED.keySet();
    }

    @Test
    void shouldKnowEveryModelOfTheFolder() throws IOException {
        Set<String> found;
        try (Stream<Path> list = Files.list(FieldFolder.of("gltf"))) {
            found = list.map(path -> path.getFileName().toString()).collect(Collectors.toSet());
        }
        Set<String> known = Stream.concat(TABLE.stream().map(Row::file), REFUSED.keySet().stream())
                .collect(Collectors.toSet());
        assertThat(found).isEqualTo(known);
    }

    @ParameterizedTest
    @MethodSource("table")
    void shouldGiveTheRightResult(Row row) throws IOException {
        ModelFile read = ModelFiles.read(FieldFolder.of("gltf").resolve(row.file));
        Mesh mesh = read.mesh();
        assertThat(mesh.faces()).isEqualTo(row.faces);
        if (row.area >= 0) assertThat(FieldChecks.area(mesh)).isCloseTo(row.area, FieldChecks.near(row.area));
        assertThat(FieldChecks.bounds(mesh))
                .containsExactly(row.bounds, FieldChecks.near(row.bounds[3] - row.bounds[0]));
        List<String> notes = read.notes().stream().map(Note::text).toList();
        assertThat(notes).hasSameSizeAs(row.notes);
        for (String pattern : row.notes)
            assertThat(notes).anySatisfy(text -> assertThat(text).matches(pattern));
        assertThat(mesh.textures()).extracting(t -> t.path()).containsExactlyElementsOf(row.images);
        for (Check check : row.checks) check.accept(mesh);
    }

    @ParameterizedTest
    @MethodSource("table")
    void shouldComeBackFromItsArchive(Row row) throws IOException {
        if (row.faces > 10_000) return; // the same as the others, for minutes
        Path file = FieldFolder.of("gltf").resolve(row.file);
        EncodedArchive archive = new ModelEncoding(EncoderSettings.defaults()).encode(file, ProgressListener.NONE);
        Mesh mesh = ArchiveFile.of(archive.bytes()).original(ProgressListener.NONE);
        assertThat(MeshIdentity.sha256(mesh))
                .isEqualTo(MeshIdentity.sha256(ModelFiles.read(file).mesh()));
    }

    @ParameterizedTest
    @MethodSource("refused")
    void shouldRefuseByName(String name) throws IOException {
        Path file = FieldFolder.of("gltf").resolve(name);
        assertThatThrownBy(() -> ModelFiles.read(file))
                .isInstanceOf(ModelFormatException.class)
                .hasMessageContaining(REFUSED.get(name));
    }

    @Test
    void shouldTurnFacesOutwardsWhereANodeMirrorsThem() throws IOException {
        Mesh mesh = ModelFiles.read(FieldFolder.of("gltf").resolve("negative-scale.glb"))
                .mesh();
        double volume = 0;
        for (int f = 0; f < mesh.faces(); f++) {
            double[][] p = new double[3][3];
            for (int i = 0; i < 9; i++) p[i / 3][i % 3] = mesh.coordinate(mesh.vertex(f, i / 3), i % 3);
            volume += p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1])
                    + p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2])
                    + p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
        }
        assertThat(volume / 6).isBetween(8., 8.4); // twice that of a sphere, a little less for its facets
    }
}
