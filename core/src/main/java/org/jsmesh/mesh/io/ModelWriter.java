package org.jsmesh.mesh.io;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.mesh.Mesh;

/**
 * Writes meshes as model files of every format but glTF, which the encoder module adds. Numbers read back to the same
 * bits.
 */
public final class ModelWriter {
    private ModelWriter() {}

    /**
     * Writes a mesh and, where the format has them, its materials and textures.
     *
     * @param mesh any mesh
     * @param format of the file
     * @param fileName of the model file, without folders; files beside it are named after it or after the textures'
     *     paths
     * @param sink takes the files
     * @return what the format cannot hold or holds in another way, one sentence each
     * @throws IllegalArgumentException for {@link ModelFormat#GLB} and {@link ModelFormat#THREE_MF}
     * @throws IOException from the sink
     */
    public static List<String> write(Mesh mesh, ModelFormat format, String fileName, ResourceSink sink)
            throws IOException {
        List<String> notes = new ArrayList<>();
        switch (format) {
            case PLY -> new PlyWriter(mesh, notes).write(fileName, sink);
            case OBJ -> new ObjWriter(mesh, notes).write(fileName, sink);
            case STL -> new StlWriter(mesh, notes).write(fileName, sink);
            case OFF -> new OffWriter(mesh, notes).write(fileName, sink);
            case HOPPE_M -> new HoppeWriter(mesh, notes).write(fileName, sink);
            case THREE_MF -> throw new IllegalArgumentException("3MF is read and not written");
            case GLB -> throw new IllegalArgumentException("glTF is written by the encoder module (ModelFiles)");
        }
        return List.copyOf(notes);
    }
}
