package org.jsmesh.mesh;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * The rows of faces that an identity is made of: the ranks of the corners, of the material, and the values of the face
 * channels, which have the ranks of their labels.
 */
final class FaceRows {
    private final Mesh mesh;
    private final int[] ranks;
    private final int[] materialRanks;
    private final List<FaceChannel> channels;
    private final List<List<String>> labels = new ArrayList<>(); // used ones, sorted
    private final List<int[]> values = new ArrayList<>();
    private int width = 4;

    FaceRows(Mesh mesh, int[] ranks, int[] materialRanks) {
        this.mesh = mesh;
        this.ranks = ranks;
        this.materialRanks = materialRanks;
        channels = new ArrayList<>(mesh.faceChannels());
        channels.sort(Comparator.comparing(FaceChannel::name));
        for (FaceChannel c : channels) {
            width += c.words();
            List<String> used = usedLabels(c);
            labels.add(used);
            values.add(used.isEmpty() ? c.values() : ranked(c, used));
        }
    }

    private static List<String> usedLabels(FaceChannel c) {
        if (c.labels().isEmpty()) return List.of();
        boolean[] used = new boolean[c.labels().size()];
        for (int value : c.values()) used[value] = true;
        List<String> list = new ArrayList<>();
        for (int i = 0; i < used.length; i++) if (used[i]) list.add(c.labels().get(i));
        list.sort(Comparator.naturalOrder());
        for (int i = list.size() - 1; i > 0; i--) if (list.get(i).equals(list.get(i - 1))) list.remove(i);
        return list;
    }

    private static int[] ranked(FaceChannel c, List<String> sorted) {
        int[] rank = new int[c.labels().size()];
        for (int i = 0; i < rank.length; i++)
            rank[i] = search(sorted, c.labels().get(i));
        int[] ranked = new int[c.values().length];
        for (int f = 0; f < ranked.length; f++) ranked[f] = rank[c.values()[f]];
        return ranked;
    }

    private static int search(List<String> sorted, String text) {
        int low = 0;
        int high = sorted.size();
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (sorted.get(middle).compareTo(text) < 0) low = middle + 1;
            else high = middle;
        }
        return low;
    }

    /** Hashes what channels there are; nothing where there are none. */
    void describe(HashedNumbers sha) {
        if (channels.isEmpty()) return;
        sha.updateInt(channels.size());
        for (int i = 0; i < channels.size(); i++) {
            FaceChannel c = channels.get(i);
            describe(sha, c.name());
            sha.updateInt(c.components());
            sha.updateInt(c.type().ordinal());
            sha.updateInt(labels.get(i).size());
            for (String label : labels.get(i)) describe(sha, label);
        }
    }

    private static void describe(HashedNumbers sha, String text) {
        byte[] bytes = Utf8.bytes(text);
        sha.updateInt(bytes.length);
        sha.update(bytes);
    }

    /** Ints per row. */
    int width() {
        return width;
    }

    /** Puts the row of a face into an array. */
    void fill(int[] rows, int at, int face) {
        int a = ranks[mesh.faceWedges()[3 * face]];
        int b = ranks[mesh.faceWedges()[3 * face + 1]];
        int c = ranks[mesh.faceWedges()[3 * face + 2]];
        while (b < a
                || c < a
                || c == a
                        && b != a) { // smallest first; if there are two smallest, the one that is followed by the other
            int t = a;
            a = b;
            b = c;
            c = t;
        }
        rows[at] = a;
        rows[at + 1] = b;
        rows[at + 2] = c;
        int m = mesh.faceMaterials()[face];
        rows[at + 3] = m < 0 ? -1 : materialRanks[m];
        int to = at + 4;
        for (int i = 0; i < channels.size(); i++) {
            int words = channels.get(i).words();
            for (int k = 0; k < words; k++) rows[to++] = values.get(i)[words * face + k];
        }
    }
}
