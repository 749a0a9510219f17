package org.jsmesh.s3;

import java.nio.file.FileSystemException;
import java.time.Instant;
import java.util.Objects;
import org.jsmesh.objects.StoredObject;

/** What a service tells of an object. */
final class S3Facts {
    private static final String OTHER = ". Use a service, or a way to it, that does as Amazon's S3";

    private S3Facts() {}

    /**
     * Checks that it tells enough: without tags, two writers would lose what the other has written.
     *
     * @param key relative to the place
     * @param bytes null when the service does not tell
     * @param tag null when the service does not tell
     * @param modified null when the service does not tell; the object counts as old then
     */
    static StoredObject of(S3Place place, String key, Long bytes, String tag, Instant modified)
            throws FileSystemException {
        if (tag == null || tag.isEmpty()) throw lacks(place, key, "no ETag");
        if (bytes == null) throw lacks(place, key, "no length");
        return new StoredObject(key, bytes, tag, Objects.requireNonNullElse(modified, Instant.EPOCH));
    }

    private static FileSystemException lacks(S3Place place, String key, String what) {
        return new FileSystemException(place.address(key), null, "the service tells " + what + " of it" + OTHER);
    }

    /** For an answer that has other bytes than those that were asked for. */
    static FileSystemException noPart(S3Place place, String key) {
        return new FileSystemException(
                place.address(key), null, "the service does not send the part of it that is asked for" + OTHER);
    }

    /** For a listing that cannot be gone through. */
    static FileSystemException noEnd(S3Place place) {
        return new FileSystemException(
                place.address(""), null, "the service does not say how its listing goes on" + OTHER);
    }
}
