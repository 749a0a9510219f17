package org.jsmesh.servlet;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.util.List;

/**
 * Tells browsers which other pages may read and measure an answer (CORS, Cross-Origin-Resource-Policy,
 * Timing-Allow-Origin).
 */
final class CrossOrigin {
    private static final String EXPOSED =
            "Accept-Ranges, Content-Length, Content-Location, Content-Range, ETag, Retry-After, Server-Timing";
    private static final String ALLOW = "Access-Control-Allow-Origin";

    private static final String SENT = "Authorization, Content-Digest, Content-Disposition, Content-Type, Repr-Digest, "
            + "Tus-Resumable, Upload-Checksum, Upload-Length, Upload-Metadata, Upload-Offset, X-HTTP-Method-Override, "
            + "X-Requested-With";
    private static final String TOLD = ", Link, Location, Tus-Checksum-Algorithm, Tus-Extension, Tus-Max-Size, "
            + "Tus-Resumable, Tus-Version, Upload-Expires, Upload-Length, Upload-Metadata, Upload-Offset";

    private final List<String> origins;
    private final List<String> senders;
    private final boolean all;

    /** @param senders whose pages may send and delete models, too */
    CrossOrigin(List<String> origins, List<String> senders) {
        this.origins = origins;
        this.senders = senders;
        all = origins.contains("*");
    }

    void allow(HttpServletRequest request, HttpServletResponse response) {
        if (all) {
            allow(response, "*");
            return;
        }
        response.setHeader("Vary", "Origin");
        String origin = request.getHeader("Origin");
        // A page elsewhere that may read the bytes asks with CORS. Nobody else may embed them.
        response.setHeader("Cross-Origin-Resource-Policy", "same-origin");
        if (origin != null && origins.contains(origin)) allow(response, origin);
    }

    private static void allow(HttpServletResponse response, String origin) {
        response.setHeader(ALLOW, origin);
        response.setHeader("Access-Control-Expose-Headers", EXPOSED);
        response.setHeader("Cross-Origin-Resource-Policy", "cross-origin");
        response.setHeader("Timing-Allow-Origin", origin);
    }

    /** Lets pages of those who may send do so; what others may read has been said before. */
    void allowSending(HttpServletRequest request, HttpServletResponse response, String methods) {
        String origin = request.getHeader("Origin");
        if (origin == null || !senders.contains("*") && !senders.contains(origin)) return;
        response.setHeader("Vary", "Origin");
        allow(response, origin);
        response.setHeader("Access-Control-Expose-Headers", EXPOSED + TOLD);
        response.setHeader("Access-Control-Allow-Methods", methods);
        response.setHeader("Access-Control-Allow-Headers", SENT + ", Range, If-Range, If-None-Match");
        response.setHeader("Access-Control-Max-Age", "86400");
    }

    /** Answers the question that browsers ask before a request with fields of its own. */
    void preflight(HttpServletResponse response, String methods) {
        response.setHeader("Allow", methods);
        if (response.containsHeader(ALLOW)) {
            response.setHeader("Access-Control-Allow-Methods", methods);
            response.setHeader("Access-Control-Allow-Headers", "Range, If-Range, If-None-Match");
            response.setHeader("Access-Control-Max-Age", "86400");
        }
        response.setStatus(HttpServletResponse.SC_NO_CONTENT);
    }
}
