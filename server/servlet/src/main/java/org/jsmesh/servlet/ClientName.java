package org.jsmesh.servlet;

import jakarta.servlet.http.HttpServletRequest;

/** Who asks, as far as an address tells. */
final class ClientName {
    /** A server that knows better, because it trusts a proxy, says it by this attribute of the request. */
    private static final String ATTRIBUTE = "org.jsmesh.client";

    private ClientName() {}

    static String of(HttpServletRequest request) {
        return request.getAttribute(ATTRIBUTE) instanceof String named ? named : request.getRemoteAddr();
    }
}
