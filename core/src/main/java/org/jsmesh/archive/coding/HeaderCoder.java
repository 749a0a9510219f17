package org.jsmesh.archive.coding;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.ArchiveHeader.Level;
import org.jsmesh.archive.ArchiveOpening;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.ChannelInfo;
import org.jsmesh.archive.TextureInfo;
import org.jsmesh.codec.MeshFormat;
import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.IntegerModel;
import org.jsmesh.codec.entropy.StringCoder;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Material;

/**
 * Codes header and index in both directions, in two parts. The opening has what a decoder needs to show the first
 * batches. The rest is a batch of its own and has totals, identity, exact bounds, levels and the index of all other
 * batches.
 */
public final class HeaderCoder {
    private static final int MAX_LIST = 1 << 20;
    private static final int MANTISSA = 0x7fffff;
    private static final int HASH_DIGITS = 64;
    private final boolean write;
    private final ArchiveHeader source;
    private final IntegerModel counts = new IntegerModel(1);
    private final IntegerModel restBytesCount = new IntegerModel(1);
    private final IntegerModel texts = new IntegerModel(1);
    private BinaryCoder coder;
    private BinaryCoder openingStream;
    private IndexCoder index;
    private MeshFormat format;
    private final boolean hasComponents;
    private ArchiveOpening opening;

    /**
     * @param source what to write, with an index that has no batch of kind HEADER; null to read
     * @param format of the mesh to write; null to read
     * @param hasComponents may components come after the base?
     */
    public HeaderCoder(ArchiveHeader source, MeshFormat format, boolean hasComponents) {
        this.source = source;
        this.format = format;
        this.hasComponents = hasComponents;
        write = source != null;
    }

    public MeshFormat format() {
        return format;
    }

    /**
     * Codes the opening without its last number.
     *
     * @param stream in either direction
     * @param headBytes bytes in front of the base payload: known to the decoder alone
     * @param batches rows of the index in the opening, the base's not counted
     * @throws MalformedStreamException when what is read is no opening
     */
    public void codeOpening(BinaryCoder stream, int headBytes, int batches) throws MalformedStreamException {
        coder = stream;
        openingStream = stream;
        format = MeshFormat.code(coder, format, hasComponents);
        List<ChannelInfo> channels = new ArrayList<>();
        for (Channel c : format.channels())
            channels.add(new ChannelInfo(c.semantic(), c.name(), c.components(), c.type()));
        List<Material> materials = codeMaterials(write ? source.materials() : null);
        List<TextureInfo> textures = codeTextures(write ? source.textures() : null);
        index = new IndexCoder(
                write ? source.batches() : null, format.extentBits(), format.hasStitches(), hasComponents);
        index.codeBase(coder, headBytes);
        index.codeRows(coder, batches);
        opening = new ArchiveOpening(channels, materials, textures, format.coarseBounds(), index.build());
    }

    /**
     * Ends the opening with the bytes of the batch that has the rest.
     *
     * @return the opening, that batch included
     */
    public ArchiveOpening codeRestBytes(int restBytes) throws MalformedStreamException {
        int size = restBytesCount.unsigned(openingStream, restBytes);
        if (size <= ArchiveLayout.CRC_BYTES) throw new MalformedStreamException(-1, "a header of " + size + " bytes");
        index.addHeaderRow(size);
        return new ArchiveOpening(
                opening.channels(), opening.materials(), opening.textures(), opening.box(), index.build());
    }

    /**
     * Codes the rest.
     *
     * @param stream in either direction
     * @param batches rows of the index in the whole archive
     * @return the whole header
     * @throws MalformedStreamException when what is read is no rest of a header
     */
    public ArchiveHeader codeRest(BinaryCoder stream, int batches) throws MalformedStreamException {
        coder = stream;
        int vertices = count(write ? source.vertices() : 0, Integer.MAX_VALUE / 8);
        int faces = 2 * vertices - counts.signed(coder, 0, write ? 2 * source.vertices() - source.faces() : 0);
        int wedges = vertices + count(write ? source.wedges() - source.vertices() : 0, Integer.MAX_VALUE / 8);
        StringBuilder sha = new StringBuilder();
        for (int i = 0; i < HASH_DIGITS; i++)
            sha.append(Character.forDigit(
                    coder.raw(write ? Character.digit(source.meshSha256().charAt(i), 16) : 0, 4), 16));
        float[] bounds = new float[6];
        for (int i = 0; i < bounds.length; i++) bounds[i] = number(write ? source.bounds()[i] : 0);
        int levelCount = count(write ? source.levels().size() : 0, 1 << 16);
        float[] thresholds = new float[levelCount];
        int last = Float.floatToRawIntBits(1f);
        for (int i = 0; i < levelCount; i++) {
            double level = write ? source.levels().get(i).threshold() : 0;
            last = threshold(Float.floatToRawIntBits((float) level), last);
            thresholds[i] = Float.intBitsToFloat(last);
        }
        index.codeRows(coder, batches);
        BatchIndex all = index.build();
        if (!write) {
            index.checkEnd();
            checkTotals(all, faces, vertices, levelCount);
        }
        return new ArchiveHeader(
                faces,
                vertices,
                wedges,
                opening.channels(),
                opening.materials(),
                opening.textures(),
                bounds,
                levels(thresholds, all),
                sha.toString(),
                all);
    }

    /** Codes a threshold as the bits of a float. From level to level, thresholds mostly differ by a power of two. */
    private int threshold(int bits, int last) throws MalformedStreamException {
        boolean power = (bits & MANTISSA) == (last & MANTISSA) && bits > 0;
        if (coder.raw(power ? 1 : 0, 1) == 0) return Float.floatToRawIntBits(number(Float.intBitsToFloat(bits)));
        int exponent = (last >>> 23) + counts.signed(coder, 0, (bits >>> 23) - (last >>> 23));
        if (exponent < 0 || exponent >= 255) throw new MalformedStreamException(-1, "a threshold out of range");
        return exponent << 23 | last & MANTISSA;
    }

    private void checkTotals(BatchIndex batches, int faces, int vertices, int levelCount)
            throws MalformedStreamException {
        int last = batches.size() - 1;
        if (batches.faces(last) != faces || batches.vertices(last) != vertices) {
            throw new MalformedStreamException(-1, "the index ends at " + batches.faces(last) + " faces of " + faces);
        }
        if (batches.level(last) > levelCount)
            throw new MalformedStreamException(-1, "the index has more levels than the header");
    }

    private static List<Level> levels(float[] thresholds, BatchIndex batches) {
        List<Level> levels = new ArrayList<>();
        for (int level = 1; level <= thresholds.length; level++) {
            int at = 0;
            for (int b = 0; b < batches.size(); b++) if (batches.level(b) <= level) at = b;
            levels.add(new Level(thresholds[level - 1], batches.faces(at), batches.errorMean(at)));
        }
        return levels;
    }

    private List<Material> codeMaterials(List<Material> list) throws MalformedStreamException {
        int n = count(write ? list.size() : 0, MAX_LIST);
        List<Material> materials = new ArrayList<>();
        for (int i = 0; i < n; i++) {
            checkEnd();
            Material m = write ? list.get(i) : null;
            String name = text(write ? m.name() : null);
            List<Material.Parameter> parameters = new ArrayList<>();
            int parameterCount = count(write ? m.parameters().size() : 0, 1 << 12);
            for (int p = 0; p < parameterCount; p++)
                parameters.add(codeParameter(write ? m.parameters().get(p) : null));
            List<Material.TextureReference> references = new ArrayList<>();
            int referenceCount = count(write ? m.textures().size() : 0, 1 << 12);
            for (int t = 0; t < referenceCount; t++) {
                String key = text(write ? m.textures().get(t).key() : null);
                references.add(new Material.TextureReference(
                        key, text(write ? m.textures().get(t).path() : null)));
            }
            materials.add(new Material(name, parameters, references));
        }
        return materials;
    }

    private Material.Parameter codeParameter(Material.Parameter p) throws MalformedStreamException {
        String key = text(write ? p.key() : null);
        float[] values = new float[count(write ? p.values().length : 0, 256)];
        for (int v = 0; v < values.length; v++) values[v] = number(write ? p.values()[v] : 0);
        return new Material.Parameter(key, values);
    }

    private List<TextureInfo> codeTextures(List<TextureInfo> list) throws MalformedStreamException {
        int n = count(write ? list.size() : 0, 1 << 12);
        List<TextureInfo> textures = new ArrayList<>();
        for (int i = 0; i < n; i++) {
            checkEnd();
            String path = text(write ? list.get(i).path() : null);
            textures.add(new TextureInfo(path, count(write ? list.get(i).bytes() : 0, Integer.MAX_VALUE)));
        }
        return textures;
    }

    private void checkEnd() throws MalformedStreamException {
        if (coder.isExhausted()) throw new MalformedStreamException(-1, "the header ends early");
    }

    private int count(int value, int most) throws MalformedStreamException {
        int n = counts.unsigned(coder, value);
        if (n < 0 || n > most) throw new MalformedStreamException(-1, "a count of the header is " + n);
        return n;
    }

    private String text(String value) throws MalformedStreamException {
        return StringCoder.code(coder, texts, value);
    }

    private float number(float value) throws MalformedStreamException {
        float x = Float.intBitsToFloat(coder.raw(Float.floatToRawIntBits(value), 32));
        if (Float.isNaN(x) || Float.isInfinite(x))
            throw new MalformedStreamException(-1, "a number of the header is not finite");
        return x;
    }
}
