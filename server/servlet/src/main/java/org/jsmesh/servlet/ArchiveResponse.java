package org.jsmesh.servlet;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.net.URI;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.servlet.http.Answer;
import org.jsmesh.servlet.http.EntityTags;
import org.jsmesh.servlet.http.ResponseSender;
import org.jsmesh.store.ServedArchive;

/**
 * Answers with bytes of an archive. Decides which bytes, and writes the header in front of them; {@link ResponseSender}
 * sends them.
 */
final class ArchiveResponse {
    static final String TYPE = "model/vnd.jsm";
    static final String IMMUTABLE = "public, max-age=31536000, immutable, no-transform";

    /** The canonical resource: the whole archive or one range of it. */
    void sendArchive(HttpServletRequest request, HttpServletResponse response, ServedArchive archive)
            throws IOException {
        response.setHeader("Cache-Control", SignedAddresses.caching(request, IMMUTABLE));
        ByteRange range = range(request, response, '"' + archive.sha256() + '"', archive.bytes(), "archive");
        if (range == null) return;
        send(request, response, archive, range.first(), range.length());
    }

    /** Sends the client elsewhere for the whole archive or ranges of it, unless it has the archive. */
    void redirect(HttpServletRequest request, HttpServletResponse response, ServedArchive archive, URI elsewhere)
            throws IOException {
        response.setHeader("Accept-Ranges", "bytes");
        if (EntityTags.answer(request, response, '"' + archive.sha256() + '"')) return;
        // The address is not good for long, and for this client alone.
        response.setHeader("Cache-Control", "no-store");
        response.setHeader("ETag", null);
        Answer.redirect(response, HttpServletResponse.SC_TEMPORARY_REDIRECT, elsewhere.toString());
    }

    /**
     * What of a file is to be sent, with the header that goes with a part.
     *
     * @param tag strong, with its quotes
     * @param total bytes of the file
     * @param what the file is, for people
     * @return null when the request is answered
     */
    static ByteRange range(
            HttpServletRequest request, HttpServletResponse response, String tag, long total, String what)
            throws IOException {
        response.setHeader("Accept-Ranges", "bytes");
        if (EntityTags.answer(request, response, tag)) return null;
        ByteRange range = requested(request, tag, total);
        if (range.kind() == ByteRange.Kind.UNSATISFIABLE) {
            response.setHeader("Content-Range", range.contentRange(total));
            String reason = "the " + what + " has " + total + " bytes; the range asked for lies behind them";
            Answer.error(
                    request,
                    response,
                    HttpServletResponse.SC_REQUESTED_RANGE_NOT_SATISFIABLE,
                    reason,
                    "ask for bytes that exist");
            return null;
        }
        if (range.kind() == ByteRange.Kind.PART) {
            response.setStatus(HttpServletResponse.SC_PARTIAL_CONTENT);
            response.setHeader("Content-Range", range.contentRange(total));
        }
        return range;
    }

    /** Sends whole batches from {@code first} to {@code last}, both included, as an immutable resource of their own. */
    void sendBatches(
            HttpServletRequest request, HttpServletResponse response, ServedArchive archive, int first, int last)
            throws IOException {
        if (isAnswered(request, response, '"' + archive.sha256() + '.' + first + '-' + last + '"')) return;
        long offset = archive.batches().offset(first);
        send(request, response, archive, offset, archive.batches().end(last) - offset);
    }

    /** Sends what a client asks for before it knows the index, as an immutable resource. */
    void sendFirst(HttpServletRequest request, HttpServletResponse response, ServedArchive archive) throws IOException {
        if (isAnswered(request, response, '"' + archive.sha256() + ".first\"")) return;
        send(request, response, archive, 0, archive.batches().firstBytes());
    }

    /** Sends the poster of an archive that has one, as an immutable resource. */
    void sendPoster(HttpServletRequest request, HttpServletResponse response, ServedArchive archive)
            throws IOException {
        if (isAnswered(request, response, '"' + archive.sha256() + ".poster\"")) return;
        BatchIndex index = archive.batches();
        int batch = index.poster();
        int length = BatchIndex.payloadBytes(index.bytes(batch));
        send(request, response, "image/jpeg", archive, index.offset(batch), length);
    }

    void send(HttpServletRequest request, HttpServletResponse response, ServedArchive archive, long offset, long length)
            throws IOException {
        send(request, response, TYPE, archive, offset, length);
    }

    private void send(
            HttpServletRequest request,
            HttpServletResponse response,
            String type,
            ServedArchive archive,
            long offset,
            long length)
            throws IOException {
        ArchiveSource source = request.getMethod().equals("HEAD") ? null : ArchiveSource.of(archive, length);
        if (source == null && !request.getMethod().equals("HEAD")) {
            response.setHeader("Retry-After", "1");
            String reason = "the archive was closed meanwhile";
            Answer.error(request, response, HttpServletResponse.SC_SERVICE_UNAVAILABLE, reason, "ask again");
            return;
        }
        response.setContentType(type);
        response.setContentLengthLong(length);
        if (source != null) ResponseSender.start(request, response, source, offset, length);
    }

    private static boolean isAnswered(HttpServletRequest request, HttpServletResponse response, String tag)
            throws IOException {
        response.setHeader("Cache-Control", SignedAddresses.caching(request, IMMUTABLE));
        return EntityTags.answer(request, response, tag);
    }

    private static ByteRange requested(HttpServletRequest request, String tag, long total) {
        if (!request.getMethod().equals("GET")) return ByteRange.whole(total);
        String condition = request.getHeader("If-Range");
        if (condition != null && !EntityTags.isSame(condition, tag)) return ByteRange.whole(total);
        return ByteRange.parse(request.getHeader("Range"), total);
    }
}
