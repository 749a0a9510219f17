package org.jsmesh.objects;

/**
 * An object to write.
 *
 * @param key names with slashes between them
 * @param content its bytes
 * @param contentType media type that a host sends it with; folders do not keep it
 * @param cacheControl how long others may keep it, likewise; null to say nothing
 * @param condition under which it is written
 */
public record Upload(String key, ObjectContent content, String contentType, String cacheControl, Condition condition) {
    /**
     * An object that is written in any case, of which nothing is said.
     *
     * @param key see {@link #key()}
     * @param content see {@link #content()}
     * @return the object
     */
    public static Upload of(String key, ObjectContent content) {
        return new Upload(key, content, "application/octet-stream", null, Condition.NONE);
    }

    /**
     * Says what hosts tell of it.
     *
     * @param type see {@link #contentType()}
     * @param cache see {@link #cacheControl()}
     * @return an upload that differs in that alone
     */
    public Upload withHeaders(String type, String cache) {
        return new Upload(key, content, type, cache, condition);
    }

    /**
     * Changes the condition.
     *
     * @param other see {@link #condition()}
     * @return an upload that differs in that alone
     */
    public Upload withCondition(Condition other) {
        return new Upload(key, content, contentType, cacheControl, other);
    }
}
