package org.jsmesh.encode;

import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;

/**
 * Checks that all numbers are finite. Archives hold no others, because there is no box around them and no distance to
 * them.
 */
final class FiniteValues {
    private FiniteValues() {}

    /**
     * @param all whether to look also at vertices and wedges that no face refers to
     * @throws IllegalArgumentException that names the first number found that is not finite
     */
    static void check(Mesh mesh, boolean all) {
        for (int wedge : mesh.faceWedges()) {
            checkVertex(mesh, mesh.wedgeVertices()[wedge]);
            for (Channel channel : mesh.channels()) checkWedge(mesh, channel, wedge);
        }
        if (!all) return;
        for (int v = 0; v < mesh.vertices(); v++) checkVertex(mesh, v);
        for (Channel channel : mesh.channels()) for (int w = 0; w < mesh.wedges(); w++) checkWedge(mesh, channel, w);
    }

    private static void checkVertex(Mesh mesh, int vertex) {
        for (int i = 3 * vertex; i < 3 * vertex + 3; i++)
            if (!Float.isFinite(mesh.positions()[i])) throw refusal("xyz".charAt(i % 3), vertex, mesh.positions()[i]);
    }

    private static void checkWedge(Mesh mesh, Channel channel, int wedge) {
        if (channel.type() != Channel.Type.FLOAT32 || channel.isAbsent(wedge)) return;
        for (int i = 0; i < channel.components(); i++) {
            float x = channel.number(wedge, i);
            if (!Float.isFinite(x)) throw refusal(channel.name(), mesh.wedgeVertices()[wedge], x);
        }
    }

    private static IllegalArgumentException refusal(Object what, int vertex, float value) {
        return new IllegalArgumentException(
                what + " of vertex " + vertex + " is " + value
                        + ", an archive holds finite numbers alone. Mend that vertex, or leave out the faces that it belongs to");
    }
}
