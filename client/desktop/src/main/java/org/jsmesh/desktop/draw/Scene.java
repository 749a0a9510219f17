package org.jsmesh.desktop.draw;

import java.util.Map;
import org.jsmesh.display.DisplayMaterial;
import org.jsmesh.display.RenderMesh;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.studio.ContactShadow;

/**
 * The scene to draw: a resolution of the model and the images that it needs. Immutable, so that one thread can make it
 * and another can draw it.
 *
 * @param mesh with positions in the unit space of {@link Framing}
 * @param images by the path in {@link DisplayMaterial#image}
 * @param masks those of them that are opacities, likewise
 * @param isClosed whether it bounds a solid, so that nobody outside sees a face from behind
 * @param shadow on the ground beneath the model
 * @param levels the level in which each triangle of the mesh came; empty where nobody knows
 * @param lastLevel of the whole model
 */
public record Scene(
        RenderMesh mesh,
        Map<String, TextureImage> images,
        Map<String, TextureImage> masks,
        boolean isClosed,
        ContactShadow shadow,
        byte[] levels,
        int lastLevel) {
    private static final byte[] UNKNOWN = {};

    /**
     * @param creaseCosine cosine of the angle between faces above which an edge is a crease
     * @param isClosed whether the original bounds a solid
     */
    public static Scene of(Mesh mesh, double creaseCosine, boolean isClosed, Framing framing, TextureImages images) {
        RenderMesh drawn = RenderMesh.of(mesh, creaseCosine);
        RenderMesh placed = drawn.withPositions(framing.toUnit(drawn.positions()))
                .withNormals(framing.toUnitDirections(drawn.normals(), 3))
                .withTangents(framing.toUnitDirections(drawn.tangents(), 4));
        Map<String, TextureImage> known = images.of(mesh);
        ContactShadow shadow = ContactShadow.of(
                placed.positions(), placed.indices(), framing.halfX(), framing.halfY(), framing.halfZ());
        return new Scene(placed, known, images.masks(drawn.slots()), isClosed, shadow, UNKNOWN, 0);
    }

    /**
     * The same with what it takes to paint levels.
     *
     * @param from the mesh that the scene was made of
     * @param ofFaces the level in which each of its faces came
     * @param last level of the whole model
     */
    public Scene withLevels(Mesh from, byte[] ofFaces, int last) {
        int[] first = mesh.firstIndices(from);
        byte[] byPlace = new byte[ofFaces.length];
        for (int f = 0; f < ofFaces.length; f++) byPlace[first[f] / 3] = ofFaces[f];
        return new Scene(mesh, images, masks, isClosed, shadow, byPlace, last);
    }
}
