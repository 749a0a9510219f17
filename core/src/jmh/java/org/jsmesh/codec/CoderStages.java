package org.jsmesh.codec;

import java.lang.reflect.Field;
import org.jsmesh.codec.connectivity.ConnectivityCoder;
import org.jsmesh.codec.connectivity.SplitLane;
import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.codec.position.PositionCoder;
import org.jsmesh.mesh.MalformedStreamException;

/**
 * Runs the stages of a {@link MeshCoder} one by one, as {@link MeshCoder#codeSplits} does them together, so that they
 * can be measured.
 */
public final class CoderStages {
    private final LodMesh mesh;
    private final ConnectivityCoder connectivity;
    private final PositionCoder positions;
    private final int firstFan;
    private final SplitLane lane;
    private int placed;

    /**
     * @param coder at the beginning of a pass
     * @param splits of the pass
     */
    public CoderStages(MeshCoder coder, int splits) {
        SplitCoder splitCoder = part(coder, "splits", SplitCoder.class);
        mesh = part(splitCoder, "mesh", LodMesh.class);
        connectivity = part(splitCoder, "connectivity", ConnectivityCoder.class);
        positions = part(splitCoder, "positions", PositionCoder.class);
        firstFan = mesh.fans();
        lane = part(splitCoder, "lane", SplitLane.class);
        lane.begin(splits);
    }

    /** A coder does not hand out its parts, and for a benchmark alone it should not begin to. */
    private static <T> T part(Object coder, String name, Class<T> type) {
        try {
            Field field = coder.getClass().getDeclaredField(name);
            field.setAccessible(true);
            return type.cast(field.get(coder));
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Decodes the connectivity of the next splits and applies them. */
    public void applySplits(BinaryCoder stream, int count) throws MalformedStreamException {
        for (int i = 0; i < count; i++) connectivity.codeSplit(stream, null);
    }

    /** Predicts and decodes the positions of the next new vertices. */
    public void placeVertices(BinaryCoder stream, int count) throws MalformedStreamException {
        for (int end = placed + count; placed < end; placed++)
            positions.codeFromRing(stream, firstFan + placed, lane, placed, -1);
    }

    /** Vertices of the mesh now. */
    public int vertices() {
        return mesh.vertices();
    }
}
