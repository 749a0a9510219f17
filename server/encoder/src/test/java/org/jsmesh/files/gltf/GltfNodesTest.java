package org.jsmesh.files.gltf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.jsmesh.files.gltf.GltfChannels.position;

import java.io.IOException;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.io.ModelFile;
import org.jsmesh.mesh.io.ModelFormatException;
import org.junit.jupiter.api.Test;

/** Where nodes put meshes, how often, and under what names. */
class GltfNodesTest {
    private static String instanced(String attributes) {
        return "{\"mesh\":0,\"translation\":[0,0,5],\"extensions\":{\"EXT_mesh_gpu_instancing\":{\"attributes\":{"
                + attributes + "}}}}";
    }

    @Test
    void shouldExpandInstancesWhereTheyMoveTurnAndScaleTheMesh() throws IOException {
        GlbBuilder builder = GlbBuilder.triangle();
        int move = builder.floats("VEC3", 0, 0, 0, 10, 0, 0);
        // unit, and a half turn about z
        int turn = builder.bytes(5120, "VEC4", 2, ",\"normalized\":true", 0, 0, 0, 127, 0, 0, 127, 0);
        int scale = builder.floats("VEC3", 1, 1, 1, 2, 3, 1);
        builder.nodes(instanced("\"TRANSLATION\":" + move + ",\"ROTATION\":" + turn + ",\"SCALE\":" + scale));
        ModelFile file = builder.read();
        Mesh mesh = file.mesh();
        assertThat(mesh.faces()).isEqualTo(2);
        assertThat(position(mesh, 0, 1)).containsExactly(1., 0., 5.);
        assertThat(position(mesh, 1, 0)).containsExactly(10., 0., 5.);
        assertThat(position(mesh, 1, 1)).containsExactly(8., 0., 5.);
        assertThat(position(mesh, 1, 2)).containsExactly(10., -3., 5.);
        assertThat(file.notes())
                .containsExactly(Note.changed("1 repeat of meshes expanded: each is stored by itself.", 1, ""));
    }

    @Test
    void shouldWarnOfInstancesThatLoseTheirColours() throws IOException {
        GlbBuilder builder = GlbBuilder.triangle();
        int move = builder.floats("VEC3", 0, 0, 0);
        builder.nodes(instanced("\"TRANSLATION\":" + move + ",\"_COLOR_0\":" + move + ",\"_ID\":" + move));
        assertThat(builder.read().notes())
                .containsExactly(Note.dropped("Attributes of instances dropped: _COLOR_0, _ID.", 2, "_COLOR_0")
                        .asWarning());
    }

    @Test
    void shouldExpandNodesThatStandInTheSceneTwice() throws IOException {
        ModelFile file = GlbBuilder.triangle()
                .nodes(
                        "{\"children\":[1,2]},{\"children\":[3],\"translation\":[1,0,0]},{\"children\":[3]},{\"mesh\":0}")
                .read();
        assertThat(position(file.mesh(), 0, 0)).containsExactly(1., 0., 0.);
        assertThat(position(file.mesh(), 1, 0)).containsExactly(0., 0., 0.);
        assertThat(file.notes()).extracting(Note::count).containsExactly(1);
    }

    @Test
    void shouldRefuseAShortSceneOfEndlesslyManyNodes() {
        StringBuilder nodes = new StringBuilder();
        for (int level = 0; level < 60; level++) {
            int next = level + 1;
            nodes.append("{\"children\":[" + next + "," + next + "]},");
        }
        assertThatThrownBy(() ->
                        GlbBuilder.triangle().nodes(nodes + "{\"mesh\":0}").read())
                .isInstanceOf(ModelFormatException.class)
                .hasMessageContaining("more than 1000000 nodes");
    }

    @Test
    void shouldIgnoreTheTransformOfANodeWithASkin() throws IOException {
        ModelFile file = GlbBuilder.triangle()
                .nodes("{\"children\":[1],\"scale\":[9,9,9]},{\"mesh\":0,\"skin\":0,\"translation\":[100,0,0]}")
                .rest(",\"skins\":[{\"joints\":[0]}]")
                .read();
        assertThat(position(file.mesh(), 0, 1)).containsExactly(1., 0., 0.);
    }

    @Test
    void shouldFlattenAMeshThatItsNodeScalesToNothing() throws IOException {
        Mesh mesh = GlbBuilder.triangle()
                .nodes("{\"mesh\":0,\"scale\":[1,0,1]}")
                .read()
                .mesh();
        assertThat(mesh.faces()).isEqualTo(1);
        assertThat(position(mesh, 0, 2)).containsExactly(0., 0., 0.);
    }

    @Test
    void shouldNameFacesByNodesAndElseByMeshes() throws IOException {
        Mesh mesh = GlbBuilder.triangle()
                .nodes(
                        "{\"mesh\":0,\"children\":[1,2,3]},{\"mesh\":0,\"name\":\"wheel\"},{\"mesh\":0,\"name\":\"wheel\"},"
                                + "{\"mesh\":0,\"name\":\" \"}")
                .mesh(",\"name\":\"body\"")
                .read()
                .mesh();
        FaceChannel names = mesh.faceChannel(FaceChannel.OBJECT);
        assertThat(names.labels()).containsExactly("body", "wheel");
        assertThat(names.values()).containsExactly(0, 1, 1, 0);
    }

    @Test
    void shouldNameNoFacesOfAFileWithoutNames() throws IOException {
        assertThat(GlbBuilder.triangle().read().mesh().faceChannels()).isEmpty();
    }

    @Test
    void shouldReadTheSceneThatTheFileShows() throws IOException {
        GlbBuilder builder = GlbBuilder.triangle().nodes("{\"mesh\":0},{\"mesh\":0,\"translation\":[3,0,0]}],\"x\":[");
        String json = builder.gltf("a.bin")
                .replace("\"scene\":0", "\"scene\":1")
                .replace("[{\"nodes\":[0]}]", "[{\"nodes\":[0]},{\"nodes\":[1]}]");
        ModelFile file = GltfReader.read(
                "a.gltf",
                json.getBytes(java.nio.charset.StandardCharsets.UTF_8),
                path -> java.util.Optional.of(builder.binary()));
        assertThat(position(file.mesh(), 0, 0)).containsExactly(3., 0., 0.);
        assertThat(file.notes()).containsExactly(Note.unread("Of 2 scenes one read.", 1, ""));
    }

    @Test
    void shouldLeaveOutNodesThatTheFileHides() throws IOException {
        ModelFile file = GlbBuilder.triangle()
                .nodes(
                        "{\"mesh\":0,\"children\":[1]},{\"children\":[2],\"extensions\":{\"KHR_node_visibility\":{\"visible\":false}}},"
                                + "{\"mesh\":0}")
                .read();
        assertThat(file.mesh().faces()).isEqualTo(1);
        assertThat(file.notes()).containsExactly(Note.dropped("1 hidden node dropped.", 1, ""));
    }

    @Test
    void shouldRefuseAFileOfPointsAlone() {
        GlbBuilder builder = new GlbBuilder();
        builder.floats("VEC3", 0, 0, 0);
        assertThatThrownBy(() -> builder.primitive("{\"attributes\":{\"POSITION\":0},\"mode\":0}")
                        .read())
                .isInstanceOf(ModelFormatException.class)
                .hasMessageContaining("points or lines alone");
    }
}
