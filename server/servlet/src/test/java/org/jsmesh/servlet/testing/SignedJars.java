package org.jsmesh.servlet.testing;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.util.Map;
import java.util.Random;
import java.util.jar.Attributes;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import jdk.security.jarsigner.JarSigner;

/** Small jars like the desktop viewer, signed by a key that is made for the test. */
public final class SignedJars {
    private static final String PASSWORD = "for the test";
    private static final String ALIAS = "test";

    private SignedJars() {}

    /**
     * A jar that is not signed.
     *
     * @param attributes of its manifest
     * @param length of the data in it
     */
    public static Path unsigned(Path file, Map<String, String> attributes, int length) throws IOException {
        Manifest manifest = new Manifest();
        manifest.getMainAttributes().put(Attributes.Name.MANIFEST_VERSION, "1.0");
        attributes.forEach(manifest.getMainAttributes()::putValue);
        try (JarOutputStream jar = new JarOutputStream(Files.newOutputStream(file), manifest)) {
            jar.putNextEntry(new ZipEntry("org/example/Main.class"));
            jar.write(new byte[] {1, 2, 3});
            jar.closeEntry();
            jar.putNextEntry(new ZipEntry("data"));
            byte[] data = new byte[length];
            // What no packing makes smaller.
            new Random(length).nextBytes(data);
            jar.write(data);
            jar.closeEntry();
        }
        return file;
    }

    /** A jar that can be started. */
    public static Path viewer(Path file, int length) throws Exception {
        Path plain = file.resolveSibling(file.getFileName() + ".plain");
        return signed(
                unsigned(plain, Map.of("Main-Class", "org.example.Main", "Permissions", "all-permissions"), length),
                file);
    }

    /** The same jar, signed. */
    public static Path signed(Path plain, Path file)
            throws IOException, InterruptedException, GeneralSecurityException {
        Path keys = file.resolveSibling(file.getFileName() + ".p12");
        Process keytool = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "keytool")
                                .toString(),
                        "-genkeypair",
                        "-keyalg",
                        "EC",
                        "-alias",
                        ALIAS,
                        "-dname",
                        "CN=jSM test",
                        "-storetype",
                        "PKCS12",
                        "-keystore",
                        keys.toString(),
                        "-storepass",
                        PASSWORD)
                .redirectErrorStream(true)
                .start();
        String said = new String(keytool.getInputStream().readAllBytes());
        if (keytool.waitFor() != 0) throw new IOException(said);
        KeyStore store = KeyStore.getInstance(keys.toFile(), PASSWORD.toCharArray());
        KeyStore.PrivateKeyEntry key = (KeyStore.PrivateKeyEntry)
                store.getEntry(ALIAS, new KeyStore.PasswordProtection(PASSWORD.toCharArray()));
        try (ZipFile from = new ZipFile(plain.toFile());
                OutputStream to = Files.newOutputStream(file)) {
            new JarSigner.Builder(key).build().sign(from, to);
        }
        return file;
    }
}
