package org.jsmesh.store.bucket;

import org.jsmesh.objects.StoredObject;

/**
 * An object that is read whole: a manifest, a page of the catalogue.
 *
 * @param object the version that was read
 * @param content its bytes; shared, not copied
 */
record SmallObject(StoredObject object, byte[] content) {}
