package org.jsmesh.codec;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.codec.attribute.ChannelDetector;
import org.jsmesh.codec.attribute.ChannelFormat;
import org.jsmesh.codec.attribute.NormalFormula;
import org.jsmesh.codec.connectivity.CodedMesh;
import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.IntegerModel;
import org.jsmesh.codec.entropy.TextModel;
import org.jsmesh.codec.lattice.CoarseBox;
import org.jsmesh.codec.lattice.Lattice;
import org.jsmesh.codec.lattice.LatticeDetector;
import org.jsmesh.codec.lattice.RadixPowers;
import org.jsmesh.codec.lattice.ScaleDetector;
import org.jsmesh.codec.lattice.Translation;
import org.jsmesh.codec.lattice.TranslationDetector;
import org.jsmesh.codec.position.Mirror;
import org.jsmesh.codec.position.MirrorDetector;
import org.jsmesh.codec.position.MirroredMoves;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;

/**
 * What a decoder must know before the base: lattice, translation and mirror of the positions, channels, the number of
 * materials, whether there are stitches, later components and dense predictors, and a coarse box. Part of the opening
 * of the archive.
 */
public final class MeshFormat {
    private static final int MAX_CHANNELS = 64;

    private static final int MOST_SHIFT = 28;
    final Lattice positions;
    final Translation translation;
    final Mirror mirror;
    final List<ChannelFormat> channels;
    final int materials;
    final boolean hasStitches;
    final boolean hasComponents;
    final boolean isDense;
    final CoarseBox box;

    /** What the coding of splits has: vertices with several fans, components after the base, dense predictors. */
    private record Splits(boolean stitches, boolean components, boolean dense) {}

    private MeshFormat(
            Lattice positions,
            Translation translation,
            Mirror mirror,
            List<ChannelFormat> channels,
            int materials,
            Splits splits,
            CoarseBox box) {
        this.positions = positions;
        this.translation = translation;
        this.mirror = mirror;
        this.channels = channels;
        this.materials = materials;
        hasStitches = splits.stitches;
        hasComponents = splits.components;
        isDense = splits.dense;
        this.box = box;
    }

    /** The format that suits a mesh. */
    public static MeshFormat of(CodedMesh source) {
        return of(
                        source.original(),
                        source.vertexOf().length > source.original().vertices(),
                        0)
                .withComponents(source.log().components() > 0);
    }

    /**
     * The format that suits a mesh; it does not depend on how it is simplified.
     *
     * @param stitched whether vertices have several fans
     * @param previewSide pixels of the longer side of the largest preview of an image, or 0
     */
    public static MeshFormat of(Mesh mesh, boolean stitched, int previewSide) {
        List<ChannelFormat> formats = new ArrayList<>();
        for (Channel c : mesh.channels()) formats.add(ChannelDetector.detect(mesh, c, previewSide));
        int[] bits = positionBits(mesh);
        Lattice lattice = LatticeDetector.detectAround(bits);
        Translation translation = lattice.powers == RadixPowers.TWO ? TranslationDetector.undo(bits) : Translation.NONE;
        if (lattice.powers == RadixPowers.TWO && translation.isNone()) translation = ScaleDetector.undo(bits);
        if (!translation.isNone()) lattice = LatticeDetector.detectAround(bits);
        return new MeshFormat(
                lattice,
                translation,
                MirrorDetector.detect(bits, lattice),
                formats,
                mesh.materials().size(),
                new Splits(stitched, false, true),
                CoarseBox.of(mesh.bounds(), lattice, translation));
    }

    /** The raw bits that are coded for a mesh's positions: those before their translation. */
    private int[] codedBits(Mesh mesh) {
        int[] bits = positionBits(mesh);
        if (translation.isScaled()) ScaleDetector.undo(bits);
        else if (!translation.isNone()) TranslationDetector.undo(bits);
        return bits;
    }

    /** The values that are coded for a mesh's positions: those before their translation. */
    float[] codedPositions(Mesh mesh) {
        if (translation.isNone()) return mesh.positions();
        int[] bits = codedBits(mesh);
        float[] values = new float[bits.length];
        for (int i = 0; i < bits.length; i++) values[i] = Float.intBitsToFloat(bits[i]);
        return values;
    }

    private static int[] positionBits(Mesh mesh) {
        float[] positions = mesh.positions();
        int[] bits = new int[positions.length];
        for (int i = 0; i < bits.length; i++) bits[i] = Float.floatToRawIntBits(positions[i]);
        return bits;
    }

    /** The same format, with or without components that come after the base. */
    public MeshFormat withComponents(boolean later) {
        return with(new Splits(hasStitches, later, isDense));
    }

    /** The same format, with predictors that give the smallest archive, or with those that take less time. */
    public MeshFormat withDense(boolean dense) {
        return with(new Splits(hasStitches, hasComponents, dense));
    }

    private MeshFormat with(Splits splits) {
        return new MeshFormat(positions, translation, mirror, channels, materials, splits, box);
    }

    /** May components come after the base? */
    public boolean hasComponents() {
        return hasComponents;
    }

    /** May vertices have several fans? */
    public boolean hasStitches() {
        return hasStitches;
    }

    /** Bits of the longest side of the bounding box, in cells of the positions' lattice. */
    public int extentBits() {
        return box.extentBits;
    }

    /** A box around the mesh, hardly larger: smallest x, y, z, largest x, y, z. */
    public float[] coarseBounds() {
        return box.bounds(positions, translation);
    }

    /** Makes the moves of a symmetric mesh's vertices symmetric, in cells. */
    public void mirrorMoves(Mesh mesh, int[] moves) {
        if (!mirror.isNone()) MirroredMoves.symmetrize(codedBits(mesh), positions, mirror, moves);
    }

    /** Whether vertices are coded as mirror images of others. */
    public boolean hasMirror() {
        return !mirror.isNone();
    }

    /** Where cell 0 of the positions' lattice begins along an axis. */
    public double offset(int axis) {
        return translation.offset(axis);
    }

    /** Length of the side of a cell of the positions' lattice. */
    public double cellSize() {
        return positions.spacing() * translation.scale();
    }

    /** The channels without values. */
    public List<Channel> channels() {
        List<Channel> list = new ArrayList<>();
        for (ChannelFormat c : channels)
            list.add(new Channel(c.semantic(), c.name(), c.components(), c.type(), new int[0], null));
        return list;
    }

    /**
     * Writes a format, or reads one when the coder is a decoder ({@code format} is then ignored).
     *
     * @param hasComponents may components come after the base?
     */
    public static MeshFormat code(BinaryCoder coder, TextModel texts, MeshFormat format, boolean hasComponents)
            throws MalformedStreamException {
        IntegerModel model = new IntegerModel(1);
        boolean write = coder.isEncoder();
        Lattice positions = codeLattice(coder, model, write ? format.positions : null);
        Translation translation = codeTranslation(coder, write ? format.translation : null);
        Mirror mirror = codeMirror(coder, write ? format.mirror : null, positions);
        int count = model.unsigned(coder, write ? format.channels.size() : 0);
        if (count > MAX_CHANNELS)
            throw new MalformedStreamException(-1, count + " channels, more than " + MAX_CHANNELS);
        List<ChannelFormat> channels = new ArrayList<>();
        for (int i = 0; i < count; i++)
            channels.add(codeChannel(coder, model, texts, write ? format.channels.get(i) : null));
        int materials = model.unsigned(coder, write ? format.materials : 0);
        boolean stitches = coder.raw(write && format.hasStitches ? 1 : 0, 1) != 0;
        boolean dense = coder.raw(write && format.isDense ? 1 : 0, 1) != 0;
        CoarseBox box = CoarseBox.code(coder, write ? format.box : null);
        Splits splits = new Splits(stitches, hasComponents, dense);
        return new MeshFormat(positions, translation, mirror, channels, materials, splits, box);
    }

    private static Translation codeTranslation(BinaryCoder coder, Translation t) throws MalformedStreamException {
        boolean write = coder.isEncoder();
        if (coder.raw(write && !t.isNone() ? 1 : 0, 1) == 0) return Translation.NONE;
        if (coder.raw(write && t.isScaled() ? 1 : 0, 1) != 0) {
            int factor = coder.raw(write ? t.factor : 0, 32);
            if (factor <= 0 || (factor & 0x7f800000) == 0x7f800000)
                throw new MalformedStreamException(-1, "positions are scaled by no positive number");
            return Translation.scaled(factor);
        }
        int[] offsets = new int[3];
        for (int a = 0; a < 3; a++) {
            offsets[a] = coder.raw(write ? t.offsets[a] : 0, 32);
            if ((offsets[a] & 0x7f800000) == 0x7f800000)
                throw new MalformedStreamException(-1, "an offset of the positions is not finite");
        }
        return new Translation(offsets);
    }

    private static Mirror codeMirror(BinaryCoder coder, Mirror m, Lattice lattice) throws MalformedStreamException {
        boolean write = coder.isEncoder();
        if (coder.raw(write && !m.isNone() ? 1 : 0, 1) == 0) return Mirror.NONE;
        int axis = coder.raw(write ? m.axis() : 0, 2);
        int sum = coder.raw(write && m.sum() != 0 ? 1 : 0, 1) == 0 ? 0 : coder.raw(write ? m.sum() : 0, 32);
        Mirror mirror = new Mirror(axis, sum);
        if (axis > 2 || (sum & 0x7f800000) == 0x7f800000 || !mirror.fits(lattice))
            throw new MalformedStreamException(-1, "a mirror that is not there");
        return mirror;
    }

    private static ChannelFormat codeChannel(BinaryCoder coder, IntegerModel model, TextModel texts, ChannelFormat c)
            throws MalformedStreamException {
        boolean write = coder.isEncoder();
        int semantic = coder.raw(write ? c.semantic().ordinal() : 0, 2);
        String name = texts.code(coder, write ? c.name() : null);
        int components = coder.raw(write ? c.components() - 1 : 0, 2) + 1;
        boolean bytes = coder.raw(write && c.lattice() == null ? 1 : 0, 1) != 0;
        boolean absent = coder.raw(write && c.hasAbsent() ? 1 : 0, 1) != 0;
        Lattice lattice = bytes ? null : codeLattice(coder, model, write ? c.lattice() : null);
        Channel.Type type = bytes ? Channel.Type.UINT8 : Channel.Type.FLOAT32;
        Channel.Semantic meaning = Channel.Semantic.values()[semantic];
        int shift = 0;
        NormalFormula normals = null;
        boolean follows = false;
        boolean flips = false;
        if (bytes) {
            follows = coder.raw(write && c.follows() ? 1 : 0, 1) != 0;
            shift = coder.raw(write ? c.shift() : 0, 3);
        } else if (ChannelFormat.areNormals(meaning, components)) {
            normals = NormalFormula.code(coder, write ? c.normals() : null);
        } else {
            shift = model.unsigned(coder, write ? c.shift() : 0);
            flips = components > 1 && coder.raw(write && c.isFlipped() ? 1 : 0, 1) != 0;
        }
        if (shift > MOST_SHIFT) throw new MalformedStreamException(-1, "values in units of 2^" + shift);
        return new ChannelFormat(meaning, name, components, type, lattice, absent, shift, follows, flips, normals);
    }

    private static Lattice codeLattice(BinaryCoder coder, IntegerModel model, Lattice l)
            throws MalformedStreamException {
        boolean write = coder.isEncoder();
        boolean decimal = coder.raw(write && l.powers != RadixPowers.TWO ? 1 : 0, 1) != 0;
        boolean rounded = decimal && coder.raw(write && l.powers == RadixPowers.ROUNDED_TEN ? 1 : 0, 1) != 0;
        int digits = model.unsigned(coder, write ? l.digits : 0);
        int low = model.signed(coder, 0, write ? l.minExponent : 0);
        int grid = model.signed(coder, 0, write ? l.gridExponent : 0);
        boolean exceptions = coder.raw(write && l.hasExceptions ? 1 : 0, 1) != 0;
        int most = decimal ? Lattice.MAX_DECIMAL_DIGITS : Lattice.BINARY_DIGITS;
        boolean exponents = low >= Lattice.MIN_EXPONENT && low <= grid && grid <= Lattice.MAX_EXPONENT;
        if (digits < (decimal ? 1 : most) || digits > most || !exponents) {
            throw new MalformedStreamException(-1, "a lattice of " + digits + " digits from " + low + " to " + grid);
        }
        return new Lattice(
                rounded ? RadixPowers.ROUNDED_TEN : decimal ? RadixPowers.TEN : RadixPowers.TWO,
                digits,
                low,
                grid,
                exceptions);
    }
}
