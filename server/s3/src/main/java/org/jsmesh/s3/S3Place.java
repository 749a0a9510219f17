package org.jsmesh.s3;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jsmesh.objects.ObjectKeys;

/**
 * A part of a bucket.
 *
 * @param bucket its name
 * @param prefix that all keys begin with; empty, or with a slash at its end
 */
record S3Place(String bucket, String prefix) {
    private static final Pattern ADDRESS =
            Pattern.compile("s3://([A-Z0-9._-]{3,255})(?:/(.*?)/?)?", Pattern.CASE_INSENSITIVE | Pattern.DOTALL);

    /** @throws IllegalArgumentException when it is not {@code s3://bucket} or {@code s3://bucket/prefix} */
    static S3Place of(String address) {
        Matcher parts = ADDRESS.matcher(address);
        String prefix = parts.matches() && parts.group(2) != null ? parts.group(2) : "";
        if (!parts.matches() || !prefix.isEmpty() && !ObjectKeys.isKey(prefix))
            throw new IllegalArgumentException(
                    address + ": is no place in a bucket. Write s3://bucket or s3://bucket/prefix");
        return new S3Place(parts.group(1), prefix.isEmpty() ? "" : prefix + "/");
    }

    /** The whole key in the bucket. */
    String key(String key) {
        return prefix + ObjectKeys.check(key);
    }

    /** For people; empty for the place itself. */
    String address(String key) {
        String address = "s3://" + bucket + "/" + prefix + key;
        return address.endsWith("/") ? address.substring(0, address.length() - 1) : address;
    }
}
