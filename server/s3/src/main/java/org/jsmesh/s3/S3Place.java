package org.jsmesh.s3;

import java.net.URI;
import org.jsmesh.objects.ObjectKeys;

/**
 * A part of a bucket.
 *
 * @param bucket its name
 * @param prefix that all keys begin with; empty, or with a slash at its end
 */
record S3Place(String bucket, String prefix) {
    /** @throws IllegalArgumentException when it is not {@code s3://bucket} or {@code s3://bucket/prefix} */
    static S3Place of(URI address) {
        boolean isPlain = address.getRawQuery() == null && address.getRawFragment() == null;
        String bucket = address.getRawAuthority();
        if (!isPlain || bucket == null || !bucket.matches("[A-Za-z0-9._-]{3,255}"))
            throw new IllegalArgumentException(
                    address + ": is no place in a bucket. Write s3://bucket or s3://bucket/prefix");
        String path = address.getPath();
        int from = path.startsWith("/") ? 1 : 0;
        int to = path.endsWith("/") ? path.length() - 1 : path.length();
        if (to <= from) return new S3Place(bucket, "");
        return new S3Place(bucket, ObjectKeys.check(path.substring(from, to)) + "/");
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
