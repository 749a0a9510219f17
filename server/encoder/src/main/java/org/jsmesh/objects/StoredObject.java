package org.jsmesh.objects;

import java.time.Instant;

/**
 * One version of an object. Nothing of it is null.
 *
 * @param key names with slashes between them
 * @param bytes its length
 * @param tag another one for every other version under the key
 * @param modified when it was written, as the store tells it
 */
public record StoredObject(String key, long bytes, String tag, Instant modified) {}
