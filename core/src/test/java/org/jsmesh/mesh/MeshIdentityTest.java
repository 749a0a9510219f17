package org.jsmesh.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class MeshIdentityTest {
    @ParameterizedTest
    @EnumSource
    void shouldNotDependOnOrderOrRotation(RandomMeshes kind) {
        Mesh mesh = kind.mesh(1);
        assertThat(MeshIdentity.sha256(shuffled(mesh))).isEqualTo(MeshIdentity.sha256(mesh));
    }

    @ParameterizedTest
    @EnumSource
    void shouldBeTheSameWithThePlatformsHash(RandomMeshes kind) throws NoSuchAlgorithmException {
        Mesh mesh = kind.mesh(3);
        MessageDigest digest = MessageDigest.getInstance("SHA-256");
        MeshIdentity.Hash platform = new MeshIdentity.Hash() {
            @Override
            public void update(byte[] bytes, int offset, int count) {
                digest.update(bytes, offset, count);
            }

            @Override
            public byte[] digest() {
                return digest.digest();
            }
        };
        assertThat(MeshIdentity.sha256(mesh, platform)).isEqualTo(MeshIdentity.sha256(mesh));
    }

    @ParameterizedTest
    @EnumSource
    void shouldDependOnEveryBitOfAPosition(RandomMeshes kind) {
        Mesh mesh = kind.mesh(1);
        float[] positions = mesh.positions().clone();
        int at = 3 * mesh.vertex(0, 1) + 1;
        positions[at] = Float.intBitsToFloat(Float.floatToRawIntBits(positions[at]) ^ 1);
        Mesh other = MeshBuilder.from(mesh).positions(positions).build();
        assertThat(MeshIdentity.sha256(other)).isNotEqualTo(MeshIdentity.sha256(mesh));
    }

    @ParameterizedTest
    @EnumSource
    void shouldDependOnOrientationAndMultiplicity(RandomMeshes kind) {
        Mesh mesh = kind.mesh(2);
        int f = 0;
        while (mesh.vertex(f, 0) == mesh.vertex(f, 1)
                || mesh.vertex(f, 1) == mesh.vertex(f, 2)
                || mesh.vertex(f, 0) == mesh.vertex(f, 2)) f++;
        int[] flipped = mesh.faceWedges().clone();
        flipped[3 * f] = mesh.faceWedges()[3 * f + 1];
        flipped[3 * f + 1] = mesh.faceWedges()[3 * f];
        assertThat(MeshIdentity.sha256(
                        MeshBuilder.from(mesh).faceWedges(flipped).build()))
                .isNotEqualTo(MeshIdentity.sha256(mesh));
        int[] doubled = java.util.Arrays.copyOf(mesh.faceWedges(), 3 * mesh.faces() + 3);
        System.arraycopy(mesh.faceWedges(), 0, doubled, 3 * mesh.faces(), 3);
        int[] materials = java.util.Arrays.copyOf(mesh.faceMaterials(), mesh.faces() + 1);
        materials[mesh.faces()] = materials[0];
        Mesh more = MeshBuilder.from(mesh)
                .faceWedges(doubled)
                .faceMaterials(materials)
                .build();
        assertThat(MeshIdentity.sha256(more)).isNotEqualTo(MeshIdentity.sha256(mesh));
    }

    private static Mesh shuffled(Mesh mesh) {
        Random random = new Random(9);
        List<Integer> order = new ArrayList<>();
        for (int v = 0; v < mesh.vertices(); v++) order.add(v);
        Collections.shuffle(order, random);
        float[] positions = new float[mesh.positions().length];
        for (int v = 0; v < mesh.vertices(); v++)
            System.arraycopy(mesh.positions(), 3 * v, positions, 3 * order.get(v), 3);
        int[] wedgeVertices = mesh.wedgeVertices().clone();
        for (int w = 0; w < wedgeVertices.length; w++) wedgeVertices[w] = order.get(wedgeVertices[w]);
        int[] faces = new int[mesh.faceWedges().length];
        int[] materials = new int[mesh.faces()];
        for (int f = 0; f < mesh.faces(); f++) {
            int to = mesh.faces() - 1 - f;
            int turn = random.nextInt(3);
            for (int j = 0; j < 3; j++) faces[3 * to + (j + turn) % 3] = mesh.faceWedges()[3 * f + j];
            materials[to] = mesh.faceMaterials()[f];
        }
        return MeshBuilder.from(mesh)
                .positions(positions)
                .wedgeVertices(wedgeVertices)
                .faceWedges(faces)
                .faceMaterials(materials)
                .build();
    }
}
