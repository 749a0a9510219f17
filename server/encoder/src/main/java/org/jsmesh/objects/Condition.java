package org.jsmesh.objects;

/**
 * Under which condition an object is written. The store looks and writes in one step, so that of two writers under the
 * same condition one fails.
 *
 * @param tag that the object must have; null for any
 * @param absent whether there must be no object; the tag is null then
 */
public record Condition(String tag, boolean absent) {
    /** Always. */
    public static final Condition NONE = new Condition(null, false);

    /** Only when there is no object of the key yet. */
    public static final Condition ABSENT = new Condition(null, true);

    /**
     * Checks that there is one condition at most.
     *
     * @param tag see {@link #tag()}
     * @param absent see {@link #absent()}
     */
    public Condition {
        if (tag != null && absent) throw new IllegalArgumentException("an absent object has no tag " + tag);
    }

    /**
     * Only over a certain version.
     *
     * @param object the version; null when there must be none
     * @return the condition
     * @throws IllegalArgumentException when the version has no tag: nothing would tell it from others
     */
    public static Condition replacing(StoredObject object) {
        if (object == null) return ABSENT;
        if (object.tag() == null) throw new IllegalArgumentException(object.key() + " has no tag to be replaced by");
        return new Condition(object.tag(), false);
    }

    /**
     * Tells whether it holds.
     *
     * @param object that is there; null for none
     * @return true when the object may be written
     */
    public boolean holds(StoredObject object) {
        if (absent) return object == null;
        return tag == null || object != null && tag.equals(object.tag());
    }
}
