package org.jsmesh.archive;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.List;
import org.jsmesh.archive.coding.ArchiveLayout;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.Texture;
import org.jsmesh.test.AlteredPicture;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.api.Test;

class ProvenanceArchiveTest {
    private static final byte[] WOOD = "wood".repeat(50).getBytes(StandardCharsets.US_ASCII);
    private static final byte[] STONE = "stone".repeat(50).getBytes(StandardCharsets.US_ASCII);

    private static Mesh painted() {
        return MeshBuilder.from(RandomMeshes.SPHERE.mesh(4))
                .textures(List.of(new Texture("wood.png", WOOD), new Texture("stone.png", STONE)))
                .build();
    }

    private static EncodedArchive encode(Provenance from) {
        return new MeshEncoder(EncoderSettings.defaults().withBaseFaces(4))
                .encode(painted(), from, List.of(), ProgressListener.NONE);
    }

    @Test
    void shouldHoldWhatWasLostOnTheWay() {
        Note group = Note.dropped("3 group names not kept.", 3, "wheel");
        Note moved = Note.changed("24 positions rounded.", 24, "vertex 0").asWarning();
        Note mended = Note.repaired("2 vertices merged.", 2, "");
        EncodedArchive archive = encode(new Provenance("OBJ", List.of(group, mended, moved)));
        assertThat(archive.header().provenance()).isEqualTo(new Provenance("OBJ", List.of(group, moved)));
        assertThat(archive.notes()).startsWith(group, mended, moved);
    }

    @Test
    void shouldHoldWhatTheCleanerDropped() {
        Mesh mesh = RandomMeshes.SPHERE.mesh(4);
        float[] positions = java.util.Arrays.copyOf(mesh.positions(), mesh.positions().length + 3);
        Mesh unused = MeshBuilder.from(mesh).positions(positions).build();
        assertThat(TestArchives.encodeFar(unused).header().provenance().notes())
                .extracting(Note::text)
                .contains("1 vertex that no face refers to dropped.");
    }

    @Test
    void shouldKnowTheHashesOfImagesOnceTheHeaderIsWhole() throws Exception {
        byte[] bytes = encode(Provenance.NONE).bytes();
        ArchiveDecoder decoder = TestArchives.decode(bytes, bytes.length);
        assertThat(decoder.opening().images())
                .containsExactlyInAnyOrder(
                        new ImageInfo(List.of("wood.png"), 200), new ImageInfo(List.of("stone.png"), 250));
        assertThat(decoder.header().images())
                .containsExactlyInAnyOrder(
                        new ImageInfo(List.of("wood.png"), 200, sha256(WOOD)),
                        new ImageInfo(List.of("stone.png"), 250, sha256(STONE)));
    }

    @Test
    void shouldComputeTheIdentityOfTheModelAsTheFormatSays() throws Exception {
        ArchiveHeader header = encode(Provenance.NONE).header();
        String text = "mesh " + header.meshSha256() + "\nimage " + sha256(STONE) + " 9 stone.png\nimage " + sha256(WOOD)
                + " 8 wood.png\n";
        assertThat(header.modelSha256()).isEqualTo(sha256(text.getBytes(StandardCharsets.UTF_8)));
    }

    @Test
    void shouldProveTheOriginal() throws Exception {
        byte[] bytes = encode(Provenance.NONE).bytes();
        ArchiveDecoder decoder = TestArchives.decode(bytes, bytes.length);
        Proof proof = Proof.of(decoder.header(), decoder.mesh());
        assertThat(proof.difference()).isEmpty();
        assertThat(proof.isOriginal()).isTrue();
        assertThat(proof.modelSha256()).isEqualTo(decoder.header().modelSha256());
        assertThat(Proof.of(decoder.header(), decoder.meshInOrder()).isOriginal())
                .isTrue();
    }

    @Test
    void shouldNameAPictureThatWasAltered() throws Exception {
        EncodedArchive archive = encode(Provenance.NONE);
        byte[] bytes = AlteredPicture.in(archive.bytes());
        ArchiveDecoder decoder = TestArchives.decode(bytes, bytes.length);
        assertThat(decoder.isComplete()).isTrue();
        String first = decoder.header().images().get(0).paths().get(0);
        Proof proof = Proof.of(decoder.header(), decoder.mesh());
        assertThat(proof.isOriginal()).isFalse();
        assertThat(proof.meshSha256()).isEqualTo(decoder.header().meshSha256());
        assertThat(proof.modelSha256()).isNotEqualTo(decoder.header().modelSha256());
        assertThat(proof.altered()).containsExactly(first);
        assertThat(proof.difference()).isEqualTo("the picture " + first + " is not the one that was encoded");
    }

    @Test
    void shouldNameAPictureThatHasNotCome() {
        ArchiveHeader header = encode(Provenance.NONE).header();
        Mesh without = MeshBuilder.from(painted()).textures(List.of()).build();
        assertThat(Proof.of(header, without).altered()).containsExactlyInAnyOrder("wood.png", "stone.png");
    }

    @Test
    void shouldNameAMeshThatIsAnother() {
        ArchiveHeader header = encode(Provenance.NONE).header();
        Proof proof = Proof.of(header, RandomMeshes.SPHERE.mesh(5));
        assertThat(proof.isOriginal()).isFalse();
        assertThat(proof.difference()).contains(header.meshSha256(), proof.meshSha256());
    }

    @Test
    void shouldSayWhatToDoWithAnArchiveOfAnotherVersion() {
        byte[] bytes = encode(Provenance.NONE).bytes();
        bytes[3] = (byte) (ArchiveLayout.VERSION - 1);
        assertThatThrownBy(() -> TestArchives.decode(bytes, bytes.length))
                .isInstanceOf(MalformedStreamException.class)
                .hasMessageContaining(
                        "this archive has version 1 of the format, this jSM reads version 2; encode the model again");
        bytes[3] = (byte) (ArchiveLayout.VERSION + 1);
        assertThatThrownBy(() -> TestArchives.decode(bytes, bytes.length))
                .isInstanceOf(MalformedStreamException.class)
                .hasMessageContaining("a newer jSM may read it");
    }

    private static String sha256(byte[] bytes) throws Exception {
        return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bytes));
    }
}
