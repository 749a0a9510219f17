package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.File;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.function.UnaryOperator;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * A Tomcat of Servlet 6.0, whose jars the build lays into {@code target/servlet-6.0}, in a class loader of its own. It
 * finds everything that the tests find but their containers.
 */
class OldContainerTest {
    private static final Pattern CONTAINERS = Pattern.compile("tomcat|jetty|servlet-api|spring");

    @TempDir
    private Path folder;

    @Test
    void shouldRefuseToStart() throws Exception {
        try (URLClassLoader old = loader()) {
            Object host = old.loadClass(OldContainerHost.class.getName())
                    .getConstructor()
                    .newInstance();
            assertThat(((Callable<?>) host).call().toString()).startsWith("Apache Tomcat/10.1.");
            @SuppressWarnings("unchecked")
            UnaryOperator<Path> start = (UnaryOperator<Path>) host;
            assertThatThrownBy(() -> start.apply(folder))
                    .hasRootCauseInstanceOf(NoSuchMethodException.class)
                    .hasStackTraceContaining("tomcat-embed-core.jar is older than Jakarta Servlet 6.1")
                    .hasStackTraceContaining("Jetty 12.1 (ee11), Tomcat 11 or Spring Boot 4");
        }
    }

    private static URLClassLoader loader() throws Exception {
        List<URL> places = new ArrayList<>();
        try (Stream<Path> jars = Files.list(Path.of("target/servlet-6.0"))) {
            for (Path jar : jars.sorted().toList()) places.add(jar.toUri().toURL());
        }
        for (String part : System.getProperty("java.class.path").split(Pattern.quote(File.pathSeparator))) {
            Path place = Path.of(part);
            boolean isContainer =
                    CONTAINERS.matcher(String.valueOf(place.getFileName())).find();
            if (!isContainer || Files.isDirectory(place))
                places.add(place.toUri().toURL());
        }
        return new URLClassLoader(places.toArray(URL[]::new), ClassLoader.getPlatformClassLoader());
    }
}
