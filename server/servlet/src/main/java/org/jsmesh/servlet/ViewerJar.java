package org.jsmesh.servlet;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.jar.Attributes;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.jar.Manifest;
import java.util.zip.ZipException;

/**
 * The desktop viewer as one signed jar, which visitors start from the browser: {@code jsm-viewer.jar}. Programs that
 * start it by JNLP run nothing unsigned, so a jar without a signature is refused here. A file that is replaced is
 * looked at again when somebody asks for it; replace it by renaming, so that nobody gets halves of two. Thread-safe.
 */
public final class ViewerJar {
    private static final Logger LOG = System.getLogger(ViewerJar.class.getName());
    private static final String REMEDY = "; sign it with jarsigner, or take the signed jsm-viewer.jar of the build";
    private static final int BLOCK_BYTES = 1 << 16;

    private final Path file;
    private Stamp stamp;
    private State state;

    /**
     * What the file was when it was looked at last.
     *
     * @param mainClass that starts the viewer
     * @param sha256 of the bytes, 64 hexadecimal digits
     * @param bytes how many there are
     */
    record State(String mainClass, String sha256, long bytes) {}

    private record Stamp(long millis, long bytes, Object key) {}

    private ViewerJar(Path file) throws IOException {
        this.file = file;
        stamp = stamp();
        state = read();
    }

    /**
     * Looks at the file, which must be a viewer that can be started.
     *
     * @param file a jar with a main class, signed by one key
     * @return the jar, which need not be closed
     * @throws IOException that says what is wrong with the file and what to do, or when it cannot be read
     */
    public static ViewerJar open(Path file) throws IOException {
        return new ViewerJar(file);
    }

    Path file() {
        return file;
    }

    /** What the file is now; null while it is gone or can no longer be started, which the log says once. */
    synchronized State state() {
        Stamp before = stamp;
        try {
            stamp = stamp();
            if (stamp.equals(before)) return state;
            state = read();
        } catch (IOException e) {
            if (state != null) LOG.log(Level.ERROR, "The desktop viewer is not offered any more: {0}", e.getMessage());
            state = null;
        }
        return state;
    }

    private Stamp stamp() throws IOException {
        if (!Files.isRegularFile(file)) throw refused("there is no such file");
        BasicFileAttributes now = Files.readAttributes(file, BasicFileAttributes.class);
        return new Stamp(now.lastModifiedTime().toMillis(), now.size(), now.fileKey());
    }

    private State read() throws IOException {
        String mainClass;
        try (JarFile jar = new JarFile(file.toFile())) {
            Manifest manifest = jar.getManifest();
            Attributes attributes = manifest == null ? new Attributes() : manifest.getMainAttributes();
            mainClass = attributes.getValue(Attributes.Name.MAIN_CLASS);
            if (mainClass == null) throw refused("its manifest names no Main-Class");
            requireSignature(jar, mainClass.replace('.', '/') + ".class");
            if (!"all-permissions".equals(attributes.getValue("Permissions")))
                throw refused("its manifest does not say 'Permissions: all-permissions'");
        } catch (ZipException e) {
            throw refused("it is no jar");
        } catch (SecurityException e) {
            throw refused("it has been changed since it was signed");
        }
        return new State(mainClass, digest(), Files.size(file));
    }

    private void requireSignature(JarFile jar, String name) throws IOException {
        JarEntry entry = jar.getJarEntry(name);
        if (entry == null) throw refused("it lacks its main class " + name);
        try (InputStream in = jar.getInputStream(entry)) {
            // Who signed it is known only when all of it has been read.
            in.transferTo(OutputStream.nullOutputStream());
        }
        if (entry.getCodeSigners() == null) throw refused("it is not signed" + REMEDY);
    }

    private FileSystemException refused(String why) {
        return new FileSystemException(
                file.toString(), null, "the desktop viewer cannot be started from there: " + why);
    }

    private String digest() throws IOException {
        try (InputStream in = Files.newInputStream(file)) {
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            byte[] block = new byte[BLOCK_BYTES];
            for (int read = in.read(block); read >= 0; read = in.read(block)) digest.update(block, 0, read);
            return HexFormat.of().formatHex(digest.digest());
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }
}
