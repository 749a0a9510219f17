package org.jsmesh.web;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import org.jsmesh.archive.Provenance;
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
    static final byte[] IMAGE = new byte[30_000];

    static {
        new Random(1).nextBytes(IMAGE);
    }

    @Test
    void shouldOfferPreviewsOfAnImageAndThenTheImage() throws Exception {
        byte[] archive = archive("sky.png");
        DecodingSession session = new DecodingSession();
        Set<String> offered = new LinkedHashSet<>();
        for (int at = 0; at < archive.length; at += 100) {
            session.feed(Arrays.copyOfRange(archive, at, Math.min(archive.length, at + 100)));
            String images = images(session);
            if (!offered.add(images)) continue;
            Matcher preview = Pattern.compile("\"width\":(\\d+)").matcher(images);
            if (preview.find())
                assertThat(ImageIO.read(new ByteArrayInputStream(session.image(0)))
                                .getWidth())
                        .isEqualTo(Integer.parseInt(preview.group(1)));
        }
        assertThat(offered)
                .startsWith("[]", "[{\"paths\":[\"sky.png\"],\"width\":8}]", "[{\"paths\":[\"sky.png\"],\"width\":16}]")
                .endsWith("[{\"paths\":[\"sky.png\"],\"width\":null}]");
        assertThat(session.image(0)).isEqualTo(IMAGE);
        assertThatThrownBy(() -> session.image(1)).isInstanceOf(WrongCallException.class);
    }

    @Test
    void shouldOfferAnImageOfSeveralPathsOnce() throws Exception {
        byte[] archive = archive("sky.png", "water.png");
        DecodingSession session = new DecodingSession();
        Set<String> offered = new LinkedHashSet<>();
        for (int at = 0; at < archive.length; at += 100) {
            session.feed(Arrays.copyOfRange(archive, at, Math.min(archive.length, at + 100)));
            offered.add(images(session));
        }
        String paths = "[{\"paths\":[\"sky.png\",\"water.png\"],\"width\":";
        assertThat(offered).startsWith("[]", paths + "8}]").endsWith(paths + "null}]");
        assertThat(session.image(0)).isEqualTo(IMAGE);
        assertThatThrownBy(() -> session.image(1)).isInstanceOf(WrongCallException.class);
    }

    private static String images(DecodingSession session) {
        Json json = new Json();
        session.writeImages(json);
        return json.toString();
    }

    /** A torus with an image of 30,000 bytes, under one path or several, and its previews. */
    static byte[] archive(String... paths) {
        Mesh mesh = RandomMeshes.TORUS.mesh(5);
        int[] uv = new int[2 * mesh.wedges()];
        for (int w = 0; w < mesh.wedges(); w++)
            for (int k = 0; k < 2; k++)
                uv[2 * w + k] = Float.floatToRawIntBits(.5f + .1f * mesh.positions()[3 * mesh.wedgeVertices()[w] + k]);
        int[] waves = new int[256 * 256];
        for (int i = 0; i < waves.length; i++)
            waves[i] = (int) (127 + 127 * Math.sin(i % 256 / 9.0)) * 0x10101 | 0xff000000;
        Material material = new Material("m", List.of(), List.of(new Material.TextureReference("map_Kd", paths[0])));
        List<Texture> textures =
                Arrays.stream(paths).map(path -> new Texture(path, IMAGE)).toList();
        Mesh painted = MeshBuilder.from(mesh)
                .channels(List.of(new Channel(Channel.Semantic.TEXCOORD, "uv", 2, Channel.Type.FLOAT32, uv, null)))
                .materials(List.of(material))
                .faceMaterials(new int[mesh.faces()])
                .textures(textures)
                .build();
        return new MeshEncoder(EncoderSettings.defaults())
                .encode(
                        painted,
                        Provenance.NONE,
                        List.of(new Picture(paths[0], 256, 256, waves)),
                        ProgressListener.NONE)
                .bytes();
    }
}
