package org.jsmesh.desktop;

import java.io.File;
import java.io.IOException;
import java.io.Reader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Properties;
import java.util.TreeSet;
import java.util.stream.Stream;

/**
 * Javas of this machine besides the one that runs the tests: those that the system property {@code jsm.test.javas}
 * names (folders with what separates paths between them), else those beside it.
 */
final class OtherJavas {
    private static final int OLDEST = 17;

    private OtherJavas() {}

    static List<Path> homes() throws IOException {
        Path own = Path.of(System.getProperty("java.home")).toRealPath();
        TreeSet<Path> homes = new TreeSet<>();
        for (Path home : candidates(own)) {
            if (Files.isExecutable(Path.of(StartedViewer.java(home))) && version(home) >= OLDEST)
                homes.add(home.toRealPath());
        }
        homes.remove(own);
        return new ArrayList<>(homes);
    }

    private static List<Path> candidates(Path own) throws IOException {
        String named = System.getProperty("jsm.test.javas", "");
        if (!named.isBlank())
            return Stream.of(named.split(File.pathSeparator)).map(Path::of).toList();
        try (Stream<Path> beside = Files.list(own.getParent())) {
            return beside.toList();
        }
    }

    private static int version(Path home) throws IOException {
        Path file = home.resolve("release");
        if (!Files.isRegularFile(file)) return 0;
        Properties release = new Properties();
        try (Reader in = Files.newBufferedReader(file)) {
            release.load(in);
        }
        String version = release.getProperty("JAVA_VERSION", "0").replaceAll("^\"|[^0-9\"].*$|\"$", "");
        return Integer.parseInt(version);
    }
}
