package org.jsmesh.codec;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jsmesh.codec.attribute.ChannelValues;
import org.jsmesh.codec.attribute.NormalSums;
import org.jsmesh.codec.lattice.Translation;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.codec.lod.LodSurface;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.MeshBuilder;

/**
 * Makes a mesh of what a {@link LodMesh} shows: without dummy faces, in model coordinates, and with normals computed
 * from the faces where exact ones are still to come.
 */
final class LodSnapshot {
    private LodSnapshot() {}

    /** A mesh without materials and textures. */
    static MeshBuilder of(LodMesh mesh, Translation translation, ChannelValues[] values) {
        int[] faceMaterials = new int[mesh.realFaces()];
        int[] corners = mesh.isSeparate() ? separateCorners(mesh) : corners(mesh, faceMaterials);
        if (mesh.isSeparate()) Arrays.fill(faceMaterials, -1);
        float[] xyz = new float[3 * mesh.vertices()];
        for (int i = 0; i < xyz.length; i++)
            xyz[i] = Float.intBitsToFloat(translation.moved(i % 3, mesh.positionBits()[i]));
        int[] wedgeVertices = new int[mesh.wedges()];
        for (int w = 0; w < wedgeVertices.length; w++) wedgeVertices[w] = mesh.wedgeVertex(w);
        List<Channel> channels = new ArrayList<>();
        for (ChannelValues v : values) {
            if (v.format.normals() != null) NormalSums.show(mesh, translation, v);
            channels.add(v.channel(mesh.wedges()));
        }
        return new MeshBuilder()
                .positions(xyz)
                .wedgeVertices(wedgeVertices)
                .faceWedges(corners)
                .faceMaterials(faceMaterials)
                .channels(channels);
    }

    private static int[] separateCorners(LodMesh mesh) {
        int[] corners = LodSurface.corners(mesh);
        for (int i = 0; i < corners.length; i++) corners[i] = mesh.vertexOf(corners[i]);
        return corners;
    }

    private static int[] corners(LodMesh mesh, int[] faceMaterials) {
        CornerTable t = mesh.table();
        int[] corners = new int[3 * faceMaterials.length];
        int n = 0;
        for (int f = 0; f < t.faces(); f++) {
            if (t.isDummy(f)) continue;
            for (int j = 0; j < 3; j++) corners[3 * n + j] = mesh.wedge(CornerTable.STRIDE * f + j);
            faceMaterials[n++] = mesh.material(f);
        }
        return corners;
    }
}
