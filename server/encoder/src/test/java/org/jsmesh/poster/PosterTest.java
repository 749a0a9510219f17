package org.jsmesh.poster;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.stream.Collectors;
import javax.imageio.ImageIO;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.files.ArchiveFile;
import org.jsmesh.files.ModelEncoding;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.test.RandomMeshes;
import org.jsmesh.test.SampleModels;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class PosterTest {
    @ParameterizedTest
    @EnumSource(RandomMeshes.class)
    void shouldFitAndBeReadByJava(RandomMeshes kind) throws Exception {
        byte[] jpeg = Poster.jpeg(kind.mesh(1), UpAxis.Y, List.of());
        assertThat(jpeg).hasSizeLessThanOrEqualTo(Poster.MOST_BYTES);
        BufferedImage read = ImageIO.read(new ByteArrayInputStream(jpeg));
        assertThat(read.getWidth()).isEqualTo(Poster.WIDTH);
        assertThat(read.getHeight()).isEqualTo(Poster.HEIGHT);
    }

    @Test
    void shouldBeInTheArchiveOfEveryModel() throws Exception {
        for (Path model : SampleModels.own()) {
            EncodedArchive archive =
                    new ModelEncoding(EncoderSettings.defaults().withThreads(2)).encode(model, ProgressListener.NONE);
            byte[] jpeg = ArchiveFile.of(archive.bytes()).poster();
            assertThat(jpeg).as(model.toString()).hasSizeBetween(3000, Poster.MOST_BYTES);
            BufferedImage read = ImageIO.read(new ByteArrayInputStream(jpeg));
            assertThat(read.getRGB(240, 180)).as(model.toString()).isNotEqualTo(read.getRGB(10, 10));
        }
    }

    /** The same on every platform: no other test would tell that a picture depends on one. */
    @Test
    void shouldGiveTheSameBytes() throws Exception {
        String torus = sha256(Poster.jpeg(RandomMeshes.TORUS.mesh(2), UpAxis.Z, List.of()));
        assertThat(torus).isEqualTo("29d10efad0628eebdda11aec3969ffb6bffcdf1eebfa50d69450c4cc529703d6");
        String patches = sha256(Poster.jpeg(RandomMeshes.PATCHWORK.mesh(2), UpAxis.Y, List.of()));
        assertThat(patches).isEqualTo("8d9ab77454fd680435c5dfc486be65f8fad57e3060992d67bddb36f9a047eda8");
    }

    @Test
    void shouldGiveTheSameBytesOnManyThreads() throws Exception {
        Mesh mesh = RandomMeshes.TORUS.mesh(5);
        ExecutorService pool = Executors.newFixedThreadPool(4);
        try {
            Callable<String> draw = () -> sha256(Poster.jpeg(mesh, UpAxis.Y, List.of()));
            List<String> hashes = new ArrayList<>();
            for (var drawn : pool.invokeAll(List.of(draw, draw, draw, draw))) hashes.add(drawn.get());
            assertThat(hashes.stream().collect(Collectors.toSet())).hasSize(1);
        } finally {
            pool.shutdown();
        }
    }

    @Test
    void shouldStandUpright() {
        Mesh mesh = RandomMeshes.TORUS.mesh(2);
        float[] turned = new float[mesh.positions().length];
        for (int i = 0; i < turned.length; i += 3) {
            turned[i] = mesh.positions()[i];
            turned[i + 1] = mesh.positions()[i + 2];
            turned[i + 2] = -mesh.positions()[i + 1];
        }
        Mesh standing = MeshBuilder.from(mesh).positions(turned).build();
        int[] z = Poster.pixels(mesh, UpAxis.Z, List.of());
        int[] y = Poster.pixels(standing, UpAxis.Y, List.of());
        int different = 0;
        for (int i = 0; i < z.length; i++) if (difference(z[i], y[i]) > 2) different++;
        assertThat(different).isLessThan(z.length / 1000);
        assertThat(Poster.pixels(mesh, UpAxis.Y, List.of())).isNotEqualTo(z);
    }

    static int difference(int a, int b) {
        int most = 0;
        for (int shift = 0; shift < 24; shift += 8)
            most = Math.max(most, Math.abs((a >> shift & 255) - (b >> shift & 255)));
        return most;
    }

    private static String sha256(byte[] bytes) throws Exception {
        return HexFormat.of()
                .formatHex(java.security.MessageDigest.getInstance("SHA-256").digest(bytes));
    }
}
