package org.jsmesh.files.gltf.draco;

import org.jsmesh.files.gltf.packed.PackedBytes;
import org.jsmesh.files.gltf.packed.PackedException;

/** What each face shares with those before it, for {@link EdgebreakerFaces}; this one codes it in one or three bits. */
class EdgebreakerSymbols {
    static final int C = 0;
    static final int S = 1;
    static final int L = 3;
    static final int R = 5;
    static final int E = 7;

    private final BitReader bits;

    EdgebreakerSymbols(PackedBytes coded) {
        bits = coded == null ? null : new BitReader(coded);
    }

    int next() throws PackedException {
        return bits.next(1) == 0 ? C : 1 | bits.next(2) << 1;
    }

    /** Tells that the face of a symbol was added, and where the next one will be. */
    void reached(int corner) {}

    /** Tells that a vertex takes the place of another. */
    void merge(int kept, int removed) {}

    /** Symbols that are coded apart for each valence of the vertex after the active corner. */
    static final class ByValence extends EdgebreakerSymbols {
        private static final int LEAST = 2;
        private static final int MOST = 7;
        private static final int[] BY_NUMBER = {C, S, L, R, E};

        private final CornerTable table;
        private final int[] valences;
        private final int[][] symbols = new int[MOST - LEAST + 1][];
        private final int[] left = new int[symbols.length];
        /** Which symbols come next; at the start there are none. */
        private int context = -1;

        private int last;

        ByValence(PackedBytes in, CornerTable table, int mostVertices) throws PackedException {
            super(null);
            this.table = table;
            valences = new int[mostVertices];
            for (int i = 0; i < symbols.length; i++) {
                int count = in.count();
                if (count > table.corners() / 3) throw new PackedException("the Draco mesh has too many symbols");
                symbols[i] = RansSymbols.decode(in, count, 1);
                left[i] = count;
            }
        }

        @Override
        int next() throws PackedException {
            if (context < 0) return last = E;
            if (left[context] == 0) throw new PackedException("the Draco mesh has too few symbols");
            int number = symbols[context][--left[context]];
            if (number >= BY_NUMBER.length) throw new PackedException("a symbol of the Draco mesh is not known");
            return last = BY_NUMBER[number];
        }

        @Override
        void reached(int corner) {
            int vertex = table.vertex(corner);
            int next = table.vertex(CornerTable.next(corner));
            int previous = table.vertex(CornerTable.previous(corner));
            valences[next] += last == L || last == E ? 2 : 1;
            valences[previous] += last == R || last == E ? 2 : 1;
            if (last != C && last != S) valences[vertex] += last == E ? 2 : 1;
            context = Math.max(LEAST, Math.min(MOST, valences[next])) - LEAST;
        }

        @Override
        void merge(int kept, int removed) {
            valences[kept] += valences[removed];
        }
    }
}
