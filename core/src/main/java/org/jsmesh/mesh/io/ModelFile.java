package org.jsmesh.mesh.io;

import java.util.List;
import org.jsmesh.mesh.Mesh;

/**
 * What was read from a model file.
 *
 * @param mesh the mesh
 * @param format of the file
 * @param notes what was changed, skipped or not found, one sentence each; empty when the mesh is all that the file says
 */
public record ModelFile(Mesh mesh, ModelFormat format, List<String> notes) {
    public ModelFile {
        notes = List.copyOf(notes);
    }
}
