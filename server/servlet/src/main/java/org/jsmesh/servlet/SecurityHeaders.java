package org.jsmesh.servlet;

import jakarta.servlet.Filter;
import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.ServletRequest;
import jakarta.servlet.ServletResponse;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;

/** Headers that every answer carries: no guessing of content types, and a page that runs nothing but its own files. */
public final class SecurityHeaders implements Filter {
    /**
     * Scripts from here only, WebAssembly allowed, nothing inline; pictures also from memory (textures, previews);
     * archives, which are mere data, from any server.
     */
    public static final String POLICY =
            "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; connect-src 'self' blob: http: https:; "
                    + "img-src 'self' blob: data:; style-src 'self'; font-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'self'";

    /** What the page never asks a browser for. */
    static final String PERMISSIONS = "camera=(), geolocation=(), microphone=(), payment=(), usb=()";

    /** Nothing below {@code /m/} is a page. */
    static final String DATA_POLICY = "default-src 'none'; frame-ancestors 'none'";

    private static boolean isData(HttpServletRequest request) {
        return request.getServletPath().equals("/m");
    }

    @Override
    public void doFilter(ServletRequest request, ServletResponse response, FilterChain chain)
            throws IOException, ServletException {
        HttpServletResponse http = (HttpServletResponse) response;
        http.setHeader("X-Content-Type-Options", "nosniff");
        http.setHeader("Referrer-Policy", "no-referrer");
        if (isData((HttpServletRequest) request)) {
            http.setHeader("Content-Security-Policy", DATA_POLICY);
        } else {
            http.setHeader("Content-Security-Policy", POLICY);
            http.setHeader("Permissions-Policy", PERMISSIONS);
            http.setHeader("Cross-Origin-Opener-Policy", "same-origin");
        }
        chain.doFilter(request, response);
    }
}
