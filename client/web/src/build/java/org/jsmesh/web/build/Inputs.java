package org.jsmesh.web.build;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.List;

/**
 * Everything that what is served depends on, as a hash.
 *
 * @param hash of it now
 * @param memory the file that keeps the hash of the last time
 */
record Inputs(String hash, Path memory, Path result) {
    private static final List<String> SETTINGS = List.of("three.version", "esbuild.version", "brotli.version");

    static Inputs of(Layout layout) throws IOException {
        MessageDigest all = HashedFiles.sha256();
        for (Path folder : List.of(layout.sources(), layout.decoder(), program())) {
            for (Path file : Folders.files(folder)) {
                all.update((Folders.relative(folder, file) + "\n" + Files.size(file) + "\n").getBytes());
                all.update(Files.readAllBytes(file));
            }
        }
        for (String setting : SETTINGS) all.update((System.getProperty(setting) + "\n").getBytes());
        String hash = HexFormat.of().formatHex(all.digest());
        Files.createDirectories(layout.work());
        return new Inputs(hash, layout.work().resolve("inputs"), layout.output().resolve("index.html"));
    }

    private static Path program() throws IOException {
        try {
            return Path.of(PageBuild.class.getResource("PageBuild.class").toURI())
                    .getParent();
        } catch (URISyntaxException e) {
            throw new IOException(e);
        }
    }

    boolean areUnchanged() throws IOException {
        return Files.exists(result)
                && Files.exists(memory)
                && Files.readString(memory).equals(hash);
    }

    void forget() throws IOException {
        Files.deleteIfExists(memory);
    }

    void remember() throws IOException {
        Files.writeString(memory, hash);
    }
}
