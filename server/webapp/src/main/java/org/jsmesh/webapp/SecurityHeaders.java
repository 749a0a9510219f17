package org.jsmesh.webapp;

import jakarta.servlet.Filter;
import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.ServletRequest;
import jakarta.servlet.ServletResponse;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;
import java.util.Map;

/**
 * Headers of the page: no guessing of content types, and nothing runs but the page's own files. What is neither a page
 * nor a worker lives by the policy of the page that asks for it, so it goes without: a slow link has enough to carry.
 */
final class SecurityHeaders implements Filter {
    /**
     * Scripts from here only, WebAssembly allowed, nothing inline but data; pictures also from memory (textures,
     * previews); archives, which are mere data, from any server. Who may frame the page is not in it: a page cannot say
     * that of itself.
     */
    static final String POLICY =
            "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; connect-src 'self' blob: http: https:; "
                    + "img-src 'self' blob: data:; style-src 'self'; font-src 'self'; base-uri 'self'; form-action 'none'";

    /** Features that the page never asks a browser for. */
    static final String PERMISSIONS = "camera=(), geolocation=(), microphone=(), payment=(), usb=()";

    /** How the name of a worker's script begins. */
    private static final String WORKER = "worker-";

    private static final String SNIFFING = "X-Content-Type-Options";
    private static final String NO_SNIFFING = "nosniff";

    private final Map<String, String> ofPages;

    /** @param embedders origins whose pages may have the page in a frame, besides those of its own */
    SecurityHeaders(List<String> embedders) {
        ofPages = ofPages(embedders);
    }

    static Map<String, String> ofPages(List<String> embedders) {
        String ancestors = embedders.contains("*") ? "*" : String.join(" ", "'self'", String.join(" ", embedders));
        return Map.of(
                SNIFFING,
                NO_SNIFFING,
                "Referrer-Policy",
                "no-referrer",
                "Content-Security-Policy",
                POLICY + "; frame-ancestors " + ancestors.strip(),
                "Permissions-Policy",
                PERMISSIONS,
                "Cross-Origin-Opener-Policy",
                "same-origin");
    }

    @Override
    public void doFilter(ServletRequest request, ServletResponse response, FilterChain chain)
            throws IOException, ServletException {
        HttpServletResponse http = (HttpServletResponse) response;
        if (isPart(((HttpServletRequest) request).getServletPath())) http.setHeader(SNIFFING, NO_SNIFFING);
        else ofPages.forEach(http::setHeader);
        chain.doFilter(request, response);
    }

    private static boolean isPart(String path) {
        String name = path.substring(path.lastIndexOf('/') + 1);
        return name.matches(".+\\.(js|css|wasm)") && !name.startsWith(WORKER);
    }
}
