package org.jsmesh.desktop.draw;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.display.CreaseAngle;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.test.Requirement;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * Base, middle and end of an archive as OpenGL draws them, against pictures of the decoded mesh and of the original by
 * the software rasteriser. Stated tolerance: the decoded mesh as in {@link Pictures}; the original's silhouette to 80%
 * at the base and 97% in the middle; at the end the picture of the original as in {@link Pictures}.
 */
@Tag("long")
class LevelOfDetailTest {
    private static final Mesh ORIGINAL = Shapes.paintedTorus(150, 50);
    private static byte[] archive;
    private static EncodedArchive encoded;

    @BeforeAll
    static void encode() {
        Requirement.display();
        encoded = new MeshEncoder(EncoderSettings.defaults()).encode(ORIGINAL, ProgressListener.NONE);
        archive = encoded.bytes();
    }

    @Test
    void shouldDrawTheBase() throws IOException {
        assertShown("base", 0, .8);
    }

    @Test
    void shouldDrawTheMiddle() throws IOException {
        int middle = encoded.header().batches().batchesWithin(archive.length / 2) - 1;
        assertShown("middle", middle, .97);
    }

    @Test
    void shouldDrawTheEnd() throws IOException {
        BufferedImage drawn = assertShown("end", encoded.header().batches().size() - 1, .99);
        Pictures.assertAgree(drawn, Pictures.expected(ORIGINAL, ORIGINAL.bounds()), 1);
    }

    private static BufferedImage assertShown(String name, int batch, double likeOriginal) throws IOException {
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(archive, 0, (int) encoded.header().batches().end(batch));
        Mesh mesh = decoder.mesh();
        assertThat(mesh.faces()).isEqualTo(encoded.header().batches().faces(batch));
        float[] bounds = encoded.header().bounds();
        double crease =
                CreaseAngle.cosine(mesh.faces(), encoded.header().batches().faces(0), ORIGINAL.faces());
        BufferedImage drawn = Pictures.drawn(mesh, crease, bounds, false);
        Pictures.keep("lod-" + name, drawn);
        Pictures.assertAgree(drawn, Pictures.expected(mesh, crease, bounds), 1);
        BufferedImage original = Pictures.expected(ORIGINAL, ORIGINAL.bounds());
        assertThat(Pictures.likeness(drawn, original)).isGreaterThan(likeOriginal);
        return drawn;
    }
}
