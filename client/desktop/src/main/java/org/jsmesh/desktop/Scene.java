package org.jsmesh.desktop;

import java.util.Map;
import org.jsmesh.display.DisplayMaterial;
import org.jsmesh.display.RenderMesh;
import org.jsmesh.mesh.Mesh;

/**
 * The scene to draw: a resolution of the model and the images that it needs. Immutable, so that one thread can make it
 * and another can draw it.
 *
 * @param mesh with positions in the unit space of {@link Framing}
 * @param images by the path in {@link DisplayMaterial#texture}
 */
record Scene(RenderMesh mesh, Map<String, TextureImage> images) {
    /** @param creaseCosine cosine of the angle between faces above which an edge is a crease */
    static Scene of(Mesh mesh, double creaseCosine, Framing framing, TextureImages images) {
        RenderMesh drawn = RenderMesh.of(mesh, creaseCosine);
        return new Scene(drawn.withPositions(framing.toUnit(drawn.positions())), images.of(mesh));
    }
}
