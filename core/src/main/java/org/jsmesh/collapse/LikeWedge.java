package org.jsmesh.collapse;

import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.Mesh;

/** Finds the wedge of a vertex that is most like one of another vertex. */
final class LikeWedge {
    private LikeWedge() {}

    /**
     * The wedge of v with the attributes nearest to those of a wedge of another vertex. Takes another wedge than the
     * first, which is negative where there is none, only when it is nearer.
     */
    static int of(CollapseMesh mesh, int v, int wanted, int first) {
        int best = first;
        double least = first < 0 ? Double.POSITIVE_INFINITY : difference(mesh.original(), wanted, first);
        CornerTable table = mesh.table();
        int start = table.cornerOf(v);
        int c = start;
        do {
            if (CornerTable.face(c) < mesh.original().faces()) {
                double d = difference(mesh.original(), wanted, mesh.wedge(c));
                if (d < least) {
                    least = d;
                    best = mesh.wedge(c);
                }
            }
            c = table.swing(c);
        } while (c != start);
        return best;
    }

    private static double difference(Mesh mesh, int a, int b) {
        double sum = 0;
        for (Channel channel : mesh.channels()) {
            for (int i = 0; i < channel.components(); i++) {
                double d = channel.number(a, i) - channel.number(b, i);
                sum += d * d;
            }
        }
        return sum;
    }
}
