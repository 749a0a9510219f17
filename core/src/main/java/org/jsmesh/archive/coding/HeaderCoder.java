package org.jsmesh.archive.coding;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.ArchiveHeader.Level;
import org.jsmesh.archive.ArchiveOpening;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.ChannelInfo;
import org.jsmesh.archive.FaceChannelInfo;
import org.jsmesh.archive.ImageInfo;
import org.jsmesh.archive.PlainText;
import org.jsmesh.archive.Provenance;
import org.jsmesh.codec.MeshFormat;
import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.IntegerModel;
import org.jsmesh.codec.exact.NumberForms;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.UpAxis;

/**
 * Codes header and index in both directions, in two parts. The opening has what a decoder needs to show the first
 * batches. The rest is a batch of its own and has totals, identity, exact bounds, levels, hashes of images, the
 * provenance with its notes, and the index of all other batches.
 */
public final class HeaderCoder {
    private static final int MANTISSA = 0x7fffff;
    private static final int HASH_DIGITS = 64;
    private static final int MAX_FACE_CHANNELS = 64;
    private static final int MAX_PATHS = 1 << 12; // of all images
    private final boolean write;
    private final ArchiveHeader source;
    private final HeaderFields fields = new HeaderFields();
    private final IntegerModel restBytesCount = new IntegerModel(1);
    private BinaryCoder coder;
    private BinaryCoder openingStream;
    private IndexCoder index;
    private MeshFormat format;
    private int features;
    private NumberForms forms;
    private ArchiveOpening opening;

    /**
     * @param source what to write, with an index that has no batch of kind HEADER; null to read
     * @param format of the mesh to write; null to read
     * @param forms of the numbers to write; null to read
     * @param features of the archive, as in {@link ArchiveLayout}; those of the first byte to read
     */
    public HeaderCoder(ArchiveHeader source, MeshFormat format, NumberForms forms, int features) {
        this.source = source;
        this.format = format;
        this.forms = forms;
        this.features = features;
        write = source != null;
    }

    public MeshFormat format() {
        return format;
    }

    /** How the original's numbers became those of the format. */
    public NumberForms forms() {
        return forms;
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
        fields.on(stream);
        openingStream = stream;
        if ((features & ArchiveLayout.FURTHER) != 0) codeFurtherFeatures();
        boolean hasComponents = (features & ArchiveLayout.COMPONENTS) != 0;
        format = MeshFormat.code(coder, fields.texts, format, hasComponents);
        if (hasRemainder()) forms = NumberForms.code(coder, forms, format.channels());
        else forms = NumberForms.plain(format.channels());
        List<ChannelInfo> channels = new ArrayList<>();
        for (Channel c : forms.originals(format.channels()))
            channels.add(new ChannelInfo(c.semantic(), c.name(), c.components(), c.type()));
        List<Material> materials = new MaterialCoder(fields, write).code(write ? source.materials() : null);
        List<ImageInfo> images = codeImages(write ? source.images() : null);
        index = new IndexCoder(
                write ? source.batches() : null, format.extentBits(), format.hasStitches(), hasComponents);
        index.codeBase(coder, headBytes);
        index.codeRows(coder, batches);
        UpAxis up = ArchiveLayout.up(features);
        opening = new ArchiveOpening(
                channels,
                materials,
                images,
                forms.origin(),
                format.coarseBounds(),
                up,
                (features & ArchiveLayout.CLOSED) != 0,
                index.build());
    }

    private void codeFurtherFeatures() throws MalformedStreamException {
        int first = ArchiveLayout.FIRST_FURTHER;
        int further = new IntegerModel(1).unsigned(coder, features >> first);
        ArchivePrefix.checkFeatures(further & ~(ArchiveLayout.KNOWN_FEATURES >> first), first);
        features |= further << first;
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
                opening.channels(),
                opening.materials(),
                opening.images(),
                opening.origin(),
                opening.box(),
                opening.up(),
                opening.isClosed(),
                index.build());
    }

    private boolean hasRemainder() {
        return (features & ArchiveLayout.REMAINDER) != 0;
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
        fields.on(stream);
        int vertices = fields.count(write ? source.vertices() : 0, Integer.MAX_VALUE / 8);
        int faces = 2 * vertices - fields.counts.signed(coder, 0, write ? 2 * source.vertices() - source.faces() : 0);
        int wedges = vertices + fields.count(write ? source.wedges() - source.vertices() : 0, Integer.MAX_VALUE / 8);
        String sha256 = hash(write ? source.meshSha256() : null);
        float[] bounds = new float[6];
        for (int i = 0; i < bounds.length; i++) bounds[i] = fields.number(write ? source.bounds()[i] : 0);
        int levelCount = fields.count(write ? source.levels().size() : 0, 1 << 16);
        float[] thresholds = new float[levelCount];
        int last = Float.floatToRawIntBits(1f);
        for (int i = 0; i < levelCount; i++) {
            double level = write ? source.levels().get(i).threshold() : 0;
            last = threshold(Float.floatToRawIntBits((float) level), last);
            thresholds[i] = Float.intBitsToFloat(last);
        }
        List<FaceChannelInfo> faceChannels =
                hasRemainder() ? codeFaceChannels(write ? source.faceChannels() : null) : List.of();
        List<ImageInfo> images = codeHashes(opening.images());
        Provenance provenance = codeProvenance(write ? source.provenance() : null);
        index.codeRows(coder, batches);
        if ((features & ArchiveLayout.QUANTILES) != 0) index.codeQuantiles(coder);
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
                images,
                faceChannels,
                opening.origin(),
                bounds,
                opening.up(),
                opening.isClosed(),
                levels(thresholds, all),
                sha256,
                provenance,
                all);
    }

    /** Codes a threshold as the bits of a float. From level to level, thresholds mostly differ by a power of two. */
    private int threshold(int bits, int last) throws MalformedStreamException {
        boolean power = (bits & MANTISSA) == (last & MANTISSA) && bits > 0;
        if (coder.raw(power ? 1 : 0, 1) == 0) return Float.floatToRawIntBits(fields.number(Float.intBitsToFloat(bits)));
        int exponent = (last >>> 23) + fields.counts.signed(coder, 0, (bits >>> 23) - (last >>> 23));
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

    private List<ImageInfo> codeImages(List<ImageInfo> list) throws MalformedStreamException {
        int n = fields.count(write ? list.size() : 0, MAX_PATHS);
        List<ImageInfo> images = new ArrayList<>();
        int left = MAX_PATHS;
        for (int i = 0; i < n; i++) {
            int names = 1 + fields.count(write ? list.get(i).paths().size() - 1 : 0, left - 1);
            left -= names;
            List<String> paths = new ArrayList<>();
            for (int p = 0; p < names; p++) {
                fields.checkEnd();
                paths.add(fields.text(write ? list.get(i).paths().get(p) : null));
            }
            images.add(new ImageInfo(paths, fields.count(write ? list.get(i).bytes() : 0, Integer.MAX_VALUE)));
        }
        return images;
    }

    private List<FaceChannelInfo> codeFaceChannels(List<FaceChannelInfo> list) throws MalformedStreamException {
        int n = fields.count(write ? list.size() : 0, MAX_FACE_CHANNELS);
        List<FaceChannelInfo> channels = new ArrayList<>();
        for (int i = 0; i < n; i++) {
            FaceChannelInfo c = write ? list.get(i) : null;
            String name = fields.text(write ? c.name() : null);
            int components = coder.raw(write ? c.components() - 1 : 0, 2) + 1;
            Channel.Type type = Channel.Type.values()[coder.raw(write ? c.type().ordinal() : 0, 3)];
            channels.add(new FaceChannelInfo(name, components, type));
        }
        return channels;
    }

    /** Codes what the opening does not say of the images. */
    private List<ImageInfo> codeHashes(List<ImageInfo> known) throws MalformedStreamException {
        List<ImageInfo> images = new ArrayList<>();
        for (int i = 0; i < known.size(); i++) {
            fields.checkEnd();
            String sha256 = hash(write ? source.images().get(i).sha256() : null);
            images.add(new ImageInfo(known.get(i).paths(), known.get(i).bytes(), sha256));
        }
        return images;
    }

    private Provenance codeProvenance(Provenance p) throws MalformedStreamException {
        String name = PlainText.fit(fields.text(write ? p.format() : null), Provenance.MOST_EXAMPLE);
        return new Provenance(name, new NoteCoder(write).code(coder, write ? p.notes() : null));
    }

    private String hash(String value) throws MalformedStreamException {
        StringBuilder digits = new StringBuilder();
        for (int i = 0; i < HASH_DIGITS; i++)
            digits.append(Character.forDigit(coder.raw(write ? Character.digit(value.charAt(i), 16) : 0, 4), 16));
        return digits.toString();
    }
}
