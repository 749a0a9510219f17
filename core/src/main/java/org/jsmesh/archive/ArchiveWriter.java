package org.jsmesh.archive;

import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.codec.CodedMesh;
import org.jsmesh.codec.MeshCoder;
import org.jsmesh.codec.MeshFormat;
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

    /** The error is measured again when the mesh has grown by this factor, and falls evenly in between. */
    private static final double MEASURE_GROWTH = 1.3;

    private final CodedMesh source;
    private final MeshCoder coder;
    private final MeshFormat format;
    private final BatchIndexBuilder rows = new BatchIndexBuilder();
    private final List<byte[]> payloads = new ArrayList<>();
    private final byte[] images;
    private final ErrorMeter meter;
    private double error; // when it was last measured
    private int measuredFaces;
    private int firstUnmeasured = 1;
    private int imageBytes;
    private long bytes; // of all payloads; the header is not known yet
    private final List<ArchiveHeader.Level> levels = new ArrayList<>(); // coarsest first

    /** Measures how far a level of detail is from the original. */
    public interface ErrorMeter {
        /** Mean distance in % of the diagonal of the original's bounding box. */
        double mean(Mesh levelOfDetail);
    }

    /** @param meter is asked for the mesh after every pass but the last, whose mesh is the original */
    public ArchiveWriter(CodedMesh source, ErrorMeter meter) {
        this.source = source;
        this.meter = meter;
        format = MeshFormat.of(source);
        coder = MeshCoder.encoder(format, source);
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        for (Texture t : source.original().textures()) all.writeBytes(t.bytes());
        images = all.toByteArray();
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
            int pass = 0;
            int previousLevel = Integer.MAX_VALUE;
            for (int p = log.passes() - 1; p >= 0; p--) {
                if (log.passStart(p) == log.passStart(p + 1)) continue;
                if (log.passLevel(p) < previousLevel)
                    levels.add(new ArchiveHeader.Level(log.threshold(log.passLevel(p)), 0, 0));
                previousLevel = log.passLevel(p);
                codePass(p, ++pass);
                listener.coded(log.size() - log.passStart(p), log.size());
            }
            int rest = rows.size();
            while (imageBytes < images.length) putImages(pass);
            rows.spreadError(rest, 0, 0);
            return assemble(meshSha256);
        } catch (MalformedStreamException e) {
            throw new IllegalStateException(e); // the encoder's own values are in range
        }
    }

    private void codeBase() throws MalformedStreamException {
        SplitPayload payload = new SplitPayload(coder.hasAttributes());
        coder.codeBase(payload.streams(), Integer.MAX_VALUE);
        byte[] done = payload.finish();
        error = source.log().size() == 0 ? 0 : measure();
        rows.add(BatchKind.BASE, 0, 0).after(coder.faces(), coder.vertices(), error);
        add(done);
    }

    private void add(byte[] payload) {
        payloads.add(payload);
        bytes += payload.length;
    }

    private double measure() {
        measuredFaces = coder.faces();
        return meter.mean(coder.snapshot(source.original().materials(), List.of()));
    }

    private void codePass(int logPass, int pass) throws MalformedStreamException {
        PatchLog log = source.log();
        coder.beginPass(logPass);
        int total = log.passStart(logPass + 1) - log.passStart(logPass);
        int done = 0;
        while (done < total) {
            if (wantsImages(logPass)) putImages(pass);
            int cap = IndexCoder.cap(bytes);
            SplitPayload payload = new SplitPayload(coder.hasAttributes());
            MeshCoder.Streams streams = payload.streams();
            int patches = 0;
            int widest = 0;
            while (done < total && payload.estimatedBytes() + Math.max(widest, LARGEST_SPLIT) < cap) {
                int start = payload.estimatedBytes();
                coder.codeSplit(streams);
                widest = Math.max(widest, payload.estimatedBytes() - start);
                patches++;
                done++;
            }
            byte[] coded = payload.finish();
            rows.add(BatchKind.SPLITS, coded.length, patches)
                    .after(coder.faces(), coder.vertices(), 0)
                    .in(levels.size(), pass);
            add(coded);
        }
        if (logPass > 0 && coder.faces() < measuredFaces * MEASURE_GROWTH) return;
        double after = logPass == 0 ? 0 : Math.min(error, measure());
        rows.spreadError(firstUnmeasured, error, after);
        firstUnmeasured = rows.size();
        error = after;
    }

    /** Images follow once a quarter of the faces is there: before that, shape does more for the picture; afterwards both take turns. */
    private boolean wantsImages(int logPass) {
        if (imageBytes == images.length) return false;
        return coder.faces() > source.original().faces() / 4 || logPass == 0;
    }

    private void putImages(int pass) {
        int size = Math.min(images.length - imageBytes, IndexCoder.cap(bytes) - ArchiveLayout.CRC_BYTES);
        byte[] payload = new byte[size + ArchiveLayout.CRC_BYTES];
        System.arraycopy(images, imageBytes, payload, 0, size);
        ArchiveLayout.putInt(payload, size, ArchiveLayout.crc(payload, 0, size));
        imageBytes += size;
        rows.add(BatchKind.TEXTURE, payload.length, 0)
                .after(coder.faces(), coder.vertices(), 0)
                .in(levels.size(), pass);
        add(payload);
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
        RangeEncoder encoder = new RangeEncoder();
        new HeaderCoder(encoder).code(header, format, 0, payloads.get(0).length);
        byte[] coded = encoder.finish();
        int headEnd = ArchiveLayout.PREFIX_BYTES + coded.length;
        byte[] file = new byte[Math.toIntExact(headEnd + ArchiveLayout.CRC_BYTES + bytes)];
        System.arraycopy(ArchiveLayout.MAGIC, 0, file, 0, 3);
        file[3] = ArchiveLayout.VERSION;
        ArchiveLayout.putInt(file, 4, coded.length);
        ArchiveLayout.putInt(file, 8, payloads.get(0).length - ArchiveLayout.CRC_BYTES);
        System.arraycopy(coded, 0, file, ArchiveLayout.PREFIX_BYTES, coded.length);
        ArchiveLayout.putInt(file, headEnd, ArchiveLayout.crc(file, 0, headEnd));
        int at = headEnd + ArchiveLayout.CRC_BYTES;
        for (byte[] payload : payloads) {
            System.arraycopy(payload, 0, file, at, payload.length);
            at += payload.length;
        }
        return file;
    }
}
