package org.jsmesh.codec.connectivity;

import org.jsmesh.codec.entropy.BinaryCoder;

/**
 * Codes the run of faces about a vertex that its new vertex takes. It grows from a seed edge that will leave the
 * vertex, then edge by edge on both sides. Seed edges are tried in the order of their length against their opposite
 * diagonal.
 */
final class RunCoder {
    private final SplitRing ring;
    private final int[] single = BinaryCoder.newContexts(13 * 32);
    private final int[] singleSlot = BinaryCoder.newContexts(64);
    private final CutModel cuts = new CutModel();
    private int slots;
    private int start;
    private int length;

    /** @param ring the faces about the vertex, measured before each run */
    RunCoder(SplitRing ring) {
        this.ring = ring;
    }

    /** The slot of the run's first face. */
    int start() {
        return start;
    }

    /** Faces of the run. */
    int length() {
        return length;
    }

    /**
     * Codes the next run.
     *
     * @param plan the encoder's, which has found the runs about this vertex
     * @param candidates edges that may leave the vertex
     */
    void code(BinaryCoder coder, PatchPlan plan, int slots, int candidates) {
        this.slots = slots;
        if (candidates == 0) {
            codeSingle(coder, plan);
            return;
        }
        int best = ring.longest();
        int context = Math.min(slots, 12) * 32 + ring.shape(best) / 2;
        if (coder.bit(single, context, coder.isEncoder() && !plan.hasLongRun() ? 1 : 0) != 0) codeSingle(coder, plan);
        else codeLong(coder, plan, candidates, best);
    }

    private void codeSingle(BinaryCoder coder, PatchPlan plan) {
        int target = coder.isEncoder() ? plan.shortRun() : -1;
        int left = 0;
        for (int j = 0; j < slots; j++) if (!ring.used[j]) left++;
        int j = 0;
        for (; j < slots; j++) {
            if (ring.used[j]) continue;
            int context = Math.min(ring.valences[j], 7) * 8 + Math.min(ring.valences[j + 1 == slots ? 0 : j + 1], 7);
            if (left == 1 || coder.bit(singleSlot, context, j == target ? 1 : 0) != 0) break;
            left--;
        }
        start = j;
        length = 1;
    }

    private void codeLong(BinaryCoder coder, PatchPlan plan, int candidates, int best) {
        boolean encoder = coder.isEncoder();
        int rank = 0;
        int left = candidates;
        int j = best;
        while (true) {
            if (left == 1) {
                if (encoder) plan.isInterior(j);
                break;
            }
            int next = rank == 0 ? ring.secondLongest() : ring.longestBut(j);
            int gap = Math.max(0, Math.min(15, ring.shape(j) - ring.shape(next) >> 1));
            int before = ring.edge(before(j));
            int behind = ring.edge(after(j));
            int bit = encoder && plan.isInterior(j) ? 1 : 0;
            if (cuts.codeSeed(coder, rank, left, slots, gap, ring.edge(j), before, behind, bit) != 0) break;
            ring.exclude(j);
            j = next;
            left--;
            rank++;
        }
        grow(coder, plan, j, Math.min(rank, 1));
    }

    private void grow(BinaryCoder coder, PatchPlan plan, int seedEdge, int later) {
        int low = seedEdge;
        int high = seedEdge;
        int count = 2;
        while (count < slots - 1) {
            int edge = before(low);
            if (!ring.isCandidate(edge) || edge == high) break;
            int kind = (low == seedEdge ? 4 : 0) + later;
            if (growBit(coder, plan, 0, edge, before(edge), after(high), count, kind) == 0) break;
            low = edge;
            count++;
        }
        while (count < slots - 1) {
            int edge = after(high);
            if (!ring.isCandidate(edge) || edge == low) break;
            int end = ring.valences[before(low)];
            int kind = end <= 5 ? 1 : end == 6 ? 2 : 3;
            if (growBit(coder, plan, 1, edge, after(edge), before(low), count, kind) == 0) break;
            high = edge;
            count++;
        }
        start = before(low);
        length = count;
    }

    private int growBit(
            BinaryCoder coder, PatchPlan plan, int side, int edge, int beyond, int end, int count, int kind) {
        int bit = coder.isEncoder() && plan.isInteriorOfCurrent(edge) ? 1 : 0;
        return cuts.codeGrowth(
                coder, side, count, slots, kind, ring.edge(edge), ring.edge(beyond), ring.edge(end), bit);
    }

    private int before(int slot) {
        return slot == 0 ? slots - 1 : slot - 1;
    }

    private int after(int slot) {
        return slot == slots - 1 ? 0 : slot + 1;
    }
}
