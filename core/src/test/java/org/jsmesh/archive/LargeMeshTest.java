package org.jsmesh.archive;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.ProgressListener;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Large enough for vertices and faces to get new numbers on the way, twice. */
@Tag("slow")
class LargeMeshTest {
    private static final int AROUND = 300;
    private static final int ALONG = 120;

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void shouldComeBack(boolean attributes) throws Exception {
        Mesh mesh = torus(attributes);
        byte[] bytes = TestArchives.encode(mesh).bytes();
        ArchiveDecoder decoder = TestArchives.decode(bytes, bytes.length);
        assertThat(MeshIdentity.sha256(decoder.mesh())).isEqualTo(MeshIdentity.sha256(mesh));
    }

    @Test
    void shouldComeBackFromALargeBase() throws Exception {
        Mesh mesh = torus(false);
        EncoderSettings settings = EncoderSettings.defaults().withBaseFaces(30_000);
        byte[] bytes =
                new MeshEncoder(settings).encode(mesh, ProgressListener.NONE).bytes();
        ArchiveDecoder decoder = TestArchives.decode(bytes, bytes.length);
        assertThat(decoder.header().batches().faces(0)).isBetween(29_998, 30_000);
        assertThat(MeshIdentity.sha256(decoder.mesh())).isEqualTo(MeshIdentity.sha256(mesh));
    }

    @Test
    void shouldShowMorePreciseMeshesWithEveryBatch() throws Exception {
        byte[] bytes = TestArchives.encode(torus(false)).bytes();
        BatchIndex index = TestArchives.decode(bytes, bytes.length).header().batches();
        int last = index.size() - 1;
        assertThat(index.precisionBits(0)).isBetween(4, 10);
        assertThat(index.precisionBits(last)).isEqualTo(32);
        for (int i = 1; i <= last; i++) {
            assertThat(index.precisionBits(i)).isGreaterThanOrEqualTo(index.precisionBits(i - 1));
            assertThat(index.errorMean(i)).isLessThanOrEqualTo(index.errorMean(i - 1));
            if (index.kind(i) == BatchKind.PRECISION) assertThat(index.faces(i)).isEqualTo(index.faces(i - 1));
        }
    }

    /** A bumpy torus with decimal coordinates; perhaps with colours of vertices and two materials. */
    private static Mesh torus(boolean attributes) {
        float[] positions = new float[3 * AROUND * ALONG];
        int[] faces = new int[6 * AROUND * ALONG];
        int[] colours = new int[3 * AROUND * ALONG];
        int[] materials = new int[2 * AROUND * ALONG];
        int at = 0;
        for (int j = 0; j < ALONG; j++) {
            for (int i = 0; i < AROUND; i++) {
                double u = 2 * Math.PI * i / AROUND;
                double v = 2 * Math.PI * j / ALONG;
                double r = .4 + .05 * Math.sin(9 * u) * Math.cos(4 * v);
                int a = j * AROUND + i;
                positions[3 * a] = Math.round((1 + r * Math.cos(v)) * Math.cos(u) * 1e5) / 1e5f;
                positions[3 * a + 1] = Math.round(r * Math.sin(v) * 1e5) / 1e5f;
                positions[3 * a + 2] = Math.round((1 + r * Math.cos(v)) * Math.sin(u) * 1e5) / 1e5f;
                for (int k = 0; k < 3; k++) colours[3 * a + k] = (i + k * j) % 256;
                materials[2 * a] = materials[2 * a + 1] = i < 100 ? 0 : 1;
                int b = (j + 1) % ALONG * AROUND + i;
                int right = j * AROUND + (i + 1) % AROUND;
                int across = (j + 1) % ALONG * AROUND + (i + 1) % AROUND;
                for (int w : new int[] {a, b, right, right, b, across}) faces[at++] = w;
            }
        }
        MeshBuilder builder = new MeshBuilder().positions(positions).faceWedges(faces);
        if (attributes) {
            builder.channels(List.of(
                            new Channel(Channel.Semantic.COLOUR, "colour", 3, Channel.Type.UINT8, colours, null)))
                    .materials(List.of(Material.named("inner"), Material.named("outer")))
                    .faceMaterials(materials);
        }
        return builder.build();
    }
}
