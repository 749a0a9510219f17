package org.jsmesh.web.compile;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Modifier;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class BrowserWaysTest {
    /** A way to a method that is not there would be passed by in silence. */
    @ParameterizedTest
    @ValueSource(strings = {"merge", "insert"})
    void shouldNameMethodsThatAreThere(String method) throws ReflectiveOperationException {
        Class<?> sort = Class.forName("org.jsmesh.codec.position.SmallSort");
        assertThat(Modifier.isStatic(
                        sort.getDeclaredMethod(method, int[].class, int.class).getModifiers()))
                .isTrue();
    }
}
