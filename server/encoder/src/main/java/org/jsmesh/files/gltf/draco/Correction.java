package org.jsmesh.files.gltf.draco;

import org.jsmesh.files.gltf.packed.PackedBytes;
import org.jsmesh.files.gltf.packed.PackedException;

/** How a predicted value and a correction make a value (Draco specification, "Prediction scheme transform"). */
interface Correction {
    void readData(PackedBytes in) throws PackedException;

    /** Whether corrections are stored without a sign. */
    boolean isPositive();

    /** Puts the value in place of the correction at {@code at} of {@code values}. */
    void correct(int[] predicted, int from, int[] values, int at);

    /** Sums that leave the range of the values come back at its other end. */
    final class Wrapped implements Correction {
        private final int components;
        private int least;
        private int most;
        private int size;

        Wrapped(int components) {
            this.components = components;
        }

        @Override
        public void readData(PackedBytes in) throws PackedException {
            least = in.nextInt();
            most = in.nextInt();
            long range = (long) most - least;
            if (range < 0 || range >= Integer.MAX_VALUE) {
                throw new PackedException("the range of the Draco values is damaged");
            }
            size = (int) range + 1;
        }

        @Override
        public boolean isPositive() {
            return false;
        }

        @Override
        public void correct(int[] predicted, int from, int[] values, int at) {
            for (int c = 0; c < components; c++) {
                int value = Math.max(least, Math.min(most, predicted[from + c])) + values[at + c];
                values[at + c] = value > most ? value - size : value < least ? value + size : value;
            }
        }
    }
}
