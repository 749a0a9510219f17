package org.jsmesh.encode;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.BatchKind;
import org.jsmesh.archive.ImageInfo;
import org.jsmesh.archive.Provenance;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.Picture;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.Texture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Where textures and previews of them come in an archive. */
class TextureOrderTest {
    private static final int SIDE = 40; // quads of the wavy sheet

    @Test
    void shouldShowAPreviewSoonAndKeepTheBatchesOfAnImageTogether() throws Exception {
        Mesh mesh = sheet(texture("a.png", 40_000));
        byte[] bytes = encode(mesh, List.of(stripes("a.png", 0xff0000, 0x2000ff)));
        List<BatchKind> kinds = kinds(bytes);
        assertThat(kinds.get(1)).isEqualTo(BatchKind.PREVIEW);
        int first = kinds.indexOf(BatchKind.TEXTURE);
        int last = kinds.lastIndexOf(BatchKind.TEXTURE);
        assertThat(kinds.subList(first, last + 1)).containsOnly(BatchKind.TEXTURE);
        assertThat(kinds.lastIndexOf(BatchKind.PREVIEW)).isLessThan(first);
        assertThat(kinds.subList(0, first)).contains(BatchKind.SPLITS);
        assertThat(kinds.subList(last, kinds.size())).contains(BatchKind.PRECISION);
    }

    @Test
    void shouldPreviewTheColoursUntilTheImageIsThere() throws Exception {
        Mesh mesh = sheet(texture("a.png", 40_000));
        byte[] bytes = encode(mesh, List.of(fromRedToBlue("a.png")));
        ArchiveDecoder decoder = new ArchiveDecoder();
        int width = 0;
        boolean arrived = false;
        for (int i = 0; i < bytes.length; i++) {
            int before = decoder.batches();
            decoder.feed(bytes, i, 1);
            if (decoder.batches() == before) continue;
            Mesh shown = decoder.mesh();
            arrived |= !shown.textures().isEmpty();
            assertThat(shown.previews()).hasSize(decoder.batches() == 1 || arrived ? 0 : 1);
            if (shown.previews().isEmpty()) continue;
            Picture preview = shown.previews().get(0);
            assertThat(preview.path()).isEqualTo("a.png");
            assertThat(preview.width()).isGreaterThanOrEqualTo(width);
            width = preview.width();
            int left = preview.argb()[0] & 0xffffff;
            int right = preview.argb()[width - 1] & 0xffffff;
            assertThat(left >> 16).isGreaterThan((left & 255) + 100);
            assertThat(right & 255).isGreaterThan((right >> 16) + 100);
        }
        assertThat(arrived).isTrue();
        assertThat(width).isGreaterThanOrEqualTo(16);
        assertThat(MeshIdentity.sha256(decoder.mesh())).isEqualTo(MeshIdentity.sha256(mesh));
    }

    @Test
    void shouldSpendLittleOnPreviews() throws Exception {
        byte[] bytes = encode(sheet(texture("a.png", 40_000)), List.of(noise("a.png")));
        BatchIndex index = header(bytes).header().batches();
        long previews = 0;
        for (int i = 0; i < index.size(); i++) if (index.kind(i) == BatchKind.PREVIEW) previews += index.bytes(i);
        assertThat(previews).isBetween(1L, 40_000L * 4 / 100);
    }

    @Test
    @Timeout(60)
    void shouldComeToAnEndWithCoordinatesFarFromTheImage() throws Exception {
        Mesh mesh = sheet(texture("a.png", 5000));
        for (String offset : List.of("1e9", "1e12", "-1e30", "1e999")) {
            String gltf = "{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":{\"source\":0},\"extensions\":{"
                    + "\"KHR_texture_transform\":{\"offset\":[" + offset + "," + offset + "]}}}}}";
            Material far = new Material(
                    "m", List.of(), List.of(new Material.TextureReference("baseColorTexture", "a.png")), gltf);
            Mesh moved = MeshBuilder.from(mesh).materials(List.of(far)).build();
            byte[] bytes = encode(moved, List.of(fromRedToBlue("a.png")));
            ArchiveDecoder decoder = new ArchiveDecoder();
            decoder.feed(bytes, 0, bytes.length);
            assertThat(MeshIdentity.sha256(decoder.mesh())).isEqualTo(MeshIdentity.sha256(moved));
        }
    }

    @Test
    void shouldPutTheImageThatDoesMoreFirst() throws Exception {
        // b covers as much as a, is as large, but is nearly of the colour that its material has without it.
        Mesh mesh = sheet(texture("b.png", 9000), texture("a.png", 9000));
        byte[] bytes = encode(mesh, List.of(noise("a.png"), stripes("b.png", 0xcccccc, 0xc0c0c0)));
        assertThat(header(bytes).header().images())
                .extracting(ImageInfo::paths)
                .containsExactly(List.of("a.png"), List.of("b.png"));
    }

    @Test
    void shouldPutWhatViewersDoNotShowLast() throws Exception {
        Mesh mesh = sheet(texture("bumps.png", 5000), texture("a.png", 9000));
        List<Material> materials = new ArrayList<>();
        materials.add(new Material("m", List.of(), List.of(new Material.TextureReference("refl", "bumps.png"))));
        materials.add(mesh.materials().get(1));
        byte[] bytes = encode(MeshBuilder.from(mesh).materials(materials).build(), List.of());
        List<BatchKind> kinds = kinds(bytes);
        assertThat(header(bytes).header().images())
                .extracting(ImageInfo::paths)
                .containsExactly(List.of("a.png"), List.of("bumps.png"));
        assertThat(kinds.get(kinds.size() - 1)).isEqualTo(BatchKind.TEXTURE);
        assertThat(kinds.indexOf(BatchKind.TEXTURE)).isLessThan(kinds.lastIndexOf(BatchKind.SPLITS) + 2);
    }

    @Test
    void shouldPreviewNormalsBeforeTheImageOfAnyColour() throws Exception {
        Mesh mesh = sheet(texture("a.png", 2000), texture("n.png", 90_000));
        List<Material> materials = new ArrayList<>();
        for (int i = 0; i < 2; i++)
            materials.add(new Material(
                    "m",
                    List.of(),
                    List.of(
                            new Material.TextureReference("map_Kd", "a.png"),
                            new Material.TextureReference("norm", "n.png"))));
        Mesh bumpy = MeshBuilder.from(mesh).materials(materials).build();
        byte[] bytes =
                encode(bumpy, List.of(stripes("a.png", 0xff0000, 0x2000ff), stripes("n.png", 0x80c0e0, 0x8080ff)));
        assertThat(header(bytes).header().images()).extracting(ImageInfo::paths).startsWith(List.of("a.png"));
        ArchiveDecoder decoder = new ArchiveDecoder();
        for (int i = 0; i < bytes.length; i++) {
            decoder.feed(bytes, i, 1);
            if (decoder.batches() > 0 && !decoder.mesh().textures().isEmpty()) break;
        }
        assertThat(decoder.mesh().textures()).extracting(Texture::path).containsExactly("a.png");
        assertThat(decoder.mesh().previews())
                .singleElement()
                .satisfies(p -> assertThat(p.path()).isEqualTo("n.png"));
    }

    @Test
    void shouldSpreadAStageOverSeveralBatches() throws Exception {
        byte[] bytes = encode(sheet(texture("a.png", 400_000)), List.of(noise("a.png")));
        List<BatchKind> kinds = kinds(bytes);
        ArchiveDecoder decoder = new ArchiveDecoder();
        int width = 0;
        int portions = 0; // of the stage under way
        int most = 0;
        for (int i = 0; i < bytes.length; i++) {
            int before = decoder.batches();
            decoder.feed(bytes, i, 1);
            if (decoder.batches() == before || kinds.get(decoder.batches() - 1) != BatchKind.PREVIEW) continue;
            portions++;
            List<Picture> previews = decoder.mesh().previews();
            if (previews.isEmpty() || previews.get(0).width() == width) continue;
            width = previews.get(0).width();
            most = Math.max(most, portions);
            portions = 0;
        }
        assertThat(most).isGreaterThan(1);
        assertThat(portions).isZero();
    }

    @Test
    void shouldGoOnAfterAStageThatMakesItWorse() throws Exception {
        // Bars as wide as one pixel of 64: coarser stages show nothing but grey.
        int[] rgb = new int[512 * 512];
        for (int i = 0; i < rgb.length; i++) rgb[i] = i % 512 / 8 % 2 == 0 ? 0 : 0xffffff;
        byte[] bytes = encode(sheet(texture("a.png", 90_000)), List.of(opaque("a.png", 512, rgb)));
        ArchiveDecoder decoder = new ArchiveDecoder();
        int width = 0;
        for (int i = 0; i < bytes.length; i++) {
            int before = decoder.batches();
            decoder.feed(bytes, i, 1);
            if (decoder.batches() == before || decoder.mesh().previews().isEmpty()) continue;
            width = decoder.mesh().previews().get(0).width();
        }
        assertThat(width).isGreaterThanOrEqualTo(64);
    }

    @Test
    void shouldGiveBackAllImages() throws Exception {
        Mesh mesh = sheet(texture("b.png", 3000), texture("a.png", 70_000));
        byte[] bytes = encode(mesh, List.of(stripes("a.png", 0x00ff00, 0x0000ff)));
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(bytes, 0, bytes.length);
        assertThat(decoder.mesh().textures()).hasSize(2);
        for (Texture t : decoder.mesh().textures()) {
            byte[] original =
                    mesh.textures().get(t.path().equals("b.png") ? 0 : 1).bytes();
            assertThat(t.bytes()).isEqualTo(original);
        }
    }

    private static byte[] encode(Mesh mesh, List<Picture> pictures) {
        return new MeshEncoder(EncoderSettings.defaults())
                .encode(mesh, Provenance.NONE, pictures, ProgressListener.NONE)
                .bytes();
    }

    private static ArchiveDecoder header(byte[] bytes) throws Exception {
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(bytes, 0, bytes.length);
        return decoder;
    }

    private static List<BatchKind> kinds(byte[] bytes) throws Exception {
        BatchIndex index = header(bytes).header().batches();
        List<BatchKind> kinds = new ArrayList<>();
        for (int i = 0; i < index.size(); i++) kinds.add(index.kind(i));
        return kinds;
    }

    private static Texture texture(String path, int size) {
        byte[] bytes = new byte[size];
        new Random(path.hashCode()).nextBytes(bytes);
        return new Texture(path, bytes);
    }

    /** One colour on the left half, another one on the right half, with rows of dots of the other one. */
    private static Picture stripes(String path, int left, int right) {
        int[] rgb = new int[128 * 128];
        for (int i = 0; i < rgb.length; i++) {
            boolean isDot = i % 8 < 2 && i / 128 % 8 < 2;
            rgb[i] = i % 128 < 64 ^ isDot ? left : right;
        }
        return opaque(path, 128, rgb);
    }

    private static Picture fromRedToBlue(String path) {
        int[] rgb = new int[128 * 128];
        for (int i = 0; i < rgb.length; i++) rgb[i] = (255 - 2 * (i % 128)) << 16 | 2 * (i % 128);
        return opaque(path, 128, rgb);
    }

    private static Picture noise(String path) {
        return opaque(path, 256, new Random(3).ints(256 * 256, 0, 1 << 24).toArray());
    }

    private static Picture opaque(String path, int side, int[] rgb) {
        int[] argb = rgb.clone();
        for (int i = 0; i < argb.length; i++) argb[i] |= 0xff000000;
        return new Picture(path, side, side, argb);
    }

    /** A wavy sheet; its faces show the textures in turns of rows. */
    private static Mesh sheet(Texture... textures) {
        int row = SIDE + 1;
        float[] positions = new float[3 * row * row];
        int[] uv = new int[2 * row * row];
        for (int i = 0; i < row * row; i++) {
            float x = (float) (i % row) / SIDE;
            float y = (float) (i / row) / SIDE;
            positions[3 * i] = x;
            positions[3 * i + 1] = y;
            positions[3 * i + 2] = (float) (.1 * Math.sin(9 * x) * Math.cos(7 * y));
            uv[2 * i] = Float.floatToRawIntBits(x);
            uv[2 * i + 1] = Float.floatToRawIntBits(y);
        }
        int[] faces = new int[6 * SIDE * SIDE];
        int[] faceMaterials = new int[2 * SIDE * SIDE];
        for (int q = 0, n = 0; q < SIDE * SIDE; q++) {
            int a = q / SIDE * row + q % SIDE;
            for (int corner : new int[] {a, a + 1, a + row, a + row, a + 1, a + row + 1}) faces[n++] = corner;
            faceMaterials[2 * q] = faceMaterials[2 * q + 1] = q / SIDE % textures.length;
        }
        List<Material> materials = new ArrayList<>();
        for (Texture t : textures)
            materials.add(
                    new Material(t.path(), List.of(), List.of(new Material.TextureReference("map_Kd", t.path()))));
        return new MeshBuilder()
                .positions(positions)
                .faceWedges(faces)
                .faceMaterials(faceMaterials)
                .channels(List.of(new Channel(Channel.Semantic.TEXCOORD, "uv", 2, Channel.Type.FLOAT32, uv, null)))
                .materials(materials)
                .textures(List.of(textures))
                .build();
    }
}
