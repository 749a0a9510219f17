package org.jsmesh.webapp;

import java.io.IOException;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Stream;

/** The page and the viewer's files as the class path has them, for a host that sets no headers. */
public final class ViewerFiles {
    private static final String FOLDER = "META-INF/resources/jsm";
    private static final String CHARSET = "<meta charset=\"utf-8\">";

    private ViewerFiles() {}

    /** The files by their paths relative to the site, which have slashes; the page guards itself. */
    public static SortedMap<String, byte[]> read() throws IOException {
        URL page = ViewerFiles.class.getClassLoader().getResource(FOLDER + "/index.html");
        if (page == null) throw new IOException("the viewer's files are missing from this program; install it again");
        try {
            URI place = page.toURI();
            if (!place.getScheme().equals("jar")) {
                Path file = Path.of(place);
                return collect(file.resolveSibling("."));
            }
            Path jar = Path.of(URI.create(place.getRawSchemeSpecificPart().replaceFirst("!/.*$", "")));
            try (FileSystem zip = FileSystems.newFileSystem(jar, Map.of())) {
                return collect(zip.getPath(FOLDER));
            }
        } catch (URISyntaxException e) {
            throw new IOException(e);
        }
    }

    private static SortedMap<String, byte[]> collect(Path resources) throws IOException {
        SortedMap<String, byte[]> files = new TreeMap<>();
        List<Path> viewer;
        try (Stream<Path> walk = Files.walk(resources.resolve("viewer"))) {
            viewer = walk.filter(Files::isRegularFile).toList();
        }
        for (Path file : viewer) {
            String name = resources.relativize(file).toString().replace('\\', '/');
            files.put(name, Files.readAllBytes(file));
        }
        String page = Files.readString(resources.resolve("index.html"));
        files.put("index.html", guarded(page).getBytes(StandardCharsets.UTF_8));
        return files;
    }

    /** The policy that the servlet sends as a header. */
    private static String guarded(String page) {
        String guard = "<meta http-equiv=\"Content-Security-Policy\" content=\"" + SecurityHeaders.POLICY + "\">";
        if (!page.contains(CHARSET)) throw new IllegalStateException("the page has no " + CHARSET);
        return page.replace(CHARSET, CHARSET + "\n    " + guard);
    }
}
