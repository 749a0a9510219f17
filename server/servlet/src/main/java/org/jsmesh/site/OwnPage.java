package org.jsmesh.site;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.util.regex.Pattern;
import org.jsmesh.objects.FolderObjectStore;
import org.jsmesh.objects.ObjectStore;

/** Keeps sites of others from being overwritten. */
final class OwnPage {
    private static final String INDEX = "index.html";

    /** What the page of this project says of itself, now and before. */
    private static final Pattern MARK =
            Pattern.compile("<meta name=\"generator\" content=\"jSM\\b|src=\"viewer/page/app\\.js\"");

    private OwnPage() {}

    /**
     * Looks at what is there.
     *
     * @param start where the page is, for people
     * @throws FileSystemException when it is a page of another site
     */
    static void check(ObjectStore store, String start) throws IOException {
        try (InputStream in = store.open(INDEX)) {
            String html = new String(in.readAllBytes(), StandardCharsets.ISO_8859_1);
            if (MARK.matcher(html).find()) return;
        } catch (NoSuchFileException e) {
            return; // It is to be written.
        }
        throw new FileSystemException(
                start, null, "is a page of another site, nothing is written. Choose another " + placeOf(store));
    }

    private static String placeOf(ObjectStore store) {
        return store instanceof FolderObjectStore ? "folder" : "bucket or prefix";
    }
}
