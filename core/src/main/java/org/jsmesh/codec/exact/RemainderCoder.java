package org.jsmesh.codec.exact;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;

/**
 * Codes what an original has beyond the mesh that the codec gives: the last bits of numbers, then the attributes of
 * faces. It stands in one stream at the end of an archive, in the order of the decoded vertices, wedges and faces.
 */
public final class RemainderCoder {
    private final BinaryCoder coder;
    private final NumberForms forms;
    private final Mesh decoded;
    private final Mesh original; // or null to decode
    private final CodedIds ids; // null likewise

    private RemainderCoder(BinaryCoder coder, NumberForms forms, Mesh decoded, Mesh original, CodedIds ids) {
        this.coder = coder;
        this.forms = forms;
        this.decoded = decoded;
        this.original = original;
        this.ids = ids;
    }

    /**
     * Which elements of the original the decoded ones are.
     *
     * @param vertices of the original, by decoded vertex
     * @param wedges of the original, by decoded wedge
     * @param faces of the original, by decoded face
     */
    public record CodedIds(int[] vertices, int[] wedges, int[] faces) {}

    /** Writes what the decoded mesh lacks. */
    public static void write(BinaryCoder coder, NumberForms forms, Mesh decoded, Mesh original, CodedIds ids) {
        try {
            new RemainderCoder(coder, forms, decoded, original, ids).code(original.faceChannels());
        } catch (MalformedStreamException e) {
            throw new IllegalStateException(e); // what the encoder itself counted is in range
        }
    }

    /**
     * Completes a decoded mesh.
     *
     * @param faceChannels those of the original, without values
     * @return the original
     */
    public static Mesh read(BinaryCoder coder, NumberForms forms, Mesh decoded, List<FaceChannel> faceChannels)
            throws MalformedStreamException {
        return new RemainderCoder(coder, forms, decoded, null, null).code(faceChannels);
    }

    private Mesh code(List<FaceChannel> faceChannels) throws MalformedStreamException {
        MeshBuilder builder = MeshBuilder.from(decoded);
        if (forms.positions() != null) builder.offsets(forms.origin(), decoded.positions(), codePositions());
        List<Channel> channels = new ArrayList<>();
        for (int i = 0; i < decoded.channels().size(); i++)
            channels.add(forms.channel(i) == null ? decoded.channels().get(i) : codeChannel(i));
        List<FaceChannel> ofFaces = new ArrayList<>();
        for (FaceChannel kind : faceChannels)
            ofFaces.add(new FaceChannelCoder(coder, decoded).code(kind, original == null ? null : ordered(kind)));
        return builder.channels(channels).faceChannels(ofFaces).build();
    }

    private double[] codePositions() throws MalformedStreamException {
        ExactCoder column = new ExactCoder(forms.positions());
        double[] exact = new double[3 * decoded.vertices()];
        for (int i = 0; i < exact.length; i++) {
            checkEnd(i);
            double x = original == null ? 0 : original.coordinate(ids.vertices()[i / 3], i % 3);
            exact[i] = column.code(coder, i % 3, decoded.positions()[i], x);
        }
        return exact;
    }

    private Channel codeChannel(int index) throws MalformedStreamException {
        Channel coded = decoded.channels().get(index);
        Channel wanted = original == null ? null : original.channels().get(index);
        Channel kind = forms.original(coded, index, new int[0], null);
        ExactCoder column = new ExactCoder(forms.channel(index));
        int n = coded.components();
        int[] values = new int[kind.words() * coded.wedges()];
        BitSet absent = new BitSet();
        for (int w = 0; w < coded.wedges(); w++) {
            checkEnd(w);
            if (coded.isAbsent(w)) {
                absent.set(w);
                continue;
            }
            for (int k = 0; k < n; k++) {
                double x = wanted == null ? 0 : wanted.exact(ids.wedges()[w], k);
                RawNumbers.put(values, n * w + k, kind.type(), column.code(coder, k, coded.number(w, k), x));
            }
        }
        return kind.withValues(values, absent);
    }

    private FaceChannel ordered(FaceChannel channel) {
        int words = channel.words();
        int[] values = new int[channel.values().length];
        for (int f = 0; f < decoded.faces(); f++)
            System.arraycopy(channel.values(), words * ids.faces()[f], values, words * f, words);
        return channel.withValues(values);
    }

    private void checkEnd(int i) throws MalformedStreamException {
        if ((i & 15) == 0 && coder.isExhausted()) throw new MalformedStreamException(-1, "the last bits end early");
    }
}
