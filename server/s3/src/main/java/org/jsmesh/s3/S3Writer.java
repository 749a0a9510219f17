package org.jsmesh.s3;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.time.Instant;
import java.time.format.DateTimeFormatter;
import java.time.format.DateTimeParseException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import org.jsmesh.objects.Condition;
import org.jsmesh.objects.ObjectConflictException;
import org.jsmesh.objects.ObjectContent;
import org.jsmesh.objects.StoredObject;
import org.jsmesh.objects.Upload;
import software.amazon.awssdk.core.exception.SdkException;
import software.amazon.awssdk.core.sync.RequestBody;
import software.amazon.awssdk.http.SdkHttpResponse;
import software.amazon.awssdk.services.s3.S3Client;
import software.amazon.awssdk.services.s3.model.CompletedPart;
import software.amazon.awssdk.services.s3.model.HeadObjectResponse;
import software.amazon.awssdk.services.s3.model.PutObjectResponse;
import software.amazon.awssdk.services.s3.model.S3Response;

/** Writes objects, in one piece or in parts. */
final class S3Writer {
    private static final String RIGHT = "s3:PutObject";
    /** Says which write an object comes from, so that one that was tried twice knows itself. */
    private static final String WRITE = "jsm-write";

    private static final int MOST_PARTS = 9_000;
    /** Of a write that the service refuses for another one that runs. */
    private static final int MOST_TRIES = 2;

    private final S3Client client;
    private final S3Place place;
    private final long mostInOne;
    private final long leastPart;

    /**
     * Writes to a place.
     *
     * @param mostInOne bytes of the largest object that is written in one piece
     * @param leastPart bytes of a part of larger ones
     */
    S3Writer(S3Client client, S3Place place, long mostInOne, long leastPart) {
        this.client = client;
        this.place = place;
        this.mostInOne = mostInOne;
        this.leastPart = leastPart;
    }

    StoredObject write(Upload upload) throws IOException {
        boolean isConditional = !upload.condition().equals(Condition.NONE);
        for (int tries = 1; ; tries++) {
            String write = UUID.randomUUID().toString();
            try {
                return upload.content().bytes() > mostInOne ? inParts(upload, write) : inOne(upload, write);
            } catch (SdkException e) {
                int status = S3Failures.status(e);
                boolean isChanged = status == S3Failures.FAILED_CONDITION
                        || status == S3Failures.CONFLICT
                        || status == S3Failures.MISSING;
                // The first try may have been done, and only its answer lost.
                StoredObject own = isChanged ? own(upload, write) : null;
                if (own != null) return own;
                boolean isGone = status == S3Failures.MISSING && !isBucketMissing(e);
                if (isConditional && isChanged && (isGone || status != S3Failures.MISSING)) throw conflict(upload, e);
                // Without a condition nobody else is in the way for long.
                if (isConditional || status != S3Failures.CONFLICT || tries == MOST_TRIES)
                    throw S3Failures.of(e, place.address(upload.key()), RIGHT);
            } catch (UncheckedIOException e) {
                throw e.getCause();
            }
        }
    }

    private ObjectConflictException conflict(Upload upload, SdkException e) {
        ObjectConflictException conflict = new ObjectConflictException(
                place.address(upload.key()), "was written by somebody else meanwhile. Try again");
        conflict.initCause(e);
        return conflict;
    }

    private static boolean isBucketMissing(SdkException e) {
        return String.valueOf(e.getMessage()).contains("bucket");
    }

    private StoredObject own(Upload upload, String write) throws IOException {
        try {
            HeadObjectResponse head =
                    client.headObject(b -> b.bucket(place.bucket()).key(place.key(upload.key())));
            boolean isOwn = write.equals(head.metadata().get(WRITE));
            return isOwn
                    ? S3Answers.object(place, upload.key(), head.contentLength(), head.eTag(), head.lastModified())
                    : null;
        } catch (SdkException e) {
            return null; // What happened first is told.
        }
    }

    private StoredObject inOne(Upload upload, String write) throws IOException {
        Condition condition = upload.condition();
        ObjectContent content = upload.content();
        PutObjectResponse answer = client.putObject(
                b -> {
                    b.bucket(place.bucket()).key(place.key(upload.key())).contentType(upload.contentType());
                    b.cacheControl(upload.cacheControl());
                    if (condition.absent()) b.ifNoneMatch("*");
                    if (condition.tag() != null) b.ifMatch(condition.tag());
                    if (!condition.equals(Condition.NONE)) b.metadata(Map.of(WRITE, write));
                },
                RequestBody.fromContentProvider(
                        () -> open(content, 0, content.bytes()), content.bytes(), upload.contentType()));
        return S3Answers.object(place, upload.key(), content.bytes(), answer.eTag(), time(answer));
    }

    private StoredObject inParts(Upload upload, String write) throws IOException {
        String key = place.key(upload.key());
        String id = client.createMultipartUpload(b -> b.bucket(place.bucket())
                        .key(key)
                        .contentType(upload.contentType())
                        .cacheControl(upload.cacheControl())
                        .metadata(Map.of(WRITE, write)))
                .uploadId();
        String tag;
        Instant time;
        try {
            List<CompletedPart> parts = parts(upload.content(), key, id);
            Condition condition = upload.condition();
            var answer = client.completeMultipartUpload(b -> {
                b.bucket(place.bucket()).key(key).uploadId(id).multipartUpload(m -> m.parts(parts));
                if (condition.absent()) b.ifNoneMatch("*");
                if (condition.tag() != null) b.ifMatch(condition.tag());
            });
            tag = answer.eTag();
            time = time(answer);
        } catch (SdkException | UncheckedIOException e) {
            abort(key, id, e);
            throw e;
        }
        return S3Answers.object(place, upload.key(), upload.content().bytes(), tag, time);
    }

    private List<CompletedPart> parts(ObjectContent content, String key, String id) {
        long size = Math.max(leastPart, content.bytes() / MOST_PARTS + 1);
        List<CompletedPart> parts = new ArrayList<>();
        for (long from = 0; from < content.bytes(); from += size) {
            long begin = from;
            long length = Math.min(size, content.bytes() - from);
            int number = parts.size() + 1;
            String tag = client.uploadPart(
                            b -> b.bucket(place.bucket()).key(key).uploadId(id).partNumber(number),
                            RequestBody.fromContentProvider(
                                    () -> open(content, begin, length), length, "application/octet-stream"))
                    .eTag();
            parts.add(CompletedPart.builder().partNumber(number).eTag(tag).build());
        }
        return parts;
    }

    /** Parts that nobody completes would be paid for. */
    private void abort(String key, String id, RuntimeException reason) {
        boolean wasInterrupted = Thread.interrupted();
        try {
            client.abortMultipartUpload(b -> b.bucket(place.bucket()).key(key).uploadId(id));
        } catch (SdkException e) {
            reason.addSuppressed(e);
        } finally {
            if (wasInterrupted) Thread.currentThread().interrupt();
        }
    }

    private static InputStream open(ObjectContent content, long offset, long length) {
        try {
            InputStream in = content.open();
            try {
                in.skipNBytes(offset);
            } catch (IOException e) {
                in.close();
                throw e;
            }
            return offset + length == content.bytes() ? in : new LimitedStream(in, length);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** By the service's clock. */
    private static Instant time(S3Response answer) {
        SdkHttpResponse http = answer.sdkHttpResponse();
        try {
            return http.firstMatchingHeader("Date")
                    .map(date -> Instant.from(DateTimeFormatter.RFC_1123_DATE_TIME.parse(date)))
                    .orElseGet(Instant::now);
        } catch (DateTimeParseException e) {
            return Instant.now();
        }
    }
}
