package org.jsmesh.poster;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.Picture;
import org.jsmesh.mesh.Texture;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.studio.Ground;
import org.junit.jupiter.api.Test;

/** Squares across the z axis, one behind the other, in colours that no light changes. */
class PainterTest {
    private static final String RED = unlit("1,0,0,1", "");
    private static final String BLUE = unlit("0,0,1,1", "");
    private static final int MIDDLE = Poster.WIDTH * Poster.HEIGHT / 2 + Poster.WIDTH / 2;
    private static final int TONED = 230; // of full light, which the tone mapping lowers

    @Test
    void shouldShowTheGroundAroundTheModel() {
        int[] pixels = draw(true, RED);
        assertThat(pixels[0]).isEqualTo(ground(0));
        assertThat(pixels[pixels.length - 1])
                .isEqualTo(ground(pixels.length - 1))
                .isEqualTo(0xc3c8ce);
        int bright = (int) (.42 * Poster.HEIGHT) * Poster.WIDTH + Poster.WIDTH / 2;
        assertThat(PosterTest.difference(ground(bright), 0xdde1e5)).isLessThanOrEqualTo(1);
    }

    /** Of a square that lies on the ground and is seen from its back, so it hides nothing. */
    @Test
    void shouldDarkenTheGroundBeneathTheModel() {
        Mesh square = square(RED, 0, 1, 2, 0, 2, 3);
        float[] flat = {-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1};
        int[] pixels = drawn(MeshBuilder.from(square).positions(flat).build());
        assertThat((pixels[MIDDLE] >> 16) / (double) (ground(MIDDLE) >> 16)).isBetween(.24, .3);
        assertThat(pixels[10]).isEqualTo(ground(10));
    }

    @Test
    void shouldShowTheNearerFaceWhateverTheOrder() {
        int red = draw(true, RED)[MIDDLE];
        int blue = draw(true, BLUE)[MIDDLE];
        assertThat(red >> 16).isGreaterThan(TONED);
        assertThat(red & 255).isLessThan(40);
        assertThat(blue & 255).isGreaterThan(TONED);
        assertThat(draw(true, RED, BLUE)[MIDDLE]).isEqualTo(blue);
        assertThat(draw(false, RED, BLUE)[MIDDLE]).isEqualTo(blue);
    }

    @Test
    void shouldNotShowTheBackOfASingleSidedFace() {
        int[] behind = {0, 2, 1, 0, 3, 2};
        assertThat(drawn(square(RED, behind))[MIDDLE]).isEqualTo(ground(MIDDLE));
        String both = unlit("1,0,0,1", ",\"doubleSided\":true");
        assertThat(drawn(square(both, behind))[MIDDLE]).isEqualTo(draw(true, RED)[MIDDLE]);
    }

    @Test
    void shouldLetTheFartherFaceShineThrough() {
        int red = draw(true, RED)[MIDDLE];
        int blue = draw(true, BLUE)[MIDDLE];
        String glass = unlit("0,0,1,0.5", ",\"alphaMode\":\"BLEND\"");
        int mixed = draw(true, RED, glass)[MIDDLE];
        for (int shift = 0; shift < 24; shift += 8)
            assertThat((double) (mixed >> shift & 255))
                    .isBetween(
                            ((red >> shift & 255) + (blue >> shift & 255)) / 2. - 2,
                            ((red >> shift & 255) + (blue >> shift & 255)) / 2. + 2);
        assertThat(draw(true, glass, RED)[MIDDLE]).isEqualTo(red);
    }

    @Test
    void shouldCutHoles() {
        String mask = unlit("1,0,0,0.4", ",\"alphaMode\":\"MASK\"");
        assertThat(draw(true, BLUE, mask)[MIDDLE]).isEqualTo(draw(true, BLUE)[MIDDLE]);
        String kept = unlit("1,0,0,0.6", ",\"alphaMode\":\"MASK\"");
        assertThat(draw(true, BLUE, kept)[MIDDLE]).isEqualTo(draw(true, RED)[MIDDLE]);
    }

    @Test
    void shouldShowImagesAsTheyLie() {
        String image = "{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":{\"source\":0}}},"
                + "\"extensions\":{\"KHR_materials_unlit\":{}}}";
        Mesh plain = square(image, 0, 1, 2, 0, 2, 3);
        int[] uv = new int[8];
        float[] corners = {0, 1, 1, 1, 1, 0, 0, 0};
        for (int i = 0; i < 8; i++) uv[i] = Float.floatToIntBits(corners[i]);
        Mesh mesh = MeshBuilder.from(plain)
                .materials(List.of(new Material(
                        "", List.of(), List.of(new Material.TextureReference("baseColorTexture", "a.png")), image)))
                .textures(List.of(new Texture("other.png", new byte[] {1}), new Texture("a.png", new byte[] {1})))
                .channels(List.of(
                        new Channel(Channel.Semantic.TEXCOORD, "TEXCOORD_0", 2, Channel.Type.FLOAT32, uv, null)))
                .build();
        int[] argb = new int[64 * 64];
        for (int i = 0; i < argb.length; i++)
            argb[i] = i / 64 < 32 ? i % 64 < 32 ? 0xffff0000 : 0xff00ff00 : i % 64 < 32 ? 0xff0000ff : 0xffffff00;
        // The picture has the path of another texture with the same bytes.
        int[] pixels = Poster.pixels(mesh, UpAxis.Y, List.of(new Picture("other.png", 64, 64, argb)));
        int step = 40;
        int left = pixels[MIDDLE - step - step * Poster.WIDTH];
        assertThat(left >> 16).as("upper left is red").isGreaterThan(200);
        assertThat(left & 255).isLessThan(40);
        assertThat(pixels[MIDDLE + step - step * Poster.WIDTH] & 0xffff)
                .as("upper right is green")
                .isGreaterThan(200 << 8);
        assertThat(pixels[MIDDLE - step + step * Poster.WIDTH] & 255)
                .as("lower left is blue")
                .isGreaterThan(200);
    }

    @Test
    void shouldLightClayMoreFromAboveThanFromBelow() {
        float[] up = {-1, 0, -1, -1, 0, 1, 1, 0, 1, 1, 0, -1};
        Mesh top = new MeshBuilder()
                .positions(up)
                .faceWedges(new int[] {0, 1, 2, 0, 2, 3})
                .build();
        int lit = Poster.pixels(top, UpAxis.Y, List.of())[MIDDLE];
        float[] away = {-1, -1, 0, 1, -1, 0, 1, 1, -2, -1, 1, -2};
        Mesh slope = new MeshBuilder()
                .positions(away)
                .faceWedges(new int[] {0, 2, 1, 0, 3, 2})
                .build();
        int dark = Poster.pixels(slope, UpAxis.Y, List.of())[MIDDLE];
        assertThat(lit >> 8 & 255).isBetween(190, 250);
        assertThat(lit >> 16).as("clay is warm").isGreaterThan(lit & 255);
        assertThat(PosterTest.difference(lit, dark)).isLessThan(120);
    }

    private static int[] draw(boolean inOrder, String... materials) {
        List<Integer> order = new ArrayList<>();
        for (int i = 0; i < materials.length; i++) order.add(inOrder ? i : materials.length - 1 - i);
        int count = materials.length;
        float[] positions = new float[12 * count];
        int[] faces = new int[6 * count];
        int[] ids = new int[2 * count];
        float[] corners = {-1, -1, 1, -1, 1, 1, -1, 1};
        for (int i = 0; i < count; i++) {
            int at = order.get(i);
            for (int c = 0; c < 4; c++) {
                positions[12 * i + 3 * c] = corners[2 * c];
                positions[12 * i + 3 * c + 1] = corners[2 * c + 1];
                positions[12 * i + 3 * c + 2] = .01f * at;
            }
            int[] square = {0, 1, 2, 0, 2, 3};
            for (int k = 0; k < 6; k++) faces[6 * i + k] = 4 * i + square[k];
            ids[2 * i] = ids[2 * i + 1] = at;
        }
        return drawn(new MeshBuilder()
                .positions(positions)
                .faceWedges(faces)
                .faceMaterials(ids)
                .materials(Arrays.stream(materials)
                        .map(gltf -> new Material("", List.of(), List.of(), gltf))
                        .toList())
                .build());
    }

    private static Mesh square(String material, int... faces) {
        return new MeshBuilder()
                .positions(new float[] {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0})
                .faceWedges(faces)
                .faceMaterials(new int[2])
                .materials(List.of(new Material("", List.of(), List.of(), material)))
                .build();
    }

    private static int[] drawn(Mesh mesh) {
        return Poster.pixels(mesh, UpAxis.Y, List.of());
    }

    private static String unlit(String colour, String more) {
        return "{\"pbrMetallicRoughness\":{\"baseColorFactor\":[" + colour + "]},"
                + "\"extensions\":{\"KHR_materials_unlit\":{}}" + more + "}";
    }

    private static int ground(int pixel) {
        double[] rgb =
                Ground.colour((pixel % Poster.WIDTH + .5) / Poster.WIDTH, (pixel / Poster.WIDTH + .5) / Poster.HEIGHT);
        return (int) (rgb[0] + .5) << 16 | (int) (rgb[1] + .5) << 8 | (int) (rgb[2] + .5);
    }
}
