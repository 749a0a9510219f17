package org.jsmesh.store;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.CodeSource;
import java.util.stream.Stream;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.poster.Poster;

/**
 * Names the build of the encoder, so that it does not use archives that another build kept, which may code differently.
 */
final class EncoderBuild {
    private EncoderBuild() {}

    /**
     * Changes with the jar or the class files that the encoder was loaded from; {@code unknown} where these cannot be
     * seen.
     */
    static String fingerprint() {
        return fingerprint(MeshEncoder.class) + fingerprint(Poster.class);
    }

    private static String fingerprint(Class<?> part) {
        CodeSource source = part.getProtectionDomain().getCodeSource();
        if (source == null || source.getLocation() == null) return "unknown";
        try {
            Path place = Path.of(source.getLocation().toURI());
            long sum = 0;
            try (Stream<Path> files = Files.walk(place)) {
                for (Path file : files.filter(Files::isRegularFile).toList())
                    sum += SourceStamp.of(file).hashCode();
            }
            return Long.toHexString(sum);
        } catch (IOException
                | URISyntaxException
                | IllegalArgumentException
                | java.nio.file.FileSystemNotFoundException e) {
            return "unknown";
        }
    }
}
