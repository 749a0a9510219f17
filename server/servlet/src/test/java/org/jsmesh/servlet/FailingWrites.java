package org.jsmesh.servlet;

import jakarta.servlet.DispatcherType;
import jakarta.servlet.Filter;
import jakarta.servlet.FilterChain;
import jakarta.servlet.FilterRegistration;
import jakarta.servlet.ServletContext;
import jakarta.servlet.ServletException;
import jakarta.servlet.ServletOutputStream;
import jakarta.servlet.ServletRequest;
import jakarta.servlet.ServletResponse;
import jakarta.servlet.WriteListener;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import jakarta.servlet.http.HttpServletResponseWrapper;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.EnumSet;

/** Lets an answer fail in its middle, when the request asks for that. */
final class FailingWrites implements Filter {
    /** Names the number of writes that succeed. */
    static final String FIELD = "X-Test-Writes";

    static void install(ServletContext context) {
        FilterRegistration.Dynamic filter = context.addFilter("test-failing-writes", new FailingWrites());
        filter.setAsyncSupported(true);
        filter.addMappingForUrlPatterns(EnumSet.of(DispatcherType.REQUEST), false, "/*");
    }

    @Override
    public void doFilter(ServletRequest request, ServletResponse response, FilterChain chain)
            throws IOException, ServletException {
        String writes = ((HttpServletRequest) request).getHeader(FIELD);
        chain.doFilter(
                request,
                writes == null ? response : new Failing((HttpServletResponse) response, Integer.parseInt(writes)));
    }

    private static final class Failing extends HttpServletResponseWrapper {
        private final int writes;

        Failing(HttpServletResponse response, int writes) {
            super(response);
            this.writes = writes;
        }

        @Override
        public ServletOutputStream getOutputStream() throws IOException {
            return new FailingStream(super.getOutputStream(), writes);
        }
    }

    private static final class FailingStream extends ServletOutputStream {
        private final ServletOutputStream out;
        private int left;

        FailingStream(ServletOutputStream out, int left) {
            this.out = out;
            this.left = left;
        }

        @Override
        public boolean isReady() {
            return out.isReady();
        }

        @Override
        public void setWriteListener(WriteListener listener) {
            out.setWriteListener(listener);
        }

        @Override
        public void write(int value) throws IOException {
            out.write(value);
        }

        @Override
        public void write(ByteBuffer buffer) throws IOException {
            if (left-- == 0) throw new IOException("a failure for this test");
            out.write(buffer);
        }
    }
}
