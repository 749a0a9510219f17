package org.jsmesh.files.gltf.draco;

import org.jsmesh.files.gltf.packed.PackedBytes;
import org.jsmesh.files.gltf.packed.PackedException;

/**
 * Predicts texture coordinates from the shape of a face in space (Draco specification, "Prediction texcoords decoder"):
 * its tip lies on one of two sides of the known edge, and bits tell on which.
 */
final class TextureCoordinatePrediction extends Prediction {
    private final ValueOrder order;
    private final Positions positions;
    private final long[] tip = new long[3];
    private final long[] next = new long[3];
    private final long[] previous = new long[3];
    private boolean[] sides;
    private int sidesLeft;

    TextureCoordinatePrediction(Correction correction, ValueOrder order, Positions positions) {
        super(correction, 2);
        this.order = order;
        this.positions = positions;
    }

    @Override
    void readData(PackedBytes in) throws PackedException {
        int count = in.nextInt();
        if (count < 0 || count > order.corners().length) throw new PackedException("the Draco mesh has too many sides");
        sides = new boolean[count];
        sidesLeft = count;
        RansBits changes = new RansBits(in);
        boolean side = true;
        for (int i = 0; i < count; i++) {
            side ^= !changes.next();
            sides[i] = side;
        }
        super.readData(in);
    }

    @Override
    void restore(int[] values) throws PackedException {
        int[] predicted = new int[2];
        for (int entry = 0; entry < order.corners().length; entry++) {
            predict(entry, order.corners()[entry], values, predicted);
            correction.correct(predicted, 0, values, 2 * entry);
        }
    }

    private void predict(int entry, int corner, int[] values, int[] predicted) throws PackedException {
        int nextCorner = CornerTable.next(corner);
        int previousCorner = CornerTable.previous(corner);
        int nextEntry = order.entry(nextCorner);
        int previousEntry = order.entry(previousCorner);
        if (nextEntry < entry && previousEntry < entry) {
            if (values[2 * nextEntry] == values[2 * previousEntry]
                    && values[2 * nextEntry + 1] == values[2 * previousEntry + 1]) {
                copy(previousEntry, values, predicted);
                return;
            }
            positions.get(corner, tip);
            positions.get(nextCorner, next);
            positions.get(previousCorner, previous);
            if (predictByShape(nextEntry, previousEntry, values, predicted)) return;
        }
        if (nextEntry < entry) copy(nextEntry, values, predicted);
        else if (entry > 0) copy(entry - 1, values, predicted);
        else predicted[0] = predicted[1] = 0;
    }

    private static void copy(int entry, int[] values, int[] predicted) {
        predicted[0] = values[2 * entry];
        predicted[1] = values[2 * entry + 1];
    }

    /** The known edge goes from {@code next} to {@code previous}. Whether it has a length. */
    private boolean predictByShape(int nextEntry, int previousEntry, int[] values, int[] predicted)
            throws PackedException {
        long square = 0;
        long along = 0;
        for (int i = 0; i < 3; i++) {
            long edge = previous[i] - next[i];
            square += edge * edge;
            along += edge * (tip[i] - next[i]);
        }
        if (square == 0) return false;
        if (square < 0) throw overflow();
        long u = values[2 * nextEntry];
        long v = values[2 * nextEntry + 1];
        long edgeU = values[2 * previousEntry] - u;
        long edgeV = values[2 * previousEntry + 1] - v;
        requireProduct(Math.max(Math.abs(u), Math.abs(v)), square);
        requireProduct(along, Math.max(Math.abs(edgeU), Math.abs(edgeV)));
        long distance = 0;
        for (int i = 0; i < 3; i++) {
            long edge = previous[i] - next[i];
            requireProduct(along, Math.abs(edge));
            long foot = next[i] + along * edge / square;
            distance += (tip[i] - foot) * (tip[i] - foot);
        }
        long across = root(distance * square);
        if (sidesLeft == 0) throw new PackedException("the Draco mesh has too few sides");
        long side = sides[--sidesLeft] ? across : -across;
        predicted[0] = (int) ((u * square + along * edgeU + edgeV * side) / square);
        predicted[1] = (int) ((v * square + along * edgeV - edgeU * side) / square);
        return true;
    }

    private static void requireProduct(long a, long b) throws PackedException {
        if (b != 0 && (a == Long.MIN_VALUE || Math.abs(a) > Long.MAX_VALUE / b)) throw overflow();
    }

    private static PackedException overflow() {
        return new PackedException("positions of the Draco mesh are out of range");
    }

    /** The whole part of the square root of an unsigned number. */
    private static long root(long square) {
        long root = (long) Math.sqrt(square >= 0 ? square : square + 0x1p64);
        while (Long.compareUnsigned(root * root, square) > 0 || root > 0xFFFFFFFFL) root--;
        while (root < 0xFFFFFFFFL && Long.compareUnsigned((root + 1) * (root + 1), square) <= 0) root++;
        return root;
    }
}
