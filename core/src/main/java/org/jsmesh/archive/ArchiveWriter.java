package org.jsmesh.archive;

import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.codec.CodedMesh;
import org.jsmesh.codec.Helper;
import org.jsmesh.codec.MeshCoder;
import org.jsmesh.codec.MeshFormat;
import org.jsmesh.codec.OrderCoder;
import org.jsmesh.codec.RangeEncoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Texture;
import org.jsmesh.patch.PatchLog;

/**
 * Writes the archive of a simplified mesh: base, then the passes of its log from the last to the first, cut into batches, textures among them.
 */
public final class ArchiveWriter {
    /** A split is hardly ever larger, in bytes; a batch that ends up above its cap costs nothing but the promise of even batches. */
    private static final int LARGEST_SPLIT = 24;

    /** Splits that are coded together: enough of them to stay with connectivity or positions for a while. */
    private static final int PORTION = 64;

    /** So many are coded at a time where the batch has much room left, so that two threads can share them. A multiple of {@link #PORTION}. */
    private static final int MOST_AT_ONCE = 128 * PORTION;

    /** The error is measured again when the mesh has grown by this factor; {@link BatchIndexBuilder#spreadError} gives what lies between. */
    private static final double MEASURE_GROWTH = 1.7;

    /** Bytes of batches in front of the rest of the header. */
    private static final int BYTES_BEFORE_REST = 4096;

    /** Bits that moving a vertex costs more than making its position as precise. */
    private static final int MOVING_BITS = 5;

    private final CodedMesh source;
    private final MeshCoder coder;
    private final MeshFormat format;
    private final BatchIndexBuilder rows = new BatchIndexBuilder();
    private final List<byte[]> payloads = new ArrayList<>();
    private final byte[] images;
    private CoarseFit fit; // until it is undone, or null
    private final ErrorMeter meter;
    private final PrecisionSchedule precision;
    private double error; // when it was last measured
    private final ErrorForecast forecast = new ErrorForecast();
    private SplitPayload open; // the batch of splits that is being filled, or null
    private int widest; // bytes of its longest split
    private int passBegun;
    private int levelBegun;
    private int measuredFaces;
    private int firstUnmeasured = 1;
    private boolean keepsLevels;
    private Mesh inOrder; // whose order is kept, or null
    private int imageBytes;
    private int sweptFrom; // precision before the last sweep
    private long bytes; // of all payloads; the header is not known yet
    private final List<ArchiveHeader.Level> levels = new ArrayList<>(); // coarsest first

    /** Measures how far a level of detail is from the original. */
    public interface ErrorMeter {
        /** Mean distance in % of the diagonal of the original's bounding box. */
        double mean(Mesh levelOfDetail);
    }

    /** @param meter is asked for the base, whenever the faces have grown by {@link #MEASURE_GROWTH}, and before the last sweep */
    public ArchiveWriter(CodedMesh source, ErrorMeter meter) {
        this(source, MeshFormat.of(source), meter);
    }

    /** @param format as {@link MeshFormat#of} gives it */
    public ArchiveWriter(CodedMesh source, MeshFormat format, ErrorMeter meter) {
        this.source = source;
        this.meter = meter;
        this.format = format;
        coder = MeshCoder.encoder(format, source);
        precision = new PrecisionSchedule(format, source.original().bounds());
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        for (Texture t : source.original().textures()) all.writeBytes(t.bytes());
        images = all.toByteArray();
    }

    /** Has half of the coding done beside the other. The bytes are the same. */
    public void useHelper(Helper helper) {
        coder.useHelper(helper);
    }

    /** Makes the archive hold the order of a mesh, of which the source is the cleaned form. */
    public void keepOrder(Mesh mesh) {
        inOrder = mesh;
    }

    /**
     * Makes what is shown at the end of a level the mesh of that level: every level ends with a batch, and positions are exact from the start, as in Chen and Nishita 2002.
     */
    public void keepLevels() {
        keepsLevels = true;
    }

    /** Has the coarse levels' vertices moved to where their surfaces are closest to the original. */
    public void fitCoarse(CoarseFit.Fitter fitter) {
        fit = new CoarseFit(fitter);
    }

    /** Hears after every pass how many of how many patches are coded. */
    public interface PassListener {
        void coded(int patches, int of);
    }

    /**
     * @return the file
     */
    public byte[] write(String meshSha256, PassListener listener) {
        try {
            codeBase();
            PatchLog log = source.log();
            source.isCodedFrom(log.size());
            int pass = 0;
            int previousLevel = Integer.MAX_VALUE;
            for (int p = log.passes() - 1; p >= 0; p--) {
                if (log.passStart(p) == log.passStart(p + 1)) continue;
                if (log.passLevel(p) < previousLevel) {
                    if (keepsLevels && pass > 0) closeLevel();
                    levels.add(new ArchiveHeader.Level(log.threshold(log.passLevel(p)), 0, 0));
                }
                previousLevel = log.passLevel(p);
                codePass(p, ++pass, levels.size());
                source.isCodedFrom(log.passStart(p));
                listener.coded(log.size() - log.passStart(p), log.size());
            }
            closeBatch();
            if (pass > 0) spreadMeasured(coder.precision() == 0 ? 0 : Math.min(error, measure()));
            int rest = rows.size();
            while (imageBytes < images.length) putImages();
            rows.spreadError(rest, error, error);
            firstUnmeasured = rows.size();
            for (int shift : precision.last(coder.precision())) {
                codeSweep(shift);
                spreadMeasured(shift == 0 ? 0 : measure());
            }
            codeAttributes();
            if (inOrder != null) putOrder();
            return assemble(meshSha256);
        } catch (MalformedStreamException e) {
            throw new IllegalStateException(e); // the encoder's own values are in range
        }
    }

    private void codeBase() throws MalformedStreamException {
        boolean alone = source.log().size() == 0;
        double exactly = alone ? 0 : meter.mean(BaseMesh.of(source));
        coder.setPrecision(alone ? 0 : precision.of(exactly, keepsLevels ? 0 : precision.coarsest(), fit != null));
        if (coder.precision() == 0 || fit != null && !moveCoarse()) fit = null;
        SplitPayload payload = new SplitPayload(coder.hasAttributes());
        coder.codeBase(payload.streams(), 0, 0);
        byte[] done = payload.finish();
        error = alone ? 0 : measure();
        rows.add(BatchKind.BASE, done.length, 0);
        addRow(done);
    }

    private boolean moveCoarse() throws MalformedStreamException {
        if (!fit.find(source, format, coder.precision())) return false;
        coder.move(fit.moves());
        return true;
    }

    /** Completes the row last added. */
    private void addRow(byte[] payload) {
        int coarsest =
                rows.kindOfLast() == BatchKind.PRECISION && coder.unrefined() > 0 ? sweptFrom : coder.precision();
        rows.after(coder.faces(), coder.vertices(), error)
                .in(levelBegun, passBegun)
                .precise(coder.precision(), precision.bits(coarsest));
        add(payload);
    }

    /** Brings all vertices to a precision. */
    private void codeSweep(int shift) throws MalformedStreamException {
        sweptFrom = coder.precision();
        int bitsPerVertex = 3 * (sweptFrom - shift);
        coder.beginSweep(shift);
        while (coder.unrefined() > 0) {
            int room = IndexCoder.cap(bytes) - ArchiveLayout.CRC_BYTES - 8;
            RangeEncoder stream = new RangeEncoder();
            int count = 0;
            while (coder.unrefined() > 0 && stream.estimatedBytes() + LARGEST_SPLIT < room) {
                int portion = Math.min(coder.unrefined(), Math.max(1, 64 / bitsPerVertex));
                coder.codeSweep(stream, portion);
                count += portion;
            }
            byte[] payload = SplitPayload.finish(stream);
            rows.add(BatchKind.PRECISION, payload.length, count);
            addRow(payload);
        }
    }

    /** Brings the attributes of all wedges that are not exact yet. */
    private void codeAttributes() throws MalformedStreamException {
        while (coder.coarseWedges() > 0) {
            int room = IndexCoder.cap(bytes) - ArchiveLayout.CRC_BYTES - 8;
            RangeEncoder stream = new RangeEncoder();
            int count = 0;
            int widest = LARGEST_SPLIT;
            while (coder.coarseWedges() > 0 && stream.estimatedBytes() + 2 * widest < room) {
                int start = stream.estimatedBytes();
                coder.codeAttributes(stream, 1);
                widest = Math.max(widest, stream.estimatedBytes() - start);
                count++;
            }
            byte[] payload = SplitPayload.finish(stream);
            rows.add(BatchKind.ATTRIBUTES, payload.length, count);
            addRow(payload);
        }
    }

    private void add(byte[] payload) {
        payloads.add(payload);
        bytes += payload.length;
    }

    private void codePass(int logPass, int pass, int level) throws MalformedStreamException {
        PatchLog log = source.log();
        int total = log.passStart(logPass + 1) - log.passStart(logPass);
        boolean moves = fit != null && logPass <= fit.lastPass();
        if (moves && !fit.next()) fit = null;
        int shift = precision.of(forecast.expected(coder.vertices() + total), coder.precision(), fit != null);
        if (fit != null && shift == 0) {
            fit = null;
            moves = true;
        }
        if (moves) {
            shift = Math.min(shift, coder.precision() - 1); // a sweep moves
            coder.move(fit == null ? null : fit.moves());
        }
        int sweepBits = 3 * (coder.precision() - shift) + (moves ? MOVING_BITS : 0);
        int sweepBytes = sweepBits * coder.vertices() / 8;
        int left = IndexCoder.cap(bytes) - (open == null ? 0 : open.estimatedBytes());
        if (shift < coder.precision() && sweepBytes + LARGEST_SPLIT > left) {
            closeBatch();
            if (sweepBytes > IndexCoder.cap(bytes) / 2) codeSweep(shift);
        }
        if (open == null) openBatch(logPass);
        passBegun = pass;
        levelBegun = level;
        open.beginPass(coder.precision() - shift);
        if (shift < coder.precision()) {
            coder.beginSweep(shift);
            coder.codeSweep(open.streams().geometry(), coder.vertices());
        }
        if (moves) measuredFaces = 0; // the error is another one now
        coder.beginPass(logPass);
        int done = 0;
        while (done < total) {
            int room = IndexCoder.cap(bytes) - open.estimatedBytes();
            if (room <= widest) {
                closeBatch();
                openBatch(logPass);
                room = IndexCoder.cap(bytes) - open.estimatedBytes();
            }
            int portion = Math.min(total - done, portion(room));
            int start = open.estimatedBytes();
            coder.codeSplits(open.streams(), portion);
            open.countSplits(portion);
            widest = Math.max(widest, (open.estimatedBytes() - start) / portion);
            done += portion;
        }
    }

    /** Splits to code before looking again how full the batch is. A portion less or more makes no difference far from its end. */
    private int portion(int room) {
        int small = Math.max(1, Math.min(PORTION, room / (2 * widest)));
        if (small < PORTION || open.splits() < 2 * PORTION) return small;
        int halfway = (room / 2 - 2 * PORTION * widest) * open.splits() / open.estimatedBytes();
        return Math.max(PORTION, Math.min(MOST_AT_ONCE, halfway) & -PORTION);
    }

    private void openBatch(int logPass) {
        if (wantsImages(logPass)) putImages();
        open = new SplitPayload(coder.hasAttributes());
        widest = LARGEST_SPLIT;
    }

    private void closeBatch() {
        if (open == null) return;
        byte[] coded = open.finish();
        rows.add(BatchKind.SPLITS, coded.length, open.splits());
        open = null;
        addRow(coded);
        if (coder.faces() >= measuredFaces * MEASURE_GROWTH) spreadMeasured(Math.min(error, measure()));
    }

    private void closeLevel() {
        closeBatch();
        if (coder.faces() > measuredFaces) spreadMeasured(Math.min(error, measure()));
    }

    private double measure() {
        measuredFaces = coder.faces();
        if (!precision.isFinest(coder.precision()))
            forecast.measured(meter.mean(coder.exactly(source.original())), coder.vertices());
        return meter.mean(coder.snapshot(source.original().materials(), List.of()));
    }

    private void spreadMeasured(double after) {
        rows.spreadError(firstUnmeasured, error, after);
        firstUnmeasured = rows.size();
        error = after;
    }

    /** Images follow once a quarter of the faces is there: before that, shape does more for the picture; afterwards both take turns. */
    private boolean wantsImages(int logPass) {
        if (imageBytes == images.length) return false;
        return coder.faces() > source.original().faces() / 4 || logPass == 0;
    }

    private void putImages() {
        imageBytes = putPortion(BatchKind.TEXTURE, images, imageBytes);
    }

    private void putOrder() {
        RangeEncoder stream = new RangeEncoder();
        OrderCoder.write(stream, coder.snapshot(source.original().materials(), List.of()), inOrder);
        byte[] order = stream.finish();
        for (int at = 0; at < order.length; ) at = putPortion(BatchKind.ORDER, order, at);
    }

    /** Adds a batch of verbatim bytes and returns where the next one starts. */
    private int putPortion(BatchKind kind, byte[] all, int from) {
        int size = Math.min(all.length - from, IndexCoder.cap(bytes) - ArchiveLayout.CRC_BYTES);
        byte[] payload = new byte[size + ArchiveLayout.CRC_BYTES];
        System.arraycopy(all, from, payload, 0, size);
        ArchiveLayout.putInt(payload, size, ArchiveLayout.crc(payload, 0, size));
        rows.add(kind, payload.length, 0);
        addRow(payload);
        return from + size;
    }

    private byte[] assemble(String meshSha256) throws MalformedStreamException {
        Mesh mesh = source.original();
        List<ArchiveHeader.TextureInfo> textures = new ArrayList<>();
        for (Texture t : mesh.textures()) textures.add(new ArchiveHeader.TextureInfo(t.path(), t.bytes().length));
        ArchiveHeader header = new ArchiveHeader(
                mesh.faces(),
                mesh.vertices(),
                mesh.wedges(),
                List.of(),
                mesh.materials(),
                textures,
                mesh.bounds(),
                levels,
                meshSha256,
                rows.build());
        int early = 0; // batches, without the base, in front of the rest of the header
        long before = payloads.get(0).length;
        while (early < payloads.size() - 1 && before < BYTES_BEFORE_REST) before += payloads.get(++early).length;
        HeaderCoder coder = new HeaderCoder(header, format);
        RangeEncoder opening = new RangeEncoder();
        coder.codeOpening(opening, 0, early);
        RangeEncoder rest = new RangeEncoder();
        coder.codeRest(rest, payloads.size() - 1 - early);
        byte[] restPayload = SplitPayload.finish(rest);
        coder.codeRestBytes(restPayload.length);
        payloads.add(early + 1, restPayload);
        return file(opening.finish());
    }

    private byte[] file(byte[] opening) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        byte[] prefix = new byte[ArchiveLayout.OPENING_BYTES_AT + ArchiveLayout.varintBytes(opening.length)];
        System.arraycopy(ArchiveLayout.MAGIC, 0, prefix, 0, 3);
        prefix[3] = ArchiveLayout.VERSION;
        prefix[ArchiveLayout.FEATURES_AT] = (byte) (inOrder == null ? 0 : ArchiveLayout.ORDER);
        ArchiveLayout.putVarint(prefix, ArchiveLayout.OPENING_BYTES_AT, opening.length);
        out.writeBytes(prefix);
        out.writeBytes(opening);
        byte[] head = out.toByteArray();
        byte[] crc = new byte[ArchiveLayout.CRC_BYTES];
        ArchiveLayout.putInt(crc, 0, ArchiveLayout.crc(head, 0, head.length));
        out.writeBytes(crc);
        for (byte[] payload : payloads) out.writeBytes(payload);
        return out.toByteArray();
    }
}
