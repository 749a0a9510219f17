package org.jsmesh.encode;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.jsmesh.archive.ImageInfo;
import org.jsmesh.archive.Proof;
import org.jsmesh.archive.Provenance;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.Texture;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.api.Test;

/** An archive holds each image once, however many paths it has. */
class EachImageOnceTest {
    private static final byte[] WOOD = bytes(1, 50_000);
    private static final byte[] STONE = bytes(2, 3000);

    @Test
    void shouldHoldOneImageOfFourNamesOnce() throws Exception {
        EncodedArchive once = encode(new Texture("a.png", WOOD));
        EncodedArchive four = encode(
                new Texture("a.png", WOOD),
                new Texture("b.png", WOOD.clone()),
                new Texture("c.png", WOOD.clone()),
                new Texture("d.png", WOOD.clone()));
        assertThat(four.bytes().length - once.bytes().length).isBetween(1, 100);
        assertThat(four.header().images())
                .singleElement()
                .satisfies(image -> assertThat(image.paths()).containsExactly("a.png", "b.png", "c.png", "d.png"));
    }

    @Test
    void shouldGiveEachPathItsImageAndShareTheBytes() throws Exception {
        Mesh mesh = decode(encode(
                        new Texture("a.png", WOOD),
                        new Texture("b.png", STONE),
                        new Texture("c.png", WOOD.clone()),
                        new Texture("d.png", STONE.clone())))
                .mesh();
        List<Texture> textures = mesh.textures();
        assertThat(textures).hasSize(4);
        for (Texture t : textures) assertThat(t.bytes()).isEqualTo(t.path().matches("[ac].png") ? WOOD : STONE);
        assertThat(textures.get(0).bytes()).isSameAs(textures.get(1).bytes());
        assertThat(textures.get(2).bytes()).isSameAs(textures.get(3).bytes());
    }

    @Test
    void shouldKeepTheIdentityOfTheModelThatCountsPaths() throws Exception {
        EncodedArchive archive =
                encode(new Texture("a.png", WOOD), new Texture("b.png", STONE), new Texture("c.png", WOOD.clone()));
        ArchiveDecoder decoder = decode(archive);
        Proof proof = Proof.of(decoder.header(), decoder.mesh());
        assertThat(proof.isOriginal()).isTrue();
        assertThat(proof.modelSha256()).isEqualTo(archive.header().modelSha256());
        EncodedArchive other = encode(new Texture("a.png", WOOD), new Texture("b.png", STONE));
        assertThat(other.header().modelSha256()).isNotEqualTo(proof.modelSha256());
    }

    @Test
    void shouldNameAllPathsOfAnImageThatWasAltered() throws Exception {
        EncodedArchive archive =
                encode(new Texture("a.png", WOOD), new Texture("b.png", STONE), new Texture("c.png", WOOD.clone()));
        List<Texture> altered = new ArrayList<>();
        byte[] other = bytes(3, 9);
        for (Texture t : decode(archive).mesh().textures())
            altered.add(t.path().equals("b.png") ? t : new Texture(t.path(), other));
        Mesh mesh = MeshBuilder.from(decode(archive).mesh()).textures(altered).build();
        assertThat(Proof.of(archive.header(), mesh).altered()).containsExactly("a.png", "c.png");
    }

    @Test
    void shouldRefuseToChangeThePathsOfAnImage() {
        ImageInfo image = encode(new Texture("a.png", WOOD)).header().images().get(0);
        assertThatThrownBy(() -> image.paths().add("b.png")).isInstanceOf(UnsupportedOperationException.class);
    }

    private static ArchiveDecoder decode(EncodedArchive archive) throws Exception {
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(archive.bytes(), 0, archive.bytes().length);
        return decoder;
    }

    private static EncodedArchive encode(Texture... textures) {
        Mesh mesh = RandomMeshes.SPHERE.mesh(4);
        List<Material> materials = new ArrayList<>();
        for (Texture t : textures)
            materials.add(
                    new Material(t.path(), List.of(), List.of(new Material.TextureReference("map_Kd", t.path()))));
        int[] ofFaces = new int[mesh.faces()];
        for (int f = 0; f < ofFaces.length; f++) ofFaces[f] = f * textures.length / ofFaces.length;
        Mesh painted = MeshBuilder.from(mesh)
                .materials(materials)
                .faceMaterials(ofFaces)
                .textures(List.of(textures))
                .build();
        return new MeshEncoder(EncoderSettings.defaults())
                .encode(painted, Provenance.NONE, List.of(), ProgressListener.NONE);
    }

    private static byte[] bytes(int seed, int size) {
        byte[] bytes = new byte[size];
        new Random(seed).nextBytes(bytes);
        return bytes;
    }
}
