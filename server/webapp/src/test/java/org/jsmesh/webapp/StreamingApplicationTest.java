package org.jsmesh.webapp;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import jakarta.servlet.ServletContext;
import jakarta.servlet.ServletContextEvent;
import java.io.UncheckedIOException;
import java.lang.reflect.Proxy;
import org.junit.jupiter.api.Test;

class StreamingApplicationTest {
    /** A context of these parameters alone. */
    private static ServletContext context(String models) {
        Class<?>[] types = {ServletContext.class};
        return (ServletContext) Proxy.newProxyInstance(
                StreamingApplicationTest.class.getClassLoader(), types, (context, method, args) -> {
                    if (!method.getName().equals("getInitParameter"))
                        throw new UnsupportedOperationException(method.getName());
                    return args[0].equals("jsm.models") ? models : null;
                });
    }

    @Test
    void shouldCloseTheStoreOfASiteThatItCannotServe() {
        int before = EmptyStores.CLOSED.get();
        StreamingApplication application = new StreamingApplication();
        ServletContextEvent event = new ServletContextEvent(context("empty://bucket/site"));
        assertThatThrownBy(() -> application.contextInitialized(event))
                .isInstanceOf(UncheckedIOException.class)
                .hasStackTraceContaining("holds no site");
        assertThat(EmptyStores.OPENED.get()).isPositive();
        assertThat(EmptyStores.CLOSED.get()).isEqualTo(before + 1);
    }
}
