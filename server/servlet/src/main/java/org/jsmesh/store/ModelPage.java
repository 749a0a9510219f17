package org.jsmesh.store;

import java.util.List;
import java.util.function.Supplier;

/** A part of the list of models, in order of their ids: at most 1000 of them. Thread-safe. */
public final class ModelPage {
    /** The most models on a page. */
    public static final int MOST = 1000;

    private static final String BEGINNING = "after-";
    private static final String END = ".json";

    private final String after;
    private final String next;
    private final int total;
    private final long version;
    private final boolean whole;
    private final Supplier<List<ModelStatus>> models;
    private final long shape;
    private final Supplier<List<Part>> parts;

    /**
     * A page of the list.
     *
     * @param first id on it
     * @param models number of them
     * @param after what is asked for to get it, see {@link ModelPage#after()}
     */
    public record Part(String first, int models, String after) {}

    /** @param shape changes with the parts */
    ModelPage(
            String after,
            String next,
            int total,
            long version,
            boolean isWhole,
            Supplier<List<ModelStatus>> models,
            long shape,
            Supplier<List<Part>> parts) {
        this.after = after;
        this.next = next;
        this.total = total;
        this.version = version;
        whole = isWhole;
        this.models = models;
        this.shape = shape;
        this.parts = parts;
    }

    /**
     * Names a page beside the first one, {@code index.json}, such that a file can have the name.
     *
     * @param id behind which the page begins
     * @return the name, not encoded for an address
     */
    public static String fileName(String id) {
        return BEGINNING + id + END;
    }

    /**
     * Tells what page a name means.
     *
     * @param fileName any text
     * @return the id behind which it begins, not checked; null when it is no name of a page
     */
    public static String after(String fileName) {
        boolean isPage = fileName.startsWith(BEGINNING)
                && fileName.endsWith(END)
                && fileName.length() > BEGINNING.length() + END.length();
        return isPage ? fileName.substring(BEGINNING.length(), fileName.length() - END.length()) : null;
    }

    /** {@return what was asked for: the models come behind this id; null for the first ones} */
    public String after() {
        return after;
    }

    /** {@return the id behind which the next page begins; null when this is the last one} */
    public String next() {
        return next;
    }

    /** {@return the number of models on all pages} */
    public int total() {
        return total;
    }

    /**
     * {@return a number that changes when a model of the page comes, goes or gets another state; how far an encoding is
     * does not change it}
     */
    public long version() {
        return version;
    }

    /** {@return whether it begins where another page ends, as those do that are read one after the other} */
    public boolean isWhole() {
        return whole;
    }

    /** {@return a number that changes when {@link #parts} does} */
    public long shape() {
        return shape;
    }

    /** {@return all pages of the list as they are now, for the first one; none for the others} */
    public List<Part> parts() {
        return after == null ? parts.get() : List.of();
    }

    /** {@return the models with their states as they are now, which are at least as new as the version} */
    public List<ModelStatus> models() {
        return models.get();
    }
}
