package org.jsmesh.desktop;

import java.util.Map;
import org.jsmesh.mesh.Mesh;

/**
 * What is drawn: a resolution of the model and the images that it needs. Immutable, so that it can be made on the
 * session's thread and drawn on another.
 *
 * @param images by the path in {@link Surface#texture}
 */
record Scene(RenderMesh mesh, Map<String, TextureImage> images) {
    static Scene of(Mesh mesh, Framing framing, TextureImages images) {
        return new Scene(RenderMesh.of(mesh, framing), images.of(mesh));
    }
}
