package org.jsmesh.web;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import javax.imageio.ImageIO;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.Picture;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.Texture;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.api.Test;

class DecodingSessionTest {
    private static final byte[] IMAGE = new byte[30_000];

    static {
        new Random(1).nextBytes(IMAGE);
    }

    @Test
    void shouldOfferPreviewsOfAnImageAndThenTheImage() throws Exception {
        byte[] archive = archive();
        DecodingSession session = new DecodingSession();
        Set<String> offered = new LinkedHashSet<>();
        for (int at = 0; at < archive.length; at += 100) {
            session.feed(Arrays.copyOfRange(archive, at, Math.min(archive.length, at + 100)));
            String line = session.texturePaths();
            if (line.isEmpty() || !offered.add(line)) continue;
            String[] parts = line.split("\t");
            assertThat(parts[0]).isEqualTo("sky.png");
            if (parts.length == 1) continue;
            assertThat(ImageIO.read(new ByteArrayInputStream(session.texture(0)))
                            .getWidth())
                    .isEqualTo(Integer.parseInt(parts[1]));
        }
        assertThat(offered).startsWith("sky.png\t8", "sky.png\t16").endsWith("sky.png");
        assertThat(session.texture(0)).isEqualTo(IMAGE);
        assertThatThrownBy(() -> session.texture(1)).isInstanceOf(IllegalArgumentException.class);
    }

    private static byte[] archive() {
        Mesh mesh = RandomMeshes.TORUS.mesh(5);
        int[] uv = new int[2 * mesh.wedges()];
        for (int w = 0; w < mesh.wedges(); w++)
            for (int k = 0; k < 2; k++)
                uv[2 * w + k] = Float.floatToRawIntBits(.5f + .1f * mesh.positions()[3 * mesh.wedgeVertices()[w] + k]);
        int[] waves = new int[256 * 256];
        for (int i = 0; i < waves.length; i++) waves[i] = (int) (127 + 127 * Math.sin(i % 256 / 9.0)) * 0x10101;
        Material material = new Material("m", List.of(), List.of(new Material.TextureReference("map_Kd", "sky.png")));
        Mesh painted = MeshBuilder.from(mesh)
                .channels(List.of(new Channel(Channel.Semantic.TEXCOORD, "uv", 2, Channel.Type.FLOAT32, uv, null)))
                .materials(List.of(material))
                .faceMaterials(new int[mesh.faces()])
                .textures(List.of(new Texture("sky.png", IMAGE)))
                .build();
        return new MeshEncoder(EncoderSettings.defaults())
                .encode(painted, List.of(new Picture("sky.png", 256, 256, waves)), ProgressListener.NONE)
                .bytes();
    }
}
