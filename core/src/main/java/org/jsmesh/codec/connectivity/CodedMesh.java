package org.jsmesh.codec.connectivity;

import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.patch.PatchLog;

/**
 * A simplified mesh as the encoder gets it: the base that is left, and the log of patches that lead back to the
 * original.
 */
public interface CodedMesh {
    /** The mesh that was simplified. */
    Mesh original();

    /** Corner table of the base; faces and fan vertices have the original's ids. */
    CornerTable table();

    /** Mesh vertex of each fan vertex. */
    int[] vertexOf();

    /** True for faces of the base: neither dummy nor removed. */
    boolean isLiveFace(int face);

    /**
     * Wedge at a corner of a face of the base, or the wedge at a corner of a removed face at the time of its removal.
     * Only where there are channels or materials.
     */
    int wedge(int corner);

    /** Has no face a neighbour, and the table no dummy faces? Then the log has no patches, only components. */
    default boolean isSeparate() {
        return false;
    }

    /** Fan vertex of corner j of a face of the base or of a component. */
    default int fan(int face, int j) {
        return table().vertex(CornerTable.STRIDE * face + j);
    }

    PatchLog log();

    /** Forgets the base and the log's patches from one on: they are coded and not needed again. */
    default void isCodedFrom(int patch) {}
}
