package org.jsmesh.web.build;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Which source of three.js has each of the things that it exports. */
final class ThreeExports {
    private static final Pattern ALL = Pattern.compile("export \\* from '([^']+)'");
    private static final Pattern LISTED = Pattern.compile("export \\{([^}]*)\\}(?: from '([^']+)')?");
    private static final Pattern DECLARED = Pattern.compile("(?m)^export (?:const|let|class|function) (\\w+)");

    /** @param name in the source */
    record Export(String name, Path source) {}

    private final Map<String, Export> exports = new TreeMap<>();

    /** @param entry the source that exports all */
    ThreeExports(Path entry) throws IOException {
        collect(entry);
    }

    /** Null when three exports no such thing, or a mere type. */
    Export find(String name) {
        return exports.get(name);
    }

    private void collect(Path source) throws IOException {
        String text = Files.readString(source);
        for (Matcher all = ALL.matcher(text); all.find(); ) collect(resolve(source, all.group(1)));
        for (Matcher list = LISTED.matcher(text); list.find(); ) {
            Path from = list.group(2) == null ? source : resolve(source, list.group(2));
            for (String item : list.group(1).split(",")) {
                String[] names = item.strip().split("\\s+as\\s+");
                if (!names[0].isEmpty()) exports.put(names[names.length - 1], new Export(names[0], from));
            }
        }
        for (Matcher one = DECLARED.matcher(text); one.find(); ) {
            exports.put(one.group(1), new Export(one.group(1), source));
        }
    }

    private static Path resolve(Path source, String path) {
        return source.resolveSibling(path).normalize();
    }
}
