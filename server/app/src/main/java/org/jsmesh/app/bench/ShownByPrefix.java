package org.jsmesh.app.bench;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.files.ArchiveFile;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.ProgressListener;

/** What the first bytes of an archive show, and how far that is from the original for the eye. */
public final class ShownByPrefix {
    private static final double[] SHARES = {.01, .02, .035, .05, .075, .1, .15, .2, .3, .4, .5, .6, .7, .8, .9};

    /** Difference of colours at which the first picture is of use, in % of white. */
    private static final double OFF = 3;

    /** Bytes that arrive in 2 s at 64 kbit/s, 256 kbit/s, 1 Mbit/s. */
    private static final long[] IN_TWO_SECONDS = {16_000, 64_000, 250_000};

    private final ArchiveFile archive;
    private final ProgressListener progress;

    /**
     * What is shown after some bytes.
     *
     * @param bytes that have arrived; the batches within them are shown
     * @param images that have arrived whole
     */
    public record Row(long bytes, int batches, int faces, int images, PictureMeter.Difference difference) {}

    public ShownByPrefix(ArchiveFile archive, ProgressListener progress) {
        this.archive = archive;
        this.progress = progress;
    }

    /**
     * What an archive shows.
     *
     * @param rows for shares of the file and for waits, without those that do not show the base yet
     * @param bytesOfColours after which colours are off by less than 3% of white
     */
    public record Result(List<Row> rows, long bytesOfColours) {}

    /** Measures prefixes of the archive. */
    public Result measure() throws IOException {
        BatchIndex index = archive.header().batches();
        PictureMeter meter = new PictureMeter(archive.original(progress), index.faces(0));
        return new Result(rows(index, meter), bytesOfColours(index, meter));
    }

    /** By halving, as colours hardly ever get worse. */
    private long bytesOfColours(BatchIndex index, PictureMeter meter) throws IOException {
        int bad = -1;
        int good = index.size() - 1;
        while (good - bad > 1) {
            int middle = (good + bad) >> 1;
            Mesh mesh = archive.meshAfter(middle, ProgressListener.NONE);
            if (meter.measure(mesh).colour() < OFF) good = middle;
            else bad = middle;
        }
        return index.end(good);
    }

    private List<Row> rows(BatchIndex index, PictureMeter meter) throws IOException {
        List<Row> rows = new ArrayList<>();
        int before = -1;
        PictureMeter.Difference difference = null;
        Mesh mesh = null;
        for (long bytes : sizes(index.archiveBytes())) {
            progress.step("measure", (double) bytes / index.archiveBytes());
            int batch = index.batchesWithin(bytes) - 1;
            if (batch < 0) continue;
            if (batch != before) {
                mesh = archive.meshAfter(batch, ProgressListener.NONE);
                difference = meter.measure(mesh);
            }
            before = batch;
            rows.add(new Row(bytes, batch + 1, mesh.faces(), mesh.textures().size(), difference));
        }
        return rows;
    }

    private static SortedSet<Long> sizes(long all) {
        SortedSet<Long> sizes = new TreeSet<>();
        for (double share : SHARES) sizes.add(Math.round(share * all));
        for (long bytes : IN_TWO_SECONDS) if (bytes < all) sizes.add(bytes);
        return sizes;
    }

    /**
     * The mean of the picture's differences over the time in which a visitor watches the archive arrive at a constant
     * rate, from the first of the shares on. After the last share nothing is missing.
     */
    public static double meanPicture(List<Row> rows) {
        double sum = 0;
        for (int i = 0; i + 1 < rows.size(); i++)
            sum += (rows.get(i + 1).bytes() - rows.get(i).bytes())
                    * (rows.get(i).difference().picture()
                            + rows.get(i + 1).difference().picture())
                    / 2;
        return rows.size() < 2
                ? 0
                : sum / (rows.get(rows.size() - 1).bytes() - rows.get(0).bytes());
    }
}
