package org.jsmesh.codec.exact;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.IntegerModel;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.Sizes;

/**
 * How the numbers of an original that are neither float32 nor 8 bits become those that the codec knows, and back:
 * positions in double precision, and channels of other types. Part of the opening of the archive where there are such
 * numbers.
 */
public final class NumberForms {
    private static final Channel.Type[] TYPES = Channel.Type.values();
    private final ExactForm positions; // null where they are float32
    private final List<Channel.Type> types; // of the original's channels
    private final List<Channel.Semantic> semantics;
    private final List<ExactForm> channels; // null where values are coded as they are

    private NumberForms(
            ExactForm positions, List<Channel.Type> types, List<Channel.Semantic> semantics, List<ExactForm> channels) {
        this.positions = positions;
        this.types = types;
        this.semantics = semantics;
        this.channels = channels;
    }

    /** The forms of a mesh that has nothing but float32 and 8 bits. */
    public static NumberForms plain(List<Channel> channels) {
        List<ExactForm> none = new ArrayList<>();
        for (int i = 0; i < channels.size(); i++) none.add(null);
        return new NumberForms(null, types(channels), semantics(channels), none);
    }

    /** The forms that suit a mesh. */
    public static NumberForms of(Mesh mesh) {
        ExactForm positions = null;
        if (mesh.isDouble()) {
            double[] numbers = mesh.exactPositions();
            positions = ExactFormDetector.detect(numbers, 3, mesh.origin());
        }
        List<ExactForm> forms = new ArrayList<>();
        for (Channel c : mesh.channels()) forms.add(isCoded(c.type()) ? null : form(c));
        return new NumberForms(positions, types(mesh.channels()), semantics(mesh.channels()), forms);
    }

    private static List<Channel.Type> types(List<Channel> channels) {
        List<Channel.Type> list = new ArrayList<>(); // streams would double the class library of the page's decoder
        for (Channel c : channels) list.add(c.type());
        return list;
    }

    private static List<Channel.Semantic> semantics(List<Channel> channels) {
        List<Channel.Semantic> list = new ArrayList<>();
        for (Channel c : channels) list.add(c.semantic());
        return list;
    }

    private static boolean isCoded(Channel.Type type) {
        return type == Channel.Type.FLOAT32 || type == Channel.Type.UINT8;
    }

    private static boolean isShort(Channel.Type type) {
        return type == Channel.Type.INT8 || type == Channel.Type.INT16 || type == Channel.Type.UINT16;
    }

    private static ExactForm form(Channel c) {
        if (isShort(c.type())) return ExactForm.whole(c.components());
        double[] numbers = new double[c.wedges() * c.components()];
        for (int i = 0; i < numbers.length; i++) {
            int wedge = i / c.components();
            numbers[i] = c.isAbsent(wedge) ? Double.NaN : c.exact(wedge, i % c.components());
        }
        return ExactFormDetector.detect(numbers, c.components(), null);
    }

    /** Does a decoded mesh need nothing but what the codec knows? */
    public boolean isPlain() {
        if (positions != null) return false;
        for (ExactForm form : channels) if (form != null) return false;
        return true;
    }

    /** Is there more to code than the codec does? */
    public boolean hasRemainder() {
        if (positions != null && !positions.isWhole) return true;
        for (ExactForm form : channels) if (form != null && !form.isWhole) return true;
        return false;
    }

    /** What the positions shown count from. */
    public double[] origin() {
        return positions == null ? new double[3] : positions.originsAsNumbers();
    }

    ExactForm positions() {
        return positions;
    }

    /** Null where the values are coded as they are. */
    ExactForm channel(int index) {
        return channels.get(index);
    }

    /** The mesh that the codec gets for an original. */
    public Mesh coded(Mesh original) {
        if (isPlain()) return original;
        MeshBuilder builder = MeshBuilder.from(original);
        if (positions != null) {
            float[] offsets = new float[3 * original.vertices()];
            for (int i = 0; i < offsets.length; i++)
                offsets[i] = positions.offset(i % 3, original.coordinate(i / 3, i % 3));
            builder.positions(offsets);
        }
        List<Channel> coded = new ArrayList<>();
        for (int i = 0; i < channels.size(); i++) {
            Channel c = original.channels().get(i);
            coded.add(channels.get(i) == null ? c : coded(channels.get(i), c));
        }
        return builder.channels(coded).build();
    }

    private static Channel coded(ExactForm form, Channel c) {
        int n = c.components();
        int[] values = new int[Sizes.of(n, c.wedges(), "corners with " + c.name())];
        BitSet absent = new BitSet();
        for (int w = 0; w < c.wedges(); w++) {
            if (c.isAbsent(w)) absent.set(w);
            else for (int k = 0; k < n; k++) values[n * w + k] = Float.floatToRawIntBits(form.offset(k, c.exact(w, k)));
        }
        return new Channel(codedSemantic(c), c.name(), n, Channel.Type.FLOAT32, values, absent);
    }

    /** Normals of whole numbers are no unit vectors, which the codec would expect. */
    private static Channel.Semantic codedSemantic(Channel c) {
        boolean isNormal = c.semantic() == Channel.Semantic.NORMAL && !c.type().isFloat();
        return isNormal ? Channel.Semantic.CUSTOM : c.semantic();
    }

    /** The channels of the original, without values, for those that the codec knows. */
    public List<Channel> originals(List<Channel> coded) {
        List<Channel> list = new ArrayList<>();
        for (int i = 0; i < coded.size(); i++) list.add(original(coded.get(i), i, new int[0], null));
        return list;
    }

    Channel original(Channel coded, int index, int[] values, BitSet absent) {
        return new Channel(semantics.get(index), coded.name(), coded.components(), types.get(index), values, absent);
    }

    /**
     * The mesh to show for one that the codec gives before the last bits have come.
     *
     * @param coded as the codec gives it
     */
    public Mesh shown(Mesh coded) {
        if (isPlain()) return coded;
        List<Channel> list = new ArrayList<>();
        for (int i = 0; i < channels.size(); i++) {
            Channel c = coded.channels().get(i);
            list.add(channels.get(i) == null ? c : shown(c, i));
        }
        return MeshBuilder.from(coded)
                .offsets(origin(), coded.positions(), null)
                .channels(list)
                .build();
    }

    /**
     * A channel of one wedge to show.
     *
     * @param coded as the codec knows it, with one wedge
     * @param index of the channel
     */
    public Channel shownWedge(Channel coded, int index) {
        if (channels.get(index) == null) return coded;
        return original(coded, index, new int[types.get(index).words() * coded.components()], null);
    }

    /** Gives the channel to show the values that its wedge has in the codec. */
    public void show(Channel coded, Channel shown, int index) {
        if (channels.get(index) == null) return;
        for (int k = 0; k < coded.components(); k++)
            RawNumbers.put(
                    shown.values(), k, types.get(index), channels.get(index).number(k, coded.number(0, k)));
    }

    private Channel shown(Channel coded, int index) {
        int n = coded.components();
        Channel.Type type = types.get(index);
        int[] values = new int[Sizes.of(n * type.words(), coded.wedges(), "corners with " + coded.name())];
        BitSet absent = new BitSet();
        for (int w = 0; w < coded.wedges(); w++) {
            if (coded.isAbsent(w)) absent.set(w);
            else
                for (int k = 0; k < n; k++)
                    RawNumbers.put(values, n * w + k, type, channels.get(index).number(k, coded.number(w, k)));
        }
        return original(coded, index, values, absent);
    }

    /**
     * Codes the forms in either direction.
     *
     * @param coded the channels that the codec knows
     */
    public static NumberForms code(BinaryCoder coder, NumberForms forms, List<Channel> coded)
            throws MalformedStreamException {
        IntegerModel model = new IntegerModel(1);
        boolean write = coder.isEncoder();
        ExactForm positions = null;
        if (coder.raw(write && forms.positions != null ? 1 : 0, 1) != 0)
            positions = ExactForm.code(coder, model, write ? forms.positions : null, 3);
        List<Channel.Type> types = new ArrayList<>();
        List<Channel.Semantic> semantics = new ArrayList<>();
        List<ExactForm> channels = new ArrayList<>();
        for (int i = 0; i < coded.size(); i++) {
            Channel c = coded.get(i);
            Channel.Type type = TYPES[coder.raw(write ? forms.types.get(i).ordinal() : 0, 3)];
            boolean isNormal = write && forms.semantics.get(i) != c.semantic();
            boolean isOther = !isCoded(type);
            if (c.type() != (isOther ? Channel.Type.FLOAT32 : type))
                throw new MalformedStreamException(-1, "channel " + c.name() + " is coded as another type");
            types.add(type);
            if (isOther && coder.raw(isNormal ? 1 : 0, 1) != 0) semantics.add(Channel.Semantic.NORMAL);
            else semantics.add(c.semantic());
            ExactForm form = write ? forms.channels.get(i) : null;
            channels.add(isOther ? ExactForm.code(coder, model, form, c.components()) : null);
        }
        return new NumberForms(positions, types, semantics, channels);
    }
}
