package org.jsmesh.mesh.io.threemf;

import java.util.ArrayDeque;
import java.util.Deque;

/** Paths of parts (Open Packaging Conventions): absolute within the package, or relative to the part that has them. */
final class PackagePaths {
    private PackagePaths() {}

    /** The path without a {@code /} in front, as ZIP has it. Never leads out of the package. */
    static String absolute(String part, String path) {
        String unified = path.replace('\\', '/').strip();
        String whole = unified.startsWith("/") ? unified : part.substring(0, part.lastIndexOf('/') + 1) + unified;
        Deque<String> parts = new ArrayDeque<>();
        for (String name : whole.split("/")) {
            if (name.equals("..")) parts.pollLast();
            else if (!name.isEmpty() && !name.equals(".")) parts.addLast(name);
        }
        return String.join("/", parts);
    }
}
