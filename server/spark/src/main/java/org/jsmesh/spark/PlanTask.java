package org.jsmesh.spark;

import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.Serializable;
import java.nio.ByteBuffer;
import java.nio.file.NoSuchFileException;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.jsmesh.files.Explanation;
import org.jsmesh.memory.ByteRanges;
import org.jsmesh.memory.MemoryEstimate;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.StoredObject;

/** Compares a model with what the last run knew of it, and looks at the header of one that has changed. */
final class PlanTask implements Serializable {
    private static final long serialVersionUID = 1;

    private final CatalogueSettings settings;
    private final Row.Stamp stamp;

    PlanTask(CatalogueSettings settings, Row.Stamp stamp) {
        this.settings = settings;
        this.stamp = stamp;
    }

    /**
     * Plans one model.
     *
     * @param id that it has in this run
     * @param file as it was listed; null when it was not
     * @param before what the last run wrote; null when it did not know the model
     */
    PlanRow plan(String id, ListedModel file, Row before) {
        if (file == null) return new PlanRow(PlanRow.Kind.ABSENT, null, before);
        try {
            ListedModel found = file.bytes() < 0 ? find(file) : file;
            if (before != null && isSame(found, before)) {
                PlanRow.Kind kind = before.isFailed() ? PlanRow.Kind.KEPT_FAILURE : PlanRow.Kind.KEPT;
                return new PlanRow(kind, null, before);
            }
            return estimate(id, found);
        } catch (IOException | RuntimeException e) {
            return refused(id, file, failure(file, e));
        }
    }

    private static ListedModel find(ListedModel file) throws IOException {
        StoredObject found = Listing.find(file);
        if (found == null) throw new NoSuchFileException(file.input());
        return file.at(found);
    }

    private boolean isSame(ListedModel file, Row before) throws IOException {
        if (!file.isSameAs(before.file()) || !stamp.makesTheSameAs(before.stamp())) return false;
        if (before.isFailed() && before.failure().isWorthAnotherTry()) return false;
        ObjectStore store = Worker.store(file.store());
        if (!Annotations.tag(store, file).equals(before.annotations())) return false;
        List<CompanionTag> companions = CompanionTag.fromJson(before.companions());
        return companions.isEmpty() || new Companions(store, file.folder()).have(companions);
    }

    private PlanRow estimate(String id, ListedModel file) throws IOException {
        MemoryEstimate need = Listing.isArchive(file.key())
                ? new MemoryEstimate(0, 0, 2 * file.bytes(), file.bytes())
                : MemoryEstimate.of(file.fileName(), file.bytes(), ranges(file), settings.encoder());
        long room = Worker.gate().capacity();
        if (need.leastBytes() > room) return refused(id, file, tooLarge(file, need, room));
        return new PlanRow(
                PlanRow.Kind.ENCODE, new PlannedModel(id, file, need.faces(), Math.min(need.bytes(), room)), null);
    }

    private PlanRow refused(String id, ListedModel file, Row.Failure failure) {
        return new PlanRow(PlanRow.Kind.REFUSED, null, new Row(id, file, stamp, "", "", null, failure, "", ""));
    }

    private static Row.Failure tooLarge(ListedModel file, MemoryEstimate need, long room) {
        String reason = String.format(
                Locale.ROOT,
                "its %d faces need %d MiB of heap, an executor has %d MiB for models",
                need.faces(),
                need.leastBytes() >> 20,
                room >> 20);
        String remedy = String.format(
                Locale.ROOT, "Give executors more (--executor-memory %dg)", (need.bytes() * 9 / 8 >> 30) + 1);
        return new Row.Failure(file.input(), reason, remedy, Row.Kind.MEMORY);
    }

    static Row.Failure failure(ListedModel file, Throwable e) {
        Explanation words = Explanation.of(file.input(), e);
        if (e instanceof NoSuchFileException || e instanceof FileNotFoundException)
            words = new Explanation(
                    file.input(), "is not there", "Correct the list, or run again when nobody changes the inputs");
        boolean isModel = e instanceof org.jsmesh.mesh.io.ModelFormatException
                || e instanceof org.jsmesh.mesh.MalformedStreamException
                || e instanceof IllegalArgumentException
                || e instanceof StackOverflowError;
        // Names in messages are those of files; in a catalogue only addresses tell them apart.
        String place = isModel ? within(file, words.place()) : words.place();
        return new Row.Failure(place, words.reason(), words.remedy(), isModel ? Row.Kind.MODEL : Row.Kind.ROAD);
    }

    private static String within(ListedModel file, String place) {
        String name = file.fileName();
        if (place.equals(name)) return file.input();
        if (place.startsWith(name + ", ")) return file.input() + place.substring(name.length());
        return place.contains(file.input()) ? place : file.input() + ", " + place;
    }

    /** The first bytes are read at once, and serve most questions. */
    private static ByteRanges ranges(ListedModel file) throws IOException {
        byte[] start = read(file, 0, (int) Math.min(file.bytes(), MemoryEstimate.START_BYTES));
        return (from, bytes) -> {
            int count = (int) Math.max(0, Math.min(bytes, file.bytes() - from));
            if (from + count <= start.length) return Arrays.copyOfRange(start, (int) from, (int) from + count);
            return read(file, from, count);
        };
    }

    private static byte[] read(ListedModel file, long from, int bytes) throws IOException {
        byte[] content = new byte[bytes];
        if (bytes > 0) Worker.store(file.store()).read(file.version(), from, ByteBuffer.wrap(content));
        return content;
    }
}
