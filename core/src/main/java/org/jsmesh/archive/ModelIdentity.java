package org.jsmesh.archive;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.jsmesh.mesh.Sha256;
import org.jsmesh.mesh.Utf8;

/** The identity of a mesh together with its images; the bytes are specified in {@code docs/format.md}. */
final class ModelIdentity {
    private ModelIdentity() {}

    /** An image under one of its paths. */
    private record Named(String path, String sha256) {}

    /** The images may come in any order, and one with several paths as one or as several. */
    static String sha256(String meshSha256, List<ImageInfo> images) {
        List<Named> sorted = new ArrayList<>();
        for (ImageInfo image : images) for (String path : image.paths()) sorted.add(new Named(path, image.sha256()));
        sorted.sort(Comparator.comparing(Named::path).thenComparing(Named::sha256));
        StringBuilder text = new StringBuilder("mesh ").append(meshSha256).append('\n');
        for (Named image : sorted) {
            int length = Utf8.bytes(image.path()).length; // a path may have line ends
            text.append("image ").append(image.sha256()).append(' ').append(length);
            text.append(' ').append(image.path()).append('\n');
        }
        return Sha256.hex(Utf8.bytes(text.toString()));
    }
}
