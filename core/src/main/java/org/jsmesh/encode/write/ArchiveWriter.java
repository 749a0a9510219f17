package org.jsmesh.encode.write;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.BatchKind;
import org.jsmesh.archive.Provenance;
import org.jsmesh.archive.coding.SplitPayload;
import org.jsmesh.codec.MeshCoder;
import org.jsmesh.codec.MeshFormat;
import org.jsmesh.codec.connectivity.CodedMesh;
import org.jsmesh.codec.connectivity.PairRunner;
import org.jsmesh.codec.exact.NumberForms;
import org.jsmesh.encode.measure.LevelMeter;
import org.jsmesh.encode.measure.SurfaceFit;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.patch.PatchLog;

/**
 * Writes the archive of a simplified mesh: base, then the passes of its log from the last to the first, cut into
 * batches, textures among them.
 */
public final class ArchiveWriter {
    /** Bytes that a split hardly ever exceeds. Batches above their cap do no harm, but are less even. */
    static final int LARGEST_SPLIT = 24;

    /** Splits that are coded together, so that the coder stays with connectivity or positions for a while. */
    private static final int PORTION = 64;

    /**
     * Splits that are coded at a time where the batch has much room left, so that two threads can share them. A
     * multiple of {@link #PORTION}.
     */
    private static final int MOST_AT_ONCE = 128 * PORTION;

    /**
     * Effect on the picture of a shape that is off by 1% of the diagonal on average, in % of white. Measured values go
     * from 3 to 80.
     */
    private static final double SHAPE_GAIN = 30;

    /** Bits that moving a vertex costs more than refining its position to the same precision. */
    private static final int MOVING_BITS = 5;

    private final CodedMesh source;
    private final MeshCoder coder;
    private final MeshFormat format;
    private final BatchList batches;
    private final SweepBatches sweeps;
    private final ErrorMeasurements errors;
    private final PrecisionSchedule precision;
    private final List<SharedImage> images;
    private TextureBatches textures;
    private CoarseFit fit; // until it is undone, or null
    private SplitPayload open; // the batch of splits that is being filled, or null
    private int widest; // bytes of its longest split
    private boolean keepsLevels;
    private final OriginalBatches last;
    private final List<ArchiveHeader.Level> levels = new ArrayList<>(); // coarsest first

    public ArchiveWriter(CodedMesh source, LevelMeter meter) {
        this(source, MeshFormat.of(source), meter);
    }

    /** @param format as {@link MeshFormat#of} gives it */
    public ArchiveWriter(CodedMesh source, MeshFormat format, LevelMeter meter) {
        this.source = source;
        this.format = format.withComponents(source.log().components() > 0);
        coder = MeshCoder.encoder(this.format, source);
        precision = new PrecisionSchedule(this.format, source.original().bounds());
        batches = new BatchList(coder, precision);
        last = new OriginalBatches(coder, batches, source.original());
        sweeps = new SweepBatches(coder, batches);
        errors = new ErrorMeasurements(source.original(), coder, meter, precision, batches.rows);
        images = SharedImage.of(source.original().textures());
        place(images.stream().map(image -> TexturePlan.imageAlone(0)).toList());
    }

    /**
     * Sets what the images do for the picture, in the order of the source's textures, those with equal bytes as one.
     * Without it they come behind all splits.
     */
    public void place(List<TexturePlan> plans) {
        textures = new TextureBatches(images, plans, batches);
    }

    /** Runs two halves of the coding side by side. The bytes are the same. */
    public void useHelper(PairRunner helper) {
        coder.useHelper(helper);
    }

    /** Makes the archive hold the mesh that the source was before its numbers became what the codec knows. */
    public void keepExact(Mesh original, NumberForms numbers) {
        last.keepExact(original, numbers);
    }

    /** Sets what the header says of the file that the mesh came from, and the axis that points up. */
    public void tell(Provenance from, UpAxis up) {
        last.tell(from, up);
    }

    /** Makes the archive hold a picture of the model, a JPEG file; an empty one is none. */
    public void show(byte[] poster) {
        last.show(poster);
    }

    /** Makes the archive hold the order of a mesh; the source is its cleaned form. */
    public void keepOrder(Mesh mesh) {
        last.keepOrder(mesh);
    }

    /**
     * Makes the archive show the mesh of a level at the end of that level, as in Chen and Nishita 2002: every level
     * ends with a batch, and positions are exact from the start.
     */
    public void keepLevels() {
        keepsLevels = true;
    }

    /**
     * Moves the vertices of coarse levels to where their surfaces are closest to the original.
     *
     * @param effort the greatest also shows positions more finely; none moves nothing and measures errors seldom
     */
    public void fitCoarse(SurfaceFit fitter, CoarseFit.Effort effort) {
        fit = new CoarseFit(fitter, precision, effort);
        if (effort == CoarseFit.Effort.NONE) errors.measureSeldom();
        if (effort == CoarseFit.Effort.MUCH) precision.showFinely();
    }

    /** Hears after every pass how many of all patches are coded. */
    public interface PassListener {
        void coded(int patches, int of);
    }

    /** @return the file in parts; images among them are those that were given */
    public List<ByteBuffer> write(String meshSha256, PassListener listener) {
        try {
            last.begin();
            codeBase();
            PatchLog log = source.log();
            source.isCodedFrom(log.size());
            int pass = 0;
            int previousLevel = Integer.MAX_VALUE;
            for (int p = log.passes() - 1; p >= 0; p--) {
                if (log.steps(p) == 0) continue;
                if (log.passLevel(p) < previousLevel) {
                    if (keepsLevels && pass > 0) closeLevel();
                    levels.add(new ArchiveHeader.Level(log.threshold(log.passLevel(p)), 0, 0));
                }
                previousLevel = log.passLevel(p);
                codePass(p, ++pass, levels.size());
                source.isCodedFrom(log.passStart(p));
                int left = log.passStart(p) + log.componentStart(p);
                listener.coded(log.size() + log.components() - left, log.size() + log.components());
            }
            closeBatch();
            if (pass > 0 && coder.sweeps().precision() > 0) errors.measure(true);
            int exact = batches.size() - 1;
            textures.putWorth(0);
            for (int shift : precision.last(coder.sweeps().precision())) {
                // Nobody sees the last bits of positions, unlike those of colours.
                if (shift == 0) {
                    errors.measure(false);
                    sweeps.codeAttributes();
                }
                sweep(shift);
                exact = batches.size() - 1;
            }
            sweeps.codeAttributes();
            textures.putAll();
            last.put();
            errors.finish(exact);
            return last.archive(format, levels, meshSha256);
        } catch (MalformedStreamException e) {
            throw new IllegalStateException(e); // the encoder's own values are in range
        }
    }

    private void codeBase() throws MalformedStreamException {
        boolean alone = source.log().size() + source.log().components() == 0;
        double exactly = alone ? 0 : errors.ofBase(BaseSurface.of(source));
        coder.sweeps().setPrecision(alone ? 0 : precision.of(exactly, keepsLevels ? 0 : precision.coarsest()));
        if (fit != null && (coder.sweeps().precision() == 0 || !fit.find(source, format))) fit = null;
        if (fit != null) {
            coder.sweeps().move(fit.moves());
            coder.sweeps().setPrecision(fit.shift(coder.sweeps().precision()));
        }
        SplitPayload payload = new SplitPayload(coder.hasAttributes());
        coder.codeBase(payload.streams(), 0, 0);
        batches.add(BatchKind.BASE, payload.finish(), 0);
        if (!alone) errors.batchEnded();
        if (!alone) putTextures();
    }

    /** Brings all vertices to a precision, in batches of their own. */
    private void sweep(int shift) throws MalformedStreamException {
        errors.measure(false);
        sweeps.codePositions(shift, errors::moved);
        if (shift > 0) errors.moved();
    }

    private void codePass(int logPass, int pass, int level) throws MalformedStreamException {
        PatchLog log = source.log();
        int total = log.steps(logPass);
        boolean moves = fit != null && logPass <= fit.lastPass();
        if (moves && !fit.next()) fit = null;
        int before = coder.sweeps().precision();
        int shift = precision.of(errors.expected(coder.vertices() + log.vertices(logPass)), before);
        if (fit != null) shift = Math.min(before, fit.shift(shift));
        if (fit != null && shift == 0) {
            fit = null;
            moves = true;
        }
        if (moves) {
            // More bits come cheaply with a move into another unit, while they are bits that are seen.
            if (format.hasMirror() && !precision.isFinest(before)) shift = Math.min(shift, before - 1);
            coder.sweeps().move(fit == null ? null : fit.moves());
        }
        boolean sweeps = shift < before || moves && coder.sweeps().movesAny();
        int sweepBits = 3 * (before - shift) + (moves ? MOVING_BITS : 0);
        long sweepBytes = (long) sweepBits * coder.vertices() / 8;
        int left = batches.cap() - (open == null ? 0 : open.estimatedBytes());
        if (sweeps && sweepBytes + LARGEST_SPLIT > left) {
            closeBatch();
            if (sweepBytes > batches.cap() / 2) {
                sweep(shift);
                sweeps = false;
            }
        }
        if (open == null) openBatch();
        batches.enter(level, pass);
        open.beginPass(coder.sweeps().precision() - shift);
        coder.sweeps().codeBeforePass(open.streams().geometry(), coder.sweeps().precision() - shift, sweeps);
        if (moves) errors.expectChange();
        coder.beginPass(logPass);
        int done = 0;
        while (done < total) {
            int room = batches.cap() - open.estimatedBytes();
            if (room <= widest) {
                closeBatch();
                openBatch();
                room = batches.cap() - open.estimatedBytes();
            }
            int portion = Math.min(total - done, portion(room));
            int start = open.estimatedBytes();
            coder.codeSplits(open.streams(), portion);
            open.countSplits(portion);
            widest = Math.max(widest, (open.estimatedBytes() - start) / portion);
            done += portion;
        }
    }

    /**
     * Splits to code before looking again how full the batch is. Far from the end of the batch, a portion less or more
     * makes no difference.
     */
    private int portion(int room) {
        int small = Math.max(1, Math.min(PORTION, room / (2 * widest)));
        if (small < PORTION || open.splits() < 2 * PORTION) return small;
        long halfway = (room / 2 - 2 * PORTION * widest) * (long) open.splits() / open.estimatedBytes();
        return Math.max(PORTION, (int) Math.min(MOST_AT_ONCE, halfway) & -PORTION);
    }

    private void openBatch() {
        open = new SplitPayload(coder.hasAttributes());
        widest = LARGEST_SPLIT;
    }

    private void closeBatch() {
        if (open == null) return;
        int splits = open.splits();
        batches.add(BatchKind.SPLITS, open.finish(), splits);
        open = null;
        errors.batchEnded();
        putTextures();
    }

    private void closeLevel() {
        closeBatch();
        errors.measure(false);
    }

    /**
     * Puts the textures that now do more for the picture than as many bytes of shape. The effect of a coarse shape on
     * the picture falls with the root of the bytes, its distance with the bytes.
     */
    private void putTextures() {
        try {
            double shape = SHAPE_GAIN * Math.sqrt(errors.shown());
            textures.putWorth(shape / (2.0 * (batches.bytes() - textures.bytes())));
        } catch (MalformedStreamException e) {
            throw new IllegalStateException(e);
        }
    }
}
