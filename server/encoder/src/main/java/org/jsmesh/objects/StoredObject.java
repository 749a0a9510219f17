package org.jsmesh.objects;

import java.time.Instant;

/**
 * One version of an object. A store that cannot tell its length or its tag fails instead, so nothing of it is null.
 *
 * @param key names with slashes between them
 * @param bytes its length
 * @param tag another one for every other version under the key
 * @param modified when it was written, as the store tells it; {@link Instant#EPOCH} where it does not
 */
public record StoredObject(String key, long bytes, String tag, Instant modified) {}
