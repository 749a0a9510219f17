package org.jsmesh.servlet.http;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Enumeration;

/**
 * Decides by the entity tags that a request names whether it is answered with a representation that has a strong tag
 * (RFC 9110, section 13). Nothing here has a date of its last change, so conditions on dates are no conditions.
 */
public final class EntityTags {
    private EntityTags() {}

    /**
     * Sets the tag, and answers when the request's conditions keep it from a representation.
     *
     * @param tag of the representation that would be sent, with its quotes; without a comma in it
     * @return true when the request is answered: the client has it already (304), or wants another one (412)
     */
    public static boolean answer(HttpServletRequest request, HttpServletResponse response, String tag)
            throws IOException {
        response.setHeader("ETag", tag);
        if (isNamed(request, "If-Match") && !matches(request, "If-Match", tag, false)) {
            Answer.error(
                    request,
                    response,
                    HttpServletResponse.SC_PRECONDITION_FAILED,
                    "what is here now is not what the request names in If-Match",
                    "ask again without If-Match, and start from the beginning");
            return true;
        }
        if (!matches(request, "If-None-Match", tag, true)) return false;
        response.setStatus(HttpServletResponse.SC_NOT_MODIFIED);
        return true;
    }

    private static boolean isNamed(HttpServletRequest request, String field) {
        return request.getHeader(field) != null;
    }

    /** Whether any line of the field names the tag, or all there are with a star. */
    private static boolean matches(HttpServletRequest request, String field, String tag, boolean weakToo) {
        Enumeration<String> lines = request.getHeaders(field);
        while (lines != null && lines.hasMoreElements()) {
            if (matches(lines.nextElement(), tag, weakToo)) return true;
        }
        return false;
    }

    private static boolean matches(String line, String tag, boolean weakToo) {
        if (line.strip().equals("*")) return true;
        // Our tags hold no comma, so that splitting cannot make two halves of a foreign tag match.
        for (String candidate : line.split(",")) {
            String plain = candidate.strip();
            if (weakToo && plain.startsWith("W/")) plain = plain.substring(2);
            if (plain.equals(tag)) return true;
        }
        return false;
    }

    /** For If-Range: strong comparison, and a date never matches because it is no strong validator here. */
    public static boolean isSame(String field, String tag) {
        return field.strip().equals(tag);
    }
}
