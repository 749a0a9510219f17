package org.jsmesh.s3;

import java.nio.file.FileSystemException;
import java.time.Instant;
import java.util.Objects;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jsmesh.objects.StoredObject;

/** Takes from answers what everything else relies on, and says what is missing. */
final class S3Answers {
    private static final Pattern RANGE = Pattern.compile("bytes (\\d+)-(\\d+)/.*");
    private static final String REMEDY = ". Check what stands between here and the service, or use another service";

    private S3Answers() {}

    /**
     * The version that an answer is about.
     *
     * @param key behind the prefix of the place
     * @param bytes null when the answer does not say it; so are the tag and the time
     * @throws FileSystemException when the length or the tag is missing, without which versions cannot be told apart
     */
    static StoredObject object(S3Place place, String key, Long bytes, String tag, Instant modified)
            throws FileSystemException {
        if (bytes == null) throw failure(place, key, "the service tells no length (Content-Length)");
        if (tag == null || tag.isEmpty())
            throw failure(place, key, "the service tells no version (ETag), so that writers could not know each other");
        return new StoredObject(key, bytes, tag, Objects.requireNonNullElse(modified, Instant.EPOCH));
    }

    /**
     * Checks that an answer has the part that was asked for.
     *
     * @param range the Content-Range of the answer; null for none
     * @param begin first byte
     * @param end behind the last byte; {@link Long#MAX_VALUE} for the end of the object
     */
    static void checkPart(S3Place place, String key, String range, long begin, long end) throws FileSystemException {
        if (range == null) throw failure(place, key, "the service does not send parts of objects (Range)");
        Matcher sent = RANGE.matcher(range);
        boolean isAsked = sent.matches()
                && sent.group(1).equals(String.valueOf(begin))
                && (end == Long.MAX_VALUE || sent.group(2).equals(String.valueOf(end - 1)));
        if (!isAsked)
            throw failure(
                    place,
                    key,
                    "the service sent another part than bytes " + begin + " to " + (end - 1) + " (" + range + ")");
    }

    /**
     * Checks where a listing goes on.
     *
     * @param sent the token that the answer came for; null for the first page
     * @param next the token of the answer, which says that there is more
     */
    static String next(S3Place place, String sent, String next) throws FileSystemException {
        if (next == null || next.isEmpty())
            throw failure(place, "", "the service says that the list goes on, but not where (NextContinuationToken)");
        if (next.equals(sent)) throw failure(place, "", "the service sends the same page of the list again and again");
        return next;
    }

    private static FileSystemException failure(S3Place place, String key, String reason) {
        return new FileSystemException(place.address(key), null, reason + REMEDY);
    }
}
