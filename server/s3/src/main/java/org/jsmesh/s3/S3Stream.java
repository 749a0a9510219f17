package org.jsmesh.s3;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.util.Objects;
import org.jsmesh.objects.ObjectConflictException;
import software.amazon.awssdk.core.ResponseInputStream;
import software.amazon.awssdk.core.exception.AbortedException;
import software.amazon.awssdk.core.exception.SdkException;
import software.amazon.awssdk.services.s3.S3Client;
import software.amazon.awssdk.services.s3.model.GetObjectRequest;
import software.amazon.awssdk.services.s3.model.GetObjectResponse;

/**
 * Bytes of one version of an object. A connection that breaks is opened anew at the place it had come to, as long as
 * that version is there.
 */
final class S3Stream extends InputStream {
    private static final int MOST_BREAKS = 3;

    private final S3Client client;
    private final S3Place place;
    private final String key;
    private String tag;
    private long position;
    private long end; // -1 until the length is known
    private InputStream in; // null when it has to be opened
    private int breaks;

    /**
     * Opens it.
     *
     * @param tag of the version; null for the present one
     * @param offset of the first byte
     * @param bytes to read, or -1 for all
     */
    S3Stream(S3Client client, S3Place place, String key, String tag, long offset, long bytes) throws IOException {
        this.client = client;
        this.place = place;
        this.key = key;
        this.tag = tag;
        position = offset;
        end = bytes < 0 ? -1 : offset + bytes;
        in = connect();
    }

    private InputStream connect() throws IOException {
        GetObjectRequest.Builder request =
                GetObjectRequest.builder().bucket(place.bucket()).key(place.key(key));
        if (tag != null) request.ifMatch(tag);
        boolean isPart = end >= 0;
        if (isPart) request.range("bytes=" + position + "-" + (end - 1));
        try {
            ResponseInputStream<GetObjectResponse> body = client.getObject(request.build());
            GetObjectResponse head = body.response();
            if (isPart) checkPart(body);
            if (end < 0) end = Objects.requireNonNullElse(head.contentLength(), Long.MAX_VALUE);
            if (tag == null) tag = head.eTag();
            return body;
        } catch (SdkException e) {
            int status = S3Failures.status(e);
            boolean isOther = status == S3Failures.FAILED_CONDITION
                    || tag != null && (status == S3Failures.MISSING || status == S3Failures.BEYOND_END);
            if (!isOther) throw S3Failures.of(e, place.address(key), "s3:GetObject");
            ObjectConflictException conflict = new ObjectConflictException(
                    place.address(key), "was replaced or removed while it was read. Try again");
            conflict.initCause(e);
            throw conflict;
        }
    }

    private void checkPart(ResponseInputStream<GetObjectResponse> body) throws IOException {
        try {
            S3Answers.checkPart(place, key, body.response().contentRange(), position, end);
        } catch (IOException e) {
            body.abort(); // Else the whole object might be read to keep the connection.
            throw e;
        }
    }

    @Override
    public int read() throws IOException {
        byte[] one = new byte[1];
        return read(one, 0, 1) < 0 ? -1 : one[0] & 0xff;
    }

    @Override
    public int read(byte[] into, int offset, int length) throws IOException {
        if (length == 0) return 0;
        while (position < end) {
            int count;
            try {
                if (in == null) in = connect();
                count = in.read(into, offset, (int) Math.min(length, end - position));
                if (count < 0 && end == Long.MAX_VALUE) return -1;
                if (count < 0) throw new EOFException(place.address(key) + ": the answer ended too soon");
            } catch (ObjectConflictException e) {
                throw e;
            } catch (IOException e) {
                breakOff(e);
                continue;
            } catch (SdkException e) {
                breakOff(S3Failures.of(e, place.address(key), "s3:GetObject"));
                continue;
            }
            position += count;
            return count;
        }
        return -1;
    }

    private void breakOff(IOException e) throws IOException {
        abort();
        boolean isEnded = Thread.currentThread().isInterrupted() || e.getCause() instanceof AbortedException;
        // Without a tag it could go on with another version.
        if (isEnded || tag == null || ++breaks > MOST_BREAKS) throw e;
    }

    private void abort() {
        if (in instanceof ResponseInputStream<?> body) body.abort();
        in = null;
    }

    @Override
    public void close() throws IOException {
        if (in == null) return;
        // What is left would be read to keep the connection.
        if (position < end) abort();
        else in.close();
        in = null;
    }
}
