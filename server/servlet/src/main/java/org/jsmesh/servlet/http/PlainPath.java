package org.jsmesh.servlet.http;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;

/**
 * Refuses paths that containers, proxies and caches take for different resources: path parameters ({@code ;x=y}, which
 * containers leave out), and slashes, backslashes, semicolons, per cents and control characters in disguise. Otherwise
 * one resource would have any number of addresses, each with a place of its own in a cache.
 */
public final class PlainPath {
    private static final String HEX = "0123456789abcdef";
    private static final String DISGUISED = "/\\;%\u007f";

    private PlainPath() {}

    /** Whether the path of the request is plain; otherwise answers. */
    public static boolean check(HttpServletRequest request, HttpServletResponse response) throws IOException {
        if (isPlain(request.getRequestURI())) return true;
        Answer.leaveConnectionClean(request, response);
        String reason = "the address has path parameters, or a slash, semicolon or per cent in disguise";
        Answer.error(
                request,
                response,
                HttpServletResponse.SC_BAD_REQUEST,
                reason,
                "ask for an address as the catalogue or a manifest names it");
        return false;
    }

    /** @param path as the client has sent it */
    static boolean isPlain(String path) {
        for (int i = 0; i < path.length(); i++) {
            char c = path.charAt(i);
            if (c == ';' || c == '\\') return false;
            if (c != '%') continue;
            if (i + 2 >= path.length()) return false;
            int high = HEX.indexOf(Character.toLowerCase(path.charAt(i + 1)));
            int low = HEX.indexOf(Character.toLowerCase(path.charAt(i + 2)));
            char meant = (char) (16 * high + low);
            if (high < 0 || low < 0 || meant < ' ' || DISGUISED.indexOf(meant) >= 0) return false;
        }
        return true;
    }
}
