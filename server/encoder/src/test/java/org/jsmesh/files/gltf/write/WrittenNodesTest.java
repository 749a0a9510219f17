package org.jsmesh.files.gltf.write;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshComparison;
import org.jsmesh.mesh.UpAxis;
import org.junit.jupiter.api.Test;

/** Objects become nodes, and the place of the model one above them. */
class WrittenNodesTest {
    private static MeshBuilder strip(int... objects) {
        float[] positions = new float[3 * (objects.length + 2)];
        int[] faces = new int[3 * objects.length];
        for (int v = 0; v < objects.length + 2; v++) {
            positions[3 * v] = v;
            positions[3 * v + 1] = v % 2;
        }
        for (int i = 0; i < faces.length; i++) faces[i] = i / 3 + i % 3;
        return new MeshBuilder()
                .positions(positions)
                .faceWedges(faces)
                .faceChannels(List.of(new FaceChannel(
                        FaceChannel.OBJECT, 1, Channel.Type.INT32, objects, List.of("", "lid", "box"))));
    }

    @Test
    void shouldMakeANodeOfEachObject() throws IOException {
        Mesh mesh = strip(2, 2, 1, 0, 2).build();
        GlbFile file = GlbFile.of(mesh);
        assertThat(file.json().path("nodes"))
                .hasToString("[{\"name\":\"box\",\"mesh\":0},{\"name\":\"lid\",\"mesh\":1},{\"mesh\":2}]");
        assertThat(file.json().path("scenes")).hasToString("[{\"nodes\":[0,1,2]}]");
        assertThat(file.json().path("meshes").findValuesAsText("name")).containsExactly("box", "lid");
        assertThat(file.accessor(file.primitive(0).path("indices"))
                        .path("count")
                        .intValue())
                .isEqualTo(9);
        assertThat(MeshComparison.firstDifference(mesh, file.read())).isEmpty();
    }

    @Test
    void shouldTurnAllObjectsByOneNode() throws IOException {
        GlbFile file = GlbFile.of(strip(1, 2).build(), UpAxis.Z);
        assertThat(file.json().path("nodes"))
                .hasToString("[{\"matrix\":[1,0,0,0,0,0,-1,0,0,1,0,0,0,0,0,1],\"children\":[1,2]},"
                        + "{\"name\":\"lid\",\"mesh\":0},{\"name\":\"box\",\"mesh\":1}]");
        assertThat(file.json().path("scenes")).hasToString("[{\"nodes\":[0]}]");
        FaceChannel objects = file.read().faceChannel(FaceChannel.OBJECT);
        assertThat(List.of(objects.label(0), objects.label(1))).containsExactlyInAnyOrder("lid", "box");
    }

    @Test
    void shouldMoveAModelToItsPlaceExactly() throws IOException {
        double[] positions = {450000.125, 5400000.25, 30, 450001.125, 5400000.25, 30, 450000.125, 5400001.25, 30.5};
        Mesh mesh = new MeshBuilder()
                .positions(positions)
                .faceWedges(new int[] {0, 1, 2})
                .build();
        GlbFile file = GlbFile.of(mesh);
        assertThat(file.json().path("nodes").get(0).has("translation")).isTrue();
        assertThat(file.notes()).hasSize(1);
        assertThat(MeshComparison.firstDifference(mesh, file.read())).isEmpty();
    }

    @Test
    void shouldWriteAMeshWithoutFaces() throws IOException {
        GlbFile file =
                GlbFile.of(new MeshBuilder().positions(new float[] {1, 2, 3}).build());
        assertThat(file.json())
                .hasToString("{\"asset\":{\"version\":\"2.0\",\"generator\":\"jSM\"},\"scene\":0,\"scenes\":[{}]}");
    }
}
