package org.jsmesh.servlet;

import jakarta.servlet.ServletOutputStream;
import java.nio.ByteBuffer;
import java.security.CodeSource;

/** Tells containers apart by what they lack, at start rather than in the middle of an answer. */
final class ServletVersion {
    private ServletVersion() {}

    /** @throws IllegalStateException when the container's classes are older than Servlet 6.1 */
    static void require() {
        try {
            // What answers are sent by, and what Servlet 6.0 has not.
            ServletOutputStream.class.getMethod("write", ByteBuffer.class);
        } catch (NoSuchMethodException e) {
            CodeSource source = ServletOutputStream.class.getProtectionDomain().getCodeSource();
            String place = source == null ? "this container" : String.valueOf(source.getLocation());
            throw new IllegalStateException(
                    place + " is older than Jakarta Servlet 6.1: it has no ServletOutputStream.write(ByteBuffer). "
                            + "Run jSM on Jetty 12.1 (ee11), Tomcat 11 or Spring Boot 4, or newer ones.",
                    e);
        }
    }
}
