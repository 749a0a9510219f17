package org.jsmesh.mesh.io;

import java.util.List;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Note;

/**
 * The result of reading a model file.
 *
 * @param mesh the mesh
 * @param format of the file
 * @param notes what the file says and the mesh does not, or says in another way, in the order in which it was found
 */
public record ModelFile(Mesh mesh, ModelFormat format, List<Note> notes) {
    /**
     * Copies the list.
     *
     * @param mesh see {@link #mesh()}
     * @param format see {@link #format()}
     * @param notes see {@link #notes()}
     */
    public ModelFile {
        notes = List.copyOf(notes);
    }
}
