package org.jsmesh.encode;

import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.UpAxis;

/** Draws the small picture that an archive has of its model. The encoder has no painter of its own. */
@FunctionalInterface
public interface PosterPainter {
    /**
     * Draws a model. The same model must give the same bytes.
     *
     * @param mesh the original, cleaned, with its textures
     * @param up the axis that points up
     * @return a JPEG file; empty for no poster
     */
    byte[] paint(Mesh mesh, UpAxis up);
}
