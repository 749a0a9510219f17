package org.jsmesh.spark;

import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.Serializable;
import java.nio.file.NoSuchFileException;
import java.util.List;
import java.util.Locale;
import org.jsmesh.files.Explanation;
import org.jsmesh.memory.HeapShortageException;
import org.jsmesh.memory.MemoryEstimate;
import org.jsmesh.objects.ObjectConflictException;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.StoredObject;

/** Compares a model with what the last run knew of it, and looks at the header of one that has changed. */
final class PlanTask implements Serializable {
    private static final long serialVersionUID = 1;
    private static final int MOST_READS = 3;

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
        if (file == null) {
            boolean isInSite = !before.entry().isEmpty();
            return new PlanRow(isInSite ? PlanRow.Kind.ABSENT : PlanRow.Kind.FORGOTTEN, null, before);
        }
        try {
            ListedModel found = file.bytes() < 0 ? find(file) : file;
            if (before != null && isSame(found, before)) {
                PlanRow.Kind kind = before.isFailed() ? PlanRow.Kind.KEPT_FAILURE : PlanRow.Kind.KEPT;
                return new PlanRow(kind, null, null);
            }
            return plan(id, found);
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

    /** Plans a model that is to be encoded. One that changes meanwhile is taken as it has become. */
    PlanRow plan(String id, ListedModel file) throws IOException {
        ListedModel version = file;
        for (int i = 1; ; i++) {
            try {
                return estimate(id, version);
            } catch (ObjectConflictException e) {
                if (i == MOST_READS) throw e;
                version = find(version);
            }
        }
    }

    private PlanRow estimate(String id, ListedModel file) throws IOException {
        long room = Worker.gate().capacity();
        MemoryEstimate need = need(file, room);
        if (need.leastBytes() > room) return refused(id, file, tooLarge(file, need, room));
        long bytes = need.bytes() + EncodeModel.heldBytes(file);
        return new PlanRow(PlanRow.Kind.ENCODE, new PlannedModel(id, file, need.faces(), Math.min(bytes, room)), null);
    }

    private MemoryEstimate need(ListedModel file, long room) throws IOException {
        if (Listing.isArchive(file.key())) return new MemoryEstimate(0, 0, 2 * file.bytes(), file.bytes());
        FileRanges ranges = FileRanges.of(file);
        MemoryEstimate need = MemoryEstimate.of(file.fileName(), file.bytes(), ranges, settings.encoder());
        // Few samples are enough to order the work, and not to refuse it.
        return need.leastBytes() > room && ranges.isSparing()
                ? MemoryEstimate.of(file.fileName(), file.bytes(), ranges.withAllSamples(), settings.encoder())
                : need;
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
        return new Row.Failure(file.input(), reason, moreMemory(need.bytes()), Row.Kind.MEMORY);
    }

    private static String moreMemory(long bytes) {
        return String.format(Locale.ROOT, "Give executors more (--executor-memory %dg)", (bytes * 9 / 8 >> 30) + 1);
    }

    /** What the site or the way to it is at fault for, not the model. */
    static Row.Failure road(ListedModel file, Throwable e) {
        Explanation words = Explanation.of(file.input(), e);
        return new Row.Failure(words.place(), words.reason(), words.remedy(), Row.Kind.ROAD);
    }

    static Row.Failure failure(ListedModel file, Throwable e) {
        if (e instanceof HeapShortageException h)
            return new Row.Failure(file.input(), h.reason(), moreMemory(h.needBytes()), Row.Kind.MEMORY);
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
}
