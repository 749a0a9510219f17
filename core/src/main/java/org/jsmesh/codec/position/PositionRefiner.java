package org.jsmesh.codec.position;

import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.OffsetCoder;
import org.jsmesh.codec.lod.LodMesh;

/**
 * Codes more bits of known positions, vertex after vertex. Where the neighbours predict the bits, as on planes, they
 * are coded from predictions. Where the bits are noise, as in scans, they are raw, and the neighbours are not looked
 * at. The first vertices of each block decide.
 */
final class PositionRefiner {
    private static final int BLOCK = 1024;
    private static final int PATIENCE = 8; // blocks in a row that are not worth it before they become longer
    private static final int MOST_DOUBLED = 3; // times
    private static final int TRIAL = 128;
    private static final int WORTH = 32; // a saving of less than 1/32 is not worth the time that predictions take

    private final LodMesh mesh;
    private final Ring ring;
    private final OffsetCoder offsets = new OffsetCoder(3);
    private int failed; // blocks in a row
    private int done; // vertices of the block
    private boolean predicts;

    PositionRefiner(LodMesh mesh, Ring ring) {
        this.mesh = mesh;
        this.ring = ring;
    }

    void begin() {
        done = 0;
        failed = 0;
    }

    /**
     * @param from shift of the units in which the position is known
     * @param to shift of the units wanted, smaller, or the same where a sweep moves other vertices alone
     * @param wanted cells, for the encoder
     * @param units receives the position
     * @return how many of the ring's first vertices are already as precise
     */
    int code(BinaryCoder coder, int vertex, int from, int to, int[] wanted, int[] units) {
        if (from == to) {
            for (int a = 0; a < 3; a++) units[a] = mesh.places()[4 * mesh.firstFan(vertex) + a] >> to;
            return 0;
        }
        if (done == 0) {
            predicts = true;
            offsets.startCounting();
        } else if (done == TRIAL) {
            int saved = WORTH * offsets.settle();
            int bar = 3 * (from - to) * TRIAL;
            predicts = saved > bar;
            failed = 4 * saved > bar ? 0 : failed + 1;
        }
        done = done + 1 == BLOCK << Math.max(0, Math.min(MOST_DOUBLED, failed - PATIENCE)) ? 0 : done + 1;
        int fan = mesh.firstFan(vertex);
        int bits = from - to;
        if (predicts) {
            ring.measure(fan);
            if (ring.size > 0) return predict(coder, vertex, fan, from, to, wanted, units);
        }
        codeRaw(coder, 4 * fan, from, bits, wanted, to, units);
        return 0;
    }

    /** Codes all new bits of a position raw, and as one number where they are few. */
    private void codeRaw(BinaryCoder coder, int at, int from, int bits, int[] wanted, int to, int[] units) {
        int[] places = mesh.places();
        int mask = (1 << bits) - 1;
        int x = wanted[0] >> to & mask;
        int y = wanted[1] >> to & mask;
        int z = wanted[2] >> to & mask;
        if (3 * bits <= 16) {
            int all = coder.raw(x << 2 * bits | y << bits | z, 3 * bits);
            x = all >> 2 * bits;
            y = all >> bits & mask;
            z = all & mask;
        } else {
            x = coder.raw(x, bits);
            y = coder.raw(y, bits);
            z = coder.raw(z, bits);
        }
        units[0] = (places[at] >> from << bits) + x;
        units[1] = (places[at + 1] >> from << bits) + y;
        units[2] = (places[at + 2] >> from << bits) + z;
    }

    private int predict(BinaryCoder coder, int vertex, int fan, int from, int to, int[] wanted, int[] units) {
        int known = 0;
        for (int i = 0; i < ring.size; i++) {
            int neighbour = ring.neighbour[i];
            if (mesh.vertexOf(neighbour) < vertex) ring.neighbour[known++] = neighbour;
        }
        for (int role = 0; role < 3; role++) {
            int a = role == 0 ? ring.first : role == 1 ? ring.second : ring.normalAxis;
            double predicted = role < 2
                    ? ring.mean[a]
                    : ring.height(middle(units[ring.first], to), middle(units[ring.second], to));
            units[a] = codeUnit(
                    coder, role, a, mesh.places()[4 * fan + a] >> from, from, to, known, predicted, wanted[a] >> to);
        }
        return known;
    }

    private int codeUnit(
            BinaryCoder coder,
            int role,
            int axis,
            int unit,
            int from,
            int to,
            int known,
            double predicted,
            int wanted) {
        int[] cells = mesh.places();
        int candidate = 0;
        int agreeing = 0;
        for (int i = 0; i < known; i++) {
            int c = cells[4 * ring.neighbour[i] + axis];
            if (c >> from != unit) continue;
            if (agreeing == 0) candidate = c >> to;
            if (c >> to == candidate) agreeing++;
        }
        if (agreeing > 0 && offsets.codeSame(coder, agreeing, wanted == candidate)) {
            offsets.countSame(from - to);
            return candidate;
        }
        int bits = from - to;
        int low = unit << bits;
        int expected = (PositionCoder.round(predicted) >> to) - low;
        int most = 2 << Math.min(bits, 27);
        expected = expected < -most ? -most : Math.min(expected, most);
        return low + offsets.code(coder, role, expected, bits, wanted - low);
    }

    private static int middle(int unit, int shift) {
        return shift == 0 ? unit : (unit << shift) + (1 << shift - 1);
    }
}
