package org.jsmesh.files.gltf.draco;

import org.jsmesh.files.gltf.packed.PackedBytes;
import org.jsmesh.files.gltf.packed.PackedException;

/** Predicts that two neighbouring faces make a parallelogram. */
class ParallelogramPrediction extends Prediction {
    final ValueOrder order;

    ParallelogramPrediction(Correction correction, int components, ValueOrder order) {
        super(correction, components);
        this.order = order;
    }

    @Override
    void restore(int[] values) throws PackedException {
        int[] predicted = new int[components];
        correction.correct(predicted, 0, values, 0);
        for (int entry = 1; entry < order.corners().length; entry++) {
            int at = entry * components;
            if (predict(entry, order.corners()[entry], values, predicted)) {
                correction.correct(predicted, 0, values, at);
            } else {
                correction.correct(values, at - components, values, at);
            }
        }
    }

    /** Predicts from the face opposite to a corner, if its values are known. */
    final boolean predict(int entry, int corner, int[] values, int[] predicted) throws PackedException {
        int across = order.table().opposite(corner);
        if (across == CornerTable.NONE) return false;
        int tip = order.entry(across);
        int next = order.entry(CornerTable.next(across));
        int previous = order.entry(CornerTable.previous(across));
        if (tip >= entry || next >= entry || previous >= entry) return false;
        for (int c = 0; c < components; c++) {
            predicted[c] =
                    values[next * components + c] + values[previous * components + c] - values[tip * components + c];
        }
        return true;
    }

    /** The mean of up to four such predictions, of which bits tell which ones to use. */
    static final class Several extends ParallelogramPrediction {
        private static final int MOST = 4;
        /** For each number of predictions: which ones are not to be used. */
        private final boolean[][] creases = new boolean[MOST][];

        private final int[] used = new int[MOST];

        Several(Correction correction, int components, ValueOrder order) {
            super(correction, components, order);
        }

        @Override
        void readData(PackedBytes in) throws PackedException {
            for (int i = 0; i < MOST; i++) {
                int count = in.count();
                if (count > order.table().corners()) throw new PackedException("the Draco mesh has too many creases");
                creases[i] = new boolean[count];
                if (count == 0) continue;
                RansBits bits = new RansBits(in);
                for (int j = 0; j < count; j++) creases[i][j] = bits.next();
            }
            super.readData(in);
        }

        @Override
        void restore(int[] values) throws PackedException {
            int[][] predictions = new int[MOST][components];
            correction.correct(predictions[0], 0, values, 0);
            for (int entry = 1; entry < order.corners().length; entry++) {
                int found = predictAround(entry, values, predictions);
                int at = entry * components;
                if (mean(predictions, found)) correction.correct(predictions[0], 0, values, at);
                else correction.correct(values, at - components, values, at);
            }
        }

        private int predictAround(int entry, int[] values, int[][] predictions) throws PackedException {
            CornerTable table = order.table();
            int start = order.corners()[entry];
            int found = 0;
            int corner = start;
            while (corner != CornerTable.NONE) {
                if (predict(entry, corner, values, predictions[found]) && ++found == MOST) return found;
                corner = table.swingLeft(corner);
                if (corner == start) return found;
            }
            for (corner = table.swingRight(start); corner != CornerTable.NONE; corner = table.swingRight(corner)) {
                if (predict(entry, corner, values, predictions[found]) && ++found == MOST) return found;
            }
            return found;
        }

        /** Puts the mean of the predictions to be used into the first one. Returns whether there are any. */
        private boolean mean(int[][] predictions, int found) throws PackedException {
            int count = 0;
            for (int i = 0; i < found; i++) {
                boolean[] unused = creases[found - 1];
                if (used[found - 1] == unused.length) throw new PackedException("the Draco mesh has too few creases");
                if (unused[used[found - 1]++]) continue;
                if (count++ == 0) {
                    System.arraycopy(predictions[i], 0, predictions[0], 0, components);
                } else {
                    for (int c = 0; c < components; c++) predictions[0][c] += predictions[i][c];
                }
            }
            for (int c = 0; count > 1 && c < components; c++) predictions[0][c] /= count;
            return count > 0;
        }
    }
}
