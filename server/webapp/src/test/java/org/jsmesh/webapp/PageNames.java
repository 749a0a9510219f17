package org.jsmesh.webapp;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Comparator;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Names of the page's files, which depend on what is in them. */
final class PageNames {
    private static final Pattern SCRIPT = Pattern.compile("<script type=\"module\" src=\"(viewer/[^\"]+)\"");

    private PageNames() {}

    /** The script that the page begins with. */
    static String script(byte[] page) {
        Matcher script = SCRIPT.matcher(new String(page, StandardCharsets.UTF_8));
        if (!script.find()) throw new AssertionError("the page has no script");
        return script.group(1);
    }

    static boolean exists(String path) {
        return PageNames.class.getResource("/META-INF/resources/jsm/" + path) != null;
    }

    /** A file of the page as it was built. */
    static byte[] file(String path) throws IOException {
        try (InputStream in = PageNames.class.getResourceAsStream("/META-INF/resources/jsm/" + path)) {
            if (in == null) throw new AssertionError("the page has no " + path);
            return in.readAllBytes();
        }
    }

    static String largest(String suffix) throws IOException {
        return ViewerFiles.read().entrySet().stream()
                .filter(file -> file.getKey().endsWith(suffix))
                .max(Comparator.comparing(file -> file.getValue().length))
                .map(Map.Entry::getKey)
                .orElseThrow(() -> new AssertionError("the page has no " + suffix));
    }
}
