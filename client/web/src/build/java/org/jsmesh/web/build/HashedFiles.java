package org.jsmesh.web.build;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Map;
import java.util.TreeMap;

/** The files that are served, each named {@code NAME-HASH.TYPE} after its content. */
final class HashedFiles {
    private static final String DIGITS = "ABCDEFGHIJKLMNOPQRSTUVWXYZ234567";
    private static final int LENGTH = 8;

    private final Path folder;
    private final Esbuild esbuild;
    private final Map<Path, String> copies = new TreeMap<>();

    HashedFiles(Path folder, Esbuild esbuild) {
        this.folder = folder;
        this.esbuild = esbuild;
    }

    /** Serves a file as it is, and gives its name. */
    String copy(Path file) throws IOException {
        String known = copies.get(file);
        if (known != null) return known;
        byte[] content = Files.readAllBytes(file);
        String name = file.getFileName().toString();
        int dot = name.lastIndexOf('.');
        String hashed = name.substring(0, dot) + "-" + hash(content) + name.substring(dot);
        Files.write(folder.resolve(hashed), content);
        copies.put(file, hashed);
        return hashed;
    }

    /** Serves a script or style sheet with all that it imports. */
    Bundle bundle(Path entry) throws IOException {
        return esbuild.bundle(entry, folder);
    }

    /** What the files of a page share that one of them imports at once. */
    SharedModules shared(Path entry, String later) throws IOException {
        return esbuild.shared(entry, later);
    }

    /** As esbuild writes its own: eight digits to the base of 32. */
    private static String hash(byte[] content) {
        byte[] digest = sha256().digest(content);
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < LENGTH; i++) text.append(DIGITS.charAt(digest[i] & 31));
        return text.toString();
    }

    static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }
}
