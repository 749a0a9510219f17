package org.jsmesh.files.gltf.draco;

import java.util.Map;
import org.jsmesh.files.gltf.packed.PackedBytes;
import org.jsmesh.files.gltf.packed.PackedException;

/** Attributes whose values stand in the same order in the stream (Draco specification, "Attributes decoder"). */
final class AttributeGroup {
    private static final int PER_VERTEX = 0;
    private static final int DEPTH_FIRST = 0;
    private static final int BY_DEGREE = 1;

    private final PackedBytes in;
    private final DracoLimits limits;
    private final int[] indices;
    private final int points;
    /** Null for a mesh without one, whose values are those of the points. */
    private final CornerTable table;

    private final boolean byDegree;
    private AttributeDecoder[] attributes;

    AttributeGroup(PackedBytes in, DracoLimits limits, Edgebreaker connectivity, int[] indices, int points)
            throws PackedException {
        this.in = in;
        this.limits = limits;
        this.indices = indices;
        this.points = points;
        if (connectivity == null) {
            table = null;
            byDegree = false;
            return;
        }
        int seams = (byte) in.next();
        boolean perVertex = in.next() == PER_VERTEX;
        int traversal = in.next();
        if (seams >= connectivity.seams.length || seams < 0 && !perVertex) {
            throw new PackedException("attributes of the Draco mesh refer to seams that are not there");
        }
        if (traversal != DEPTH_FIRST && !(perVertex && traversal == BY_DEGREE)) {
            throw new PackedException("the traversal " + traversal + " of the Draco mesh is not known");
        }
        table = perVertex ? connectivity.table : connectivity.seams[seams];
        byDegree = traversal == BY_DEGREE;
    }

    void readKinds() throws PackedException {
        int count = in.count();
        limits.takeAttributes(count);
        AttributeKind[] kinds = new AttributeKind[count];
        for (int i = 0; i < count; i++) kinds[i] = AttributeKind.read(in);
        attributes = new AttributeDecoder[count];
        for (int i = 0; i < count; i++) attributes[i] = new AttributeDecoder(kinds[i], in.next());
    }

    /** Reads all values. Returns those of the positions, as whole numbers, when it has some and others have not. */
    Positions readValues(Positions known, Map<Integer, DracoAttribute> found) throws PackedException {
        ValueOrder order = order();
        int entries = order == null ? points : order.corners().length;
        Positions positions = known;
        for (AttributeDecoder attribute : attributes) {
            limits.takeValues(entries, attribute.kind.components());
            attribute.readIntegers(in, entries, order, positions);
            if (positions == null) positions = attribute.positions(order);
        }
        for (AttributeDecoder attribute : attributes) attribute.readTransform(in);
        for (AttributeDecoder attribute : attributes) {
            limits.takeValues(points, attribute.kind.components());
            attribute.requireSize(points);
            byte[] values = perPoint(attribute.values(entries), entries, order);
            found.putIfAbsent(attribute.kind.uniqueId(), attribute.kind.attribute(values));
        }
        return positions;
    }

    private ValueOrder order() throws PackedException {
        if (table == null) return null;
        return byDegree ? Traversal.byDegree(table) : Traversal.depthFirst(table);
    }

    private byte[] perPoint(byte[] values, int entries, ValueOrder order) throws PackedException {
        if (order == null || entries == 0) return values;
        int size = values.length / entries;
        byte[] result = new byte[points * size];
        for (int c = 0; c < indices.length; c++) {
            System.arraycopy(values, order.entry(c) * size, result, indices[c] * size, size);
        }
        return result;
    }
}
