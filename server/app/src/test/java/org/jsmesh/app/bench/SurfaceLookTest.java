package org.jsmesh.app.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.List;
import java.util.Set;
import org.jsmesh.encode.measure.SurfaceProbe;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.Picture;
import org.junit.jupiter.api.Test;

class SurfaceLookTest {
    private static final double CREASE = Math.cos(Math.toRadians(42));

    /** The middle of each of two faces. */
    private static final SurfaceProbe.Places PLACES =
            new SurfaceProbe.Places(new int[] {0, 1}, new double[] {.25, .25, .5, .25, .25, .5}, new double[2]);

    /** Two faces at a right angle: one in y = 0 with the material, one in z = 0 without. */
    private static MeshBuilder fold(Material material) {
        return new MeshBuilder()
                .positions(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1})
                .faceWedges(new int[] {1, 0, 3, 0, 1, 2})
                .materials(List.of(material))
                .faceMaterials(new int[] {0, -1});
    }

    @Test
    void shouldFindEachFacesNormalAndColour() throws IOException {
        SurfaceLook look = look(fold(material("Kd", 1, 0, 0)).build());
        assertThat(normal(look, 0)).containsExactly(new double[] {0, 1, 0}, within(1e-6));
        assertThat(normal(look, 1)).containsExactly(new double[] {0, 0, 1}, within(1e-6));
        assertThat(colour(look, 0)).containsExactly(1, 0, 0);
        assertThat(colour(look, 1)).containsExactly(.8, .8, .8);
    }

    @Test
    void shouldMixTheColoursOfTheWedges() throws IOException {
        Channel colours = new Channel(
                Channel.Semantic.COLOUR,
                "colour",
                3,
                Channel.Type.UINT8,
                new int[] {0, 255, 0, 0, 255, 0, 255, 255, 0, 255, 255, 0},
                null);
        SurfaceLook look =
                look(fold(material("Kd", 1, 0, 0)).channels(List.of(colours)).build());
        assertThat(colour(look, 0)).containsExactly(new double[] {.5, 0, 0}, within(1e-6));
        assertThat(colour(look, 1)).containsExactly(new double[] {.5, 1, 0}, within(1e-6));
    }

    @Test
    void shouldShowAnImageOnceItHasArrived() throws IOException {
        Channel uv = new Channel(Channel.Semantic.TEXCOORD, "uv", 2, Channel.Type.FLOAT32, new int[8], null);
        Material red = new Material(
                "red",
                List.of(new Material.Parameter("Kd", 1, 0, 0)),
                List.of(new Material.TextureReference("map_Kd", "sky.png")));
        Mesh mesh = fold(red)
                .channels(List.of(uv))
                .previews(List.of(new Picture("sky.png", 1, 1, new int[] {0xff0000ff})))
                .build();
        assertThat(colour(look(mesh), 0)).containsExactly(1, 0, 0);
        assertThat(colour(look(mesh, "sky.png"), 0)).containsExactly(0, 0, 1);
    }

    private static Material material(String key, float... values) {
        return new Material("m", List.of(new Material.Parameter(key, values)), List.of());
    }

    private static SurfaceLook look(Mesh mesh, String... shown) throws IOException {
        return new SurfaceLook(mesh, CREASE, new ImageSamples(List.of()).with(mesh.previews()), Set.of(shown));
    }

    private static double[] normal(SurfaceLook look, int place) {
        double[] normal = new double[3];
        look.normal(PLACES, place, normal);
        return normal;
    }

    private static double[] colour(SurfaceLook look, int place) {
        double[] rgb = new double[3];
        look.colour(PLACES, place, rgb);
        return rgb;
    }
}
