package org.jsmesh.codec.exact;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.IntegerModel;
import org.jsmesh.codec.entropy.TextModel;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Sizes;

/**
 * Codes an attribute of the faces, face after face. A bit says whether a face has the value of one of the faces that
 * were coded last at its three vertices; groups and materials are patches of the surface, so it mostly has.
 */
final class FaceChannelCoder {
    private static final int SMALL = 1 << 20;
    private final BinaryCoder coder;
    private final Mesh mesh;
    private final IntegerModel numbers = new IntegerModel(2);
    private final int[] same = BinaryCoder.newContexts(4);
    private final int[] other = BinaryCoder.newContexts(1);
    private final int[] small = BinaryCoder.newContexts(1);
    private final int[] last; // face coded last at each vertex
    private final int[] near = new int[3]; // faces coded last at the vertices of the present one
    private int words;
    private int[] values;
    private int before; // the whole number coded last

    FaceChannelCoder(BinaryCoder coder, Mesh mesh) {
        this.coder = coder;
        this.mesh = mesh;
        last = new int[mesh.vertices()];
        Arrays.fill(last, -1);
    }

    /**
     * Codes a channel.
     *
     * @param kind the channel without values
     * @param wanted its values in the order of the mesh's faces; of no meaning to a decoder
     */
    FaceChannel code(FaceChannel kind, FaceChannel wanted) throws MalformedStreamException {
        boolean write = coder.isEncoder();
        List<String> labels = codeLabels(write ? wanted.labels() : null);
        if (!labels.isEmpty() && (kind.components() != 1 || kind.type() != Channel.Type.INT32))
            throw new MalformedStreamException(-1, "labels of " + kind.name() + " are not numbered by one INT32");
        words = kind.words();
        values = new int[Sizes.of(words, mesh.faces(), "faces with " + kind.name())];
        int[] given = write ? wanted.values() : values;
        for (int f = 0; f < mesh.faces(); f++) {
            if ((f & 15) == 0 && coder.isExhausted()) throw new MalformedStreamException(-1, "values end early");
            codeFace(kind, labels, f, given);
            for (int j = 0; j < 3; j++) last[mesh.vertex(f, j)] = f;
        }
        return new FaceChannel(kind.name(), kind.components(), kind.type(), values, labels);
    }

    private List<String> codeLabels(List<String> wanted) throws MalformedStreamException {
        int count = numbers.unsigned(coder, 0, wanted == null ? 0 : wanted.size());
        List<String> labels = new ArrayList<>();
        TextModel texts = count > 0 ? new TextModel() : null;
        for (int i = 0; i < count; i++) {
            if (coder.isExhausted()) throw new MalformedStreamException(-1, "labels end early");
            labels.add(texts.code(coder, wanted == null ? null : wanted.get(i)));
        }
        return labels;
    }

    private void codeFace(FaceChannel kind, List<String> labels, int face, int[] given)
            throws MalformedStreamException {
        int n = 0;
        for (int j = 0; j < 3; j++) {
            int f = last[mesh.vertex(face, j)];
            if (f >= 0) near[n++] = f;
        }
        int first = -1;
        int votes = 0;
        for (int i = 0; i < n; i++) {
            int count = 0;
            for (int k = 0; k < n; k++) if (isSame(values, near[i], values, near[k])) count++;
            if (count <= votes) continue;
            votes = count;
            first = near[i];
        }
        if (first >= 0) {
            if (coder.bit(same, votes, isSame(values, first, given, face) ? 1 : 0) != 0) {
                System.arraycopy(values, words * first, values, words * face, words);
                return;
            }
            for (int i = 0; i < n; i++) {
                if (isSame(values, near[i], values, first)) continue;
                if (coder.bit(other, 0, isSame(values, near[i], given, face) ? 1 : 0) == 0) break;
                System.arraycopy(values, words * near[i], values, words * face, words);
                return;
            }
        }
        for (int w = words * face; w < words * face + words; w++) values[w] = codeWord(kind, labels, given[w]);
    }

    private boolean isFinite(Channel.Type type, int face) {
        int exponent = type == Channel.Type.FLOAT64 ? 0x7ff00000 : 0x7f800000;
        for (int w = words * face + type.words() - 1; w < words * (face + 1); w += type.words())
            if ((values[w] & exponent) == exponent) return false;
        return true;
    }

    private boolean isSame(int[] a, int f, int[] b, int g) {
        for (int w = 0; w < words; w++) if (a[words * f + w] != b[words * g + w]) return false;
        return true;
    }

    private int codeWord(FaceChannel kind, List<String> labels, int value) throws MalformedStreamException {
        if (!labels.isEmpty()) return coder.uniform(value, labels.size());
        switch (kind.type()) {
            case FLOAT32, FLOAT64:
                return coder.raw(value, 32);
            case INT32, UINT32:
                if (coder.bit(small, 0, value >= 0 && value < SMALL ? 1 : 0) != 0)
                    return numbers.unsigned(coder, 1, value);
                return coder.raw(value, 32);
            default:
                before = RawNumbers.whole(before + (double) numbers.signed(coder, 1, value - before), kind.type());
                return before;
        }
    }
}
