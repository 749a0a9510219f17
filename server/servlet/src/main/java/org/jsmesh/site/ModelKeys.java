package org.jsmesh.site;

import java.util.List;
import org.jsmesh.files.AnnotationFile;
import org.jsmesh.files.ArchiveParts;

/** Keys of the objects of a model. */
final class ModelKeys {
    private ModelKeys() {}

    static String key(String id, String name) {
        return "m/" + id + "/" + name;
    }

    static String manifest(String id) {
        return key(id, "manifest.json");
    }

    static String page(String id) {
        return key(id, "index.html");
    }

    static String annotations(String id) {
        return key(id, AnnotationFile.NAME);
    }

    static String archive(String id, String hash, String part) {
        return key(id, hash + "/" + part);
    }

    /** What people are led to the archive by, that first. */
    static List<String> pages(String id) {
        return List.of(page(id), manifest(id), annotations(id));
    }

    /** An archive with what was cut out of it. */
    static List<String> archive(String id, String hash) {
        return List.of(
                archive(id, hash, ArchiveParts.FIRST), archive(id, hash, ArchiveParts.POSTER), key(id, hash + ".jsm"));
    }
}
