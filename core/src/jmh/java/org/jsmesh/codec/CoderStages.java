package org.jsmesh.codec;

import java.lang.reflect.Field;
import org.jsmesh.mesh.MalformedStreamException;

/** Runs the stages of a {@link MeshCoder} one by one, as {@link MeshCoder#codeSplits} does them together, so that they can be measured. */
public final class CoderStages {
    private final LodMesh mesh;
    private final ConnectivityCoder connectivity;
    private final PositionCoder positions;
    private final int firstFan;
    private final int[] parents;
    private final int[] ringEnds;
    private int split;
    private int placed;

    /**
     * @param coder at the beginning of a pass
     * @param splits of the pass
     */
    public CoderStages(MeshCoder coder, int splits) {
        mesh = part(coder, "mesh", LodMesh.class);
        connectivity = part(coder, "connectivity", ConnectivityCoder.class);
        positions = part(coder, "positions", PositionCoder.class);
        firstFan = mesh.fans();
        parents = new int[splits];
        ringEnds = new int[splits + 1];
        connectivity.forgetRings();
    }

    /** A coder does not hand out its parts, and for a benchmark alone it should not begin to. */
    private static <T> T part(MeshCoder coder, String name, Class<T> type) {
        try {
            Field field = MeshCoder.class.getDeclaredField(name);
            field.setAccessible(true);
            return type.cast(field.get(coder));
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Decodes the connectivity of the next splits and applies them. */
    public void applySplits(BinaryCoder stream, int count) throws MalformedStreamException {
        for (int end = split + count; split < end; split++) {
            connectivity.codeSplit(stream, null);
            parents[split] = connectivity.splitVertex();
            ringEnds[split + 1] = connectivity.ringsEnd();
        }
    }

    /** Predicts and decodes the positions of the next new vertices. */
    public void placeVertices(BinaryCoder stream, int count) throws MalformedStreamException {
        for (int end = placed + count; placed < end; placed++)
            positions.codeFromRing(
                    stream,
                    firstFan + placed,
                    connectivity.rings(),
                    ringEnds[placed],
                    ringEnds[placed + 1],
                    parents[placed],
                    -1);
    }

    /** Vertices of the mesh now. */
    public int vertices() {
        return mesh.vertices();
    }
}
