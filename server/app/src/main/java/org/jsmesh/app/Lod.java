package org.jsmesh.app;

import java.nio.file.Path;
import org.jsmesh.app.console.CommandFailure;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.files.ArchiveFile;
import picocli.CommandLine.Option;
import picocli.CommandLine.TypeConversionException;

/** The resolution that the user asks for, in one of several ways. An option group. */
final class Lod {
    @Option(
            names = "--faces",
            paramLabel = "N",
            converter = Count.class,
            description = "The resolution nearest to N faces.")
    private Integer faces;

    @Option(
            names = "--error",
            paramLabel = "P%",
            converter = Percent.class,
            description =
                    "The coarsest resolution whose mean distance to the original is at most P percent of the bounding box's diagonal.")
    private Double error;

    @Option(
            names = "--level",
            paramLabel = "L",
            description = "The resolution at the end of level L; 0 is the base, 1 the coarsest level.")
    private Integer level;

    @Option(names = "--bytes", paramLabel = "N", description = "What the first N bytes of the archive show.")
    private Long bytes;

    @Option(names = "--batch", paramLabel = "K", description = "The resolution after batch K; 0 is the base.")
    private Integer batch;

    /** Reads whole numbers from 0 on. */
    static final class Count implements picocli.CommandLine.ITypeConverter<Integer> {
        @Override
        public Integer convert(String text) {
            try {
                int value = Integer.parseInt(text.strip());
                if (value >= 0) return value;
            } catch (NumberFormatException e) {
                // Said below.
            }
            throw new TypeConversionException("'" + text + "' is no number of faces such as 5000");
        }
    }

    /** Reads {@code 0.5} and {@code 0.5%}. */
    static final class Percent implements picocli.CommandLine.ITypeConverter<Double> {
        @Override
        public Double convert(String text) {
            String number = text.endsWith("%") ? text.substring(0, text.length() - 1) : text;
            try {
                double value = Double.parseDouble(number.strip());
                if (value >= 0) return value;
            } catch (NumberFormatException e) {
                // Said below.
            }
            throw new TypeConversionException("'" + text + "' is no percentage such as 0.5%");
        }
    }

    /**
     * The batch after which the archive shows this resolution.
     *
     * @throws CommandFailure when the file does not reach that far, or there is no such resolution
     */
    int batch(Path file, ArchiveFile archive) throws CommandFailure {
        BatchIndex index = archive.index();
        int there = archive.batches();
        if (there == 0) {
            throw new CommandFailure(file + ": has " + archive.length() + " bytes, the base mesh needs " + index.end(0)
                    + ". Fetch more of the archive.");
        }
        if (faces != null) return nearest(index, there, faces);
        if (bytes != null) return ofBytes(file, index, there);
        int wanted =
                batch != null ? ofBatch(file, index) : error != null ? ofError(file, index) : ofLevel(file, archive);
        if (wanted >= there) {
            throw new CommandFailure(
                    file + ": the file is cut after batch " + (there - 1) + ", this resolution needs batch " + wanted
                            + ". Fetch the rest of the archive, or ask for --batch " + (there - 1) + ".");
        }
        return wanted;
    }

    /**
     * Among batches with equally near counts, takes the last one with the smaller count. It is more precise at the same
     * number of faces.
     */
    private static int nearest(BatchIndex index, int there, int faces) {
        int best = 0;
        for (int i = 1; i < there; i++) {
            long distance = Math.abs((long) index.faces(i) - faces);
            long least = Math.abs((long) index.faces(best) - faces);
            if (distance < least || index.faces(i) == index.faces(best)) best = i;
        }
        return best;
    }

    private int ofBytes(Path file, BatchIndex index, int there) throws CommandFailure {
        int within = index.batchesWithin(bytes);
        if (within == 0)
            throw new CommandFailure(file + ": the first " + bytes + " bytes show nothing, the base mesh ends at byte "
                    + index.end(0) + ". Ask for --bytes " + index.end(0) + " or more.");
        return Math.min(within, there) - 1;
    }

    private int ofBatch(Path file, BatchIndex index) throws CommandFailure {
        if (batch >= 0 && batch < index.size()) return batch;
        throw new CommandFailure(
                file + ": there is no batch " + batch + ". Ask for one of 0 to " + (index.size() - 1) + ".");
    }

    private int ofError(Path file, BatchIndex index) throws CommandFailure {
        for (int i = 0; i < index.size(); i++) {
            if (index.errorMean(i) <= error) return i;
        }
        throw new CommandFailure(
                file + ": no resolution has an error of at most " + error + "%. Ask for a larger error.");
    }

    private int ofLevel(Path file, ArchiveFile archive) throws CommandFailure {
        BatchIndex index = archive.index();
        if (archive.header() == null)
            throw new CommandFailure(
                    file
                            + ": the file is cut before the levels are named. Fetch more of the archive, or ask for --faces N.");
        int levels = archive.header().levels().size();
        if (level < 0 || level > levels)
            throw new CommandFailure(file + ": there is no level " + level + ". Ask for one of 0 to " + levels + ".");
        int last = 0;
        for (int i = 0; i < index.size(); i++) {
            if (index.level(i) <= level) last = i;
        }
        return last;
    }
}
