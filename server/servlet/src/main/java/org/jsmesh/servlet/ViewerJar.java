package org.jsmesh.servlet;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Collections;
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
    private static final String BUILT = "take the signed jsm-viewer.jar of the build";
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
     * @param content these bytes, whatever has the name of the file by now
     */
    record State(String mainClass, String sha256, long bytes, SharedFile content) {}

    private record Stamp(long millis, long bytes, Object key) {}

    private ViewerJar(Path file) throws IOException {
        this.file = file;
        stamp = stamp();
        state = read(stamp);
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

    /** What the file is now; null while it is gone or can no longer be started, which the log says once. */
    synchronized State state() {
        State before = state;
        try {
            Stamp now = stamp();
            if (now.equals(stamp)) return state;
            state = null;
            stamp = null;
            state = read(now);
            stamp = now;
        } catch (Refusal e) {
            state = null;
            stamp = e.stamp;
            if (before != null) lost(e);
        } catch (IOException e) {
            // The next who asks has it looked at again.
            state = null;
            stamp = null;
            if (before != null) lost(e);
        }
        if (before != null) before.content().giveUp();
        return state;
    }

    private static void lost(IOException e) {
        LOG.log(Level.ERROR, "The desktop viewer is not offered any more: {0}", e.getMessage());
    }

    private Stamp stamp() throws IOException {
        if (!Files.isRegularFile(file)) throw refused("there is no such file; name the signed jar", null);
        BasicFileAttributes now = Files.readAttributes(file, BasicFileAttributes.class);
        return new Stamp(now.lastModifiedTime().toMillis(), now.size(), now.fileKey());
    }

    private State read(Stamp now) throws IOException {
        SharedFile content = SharedFile.open(file);
        boolean isGood = false;
        try {
            String mainClass = mainClass(now);
            String sha256 = digest(content.channel());
            if (!stamp().equals(now)) throw new IOException(file + " changes while it is read; replace it by renaming");
            isGood = true;
            return new State(mainClass, sha256, now.bytes(), content);
        } finally {
            if (!isGood) content.giveUp();
        }
    }

    private String mainClass(Stamp now) throws IOException {
        try (JarFile jar = new JarFile(file.toFile())) {
            Manifest manifest = jar.getManifest();
            Attributes attributes = manifest == null ? new Attributes() : manifest.getMainAttributes();
            String mainClass = attributes.getValue(Attributes.Name.MAIN_CLASS);
            if (mainClass == null) throw refused("its manifest names no Main-Class; " + BUILT, now);
            if (jar.getJarEntry(mainClass.replace('.', '/') + ".class") == null)
                throw refused("it lacks its main class " + mainClass + "; " + BUILT, now);
            if (!isSigned(jar)) throw refused("not all of it is signed; sign it with jarsigner, or " + BUILT, now);
            if (!"all-permissions".equals(attributes.getValue("Permissions")))
                throw refused("its manifest does not say 'Permissions: all-permissions'; " + BUILT, now);
            return mainClass;
        } catch (ZipException e) {
            throw refused("it is no jar; " + BUILT, now);
        } catch (SecurityException e) {
            throw refused("it has been changed since it was signed; sign it again, or " + BUILT, now);
        }
    }

    /** Programs that start it refuse a jar of which anything but the signature itself is unsigned. */
    private static boolean isSigned(JarFile jar) throws IOException {
        for (JarEntry entry : Collections.list(jar.entries())) {
            if (entry.isDirectory() || entry.getName().startsWith("META-INF/")) continue;
            try (InputStream in = jar.getInputStream(entry)) {
                // Who signed it is known only when all of it has been read.
                in.transferTo(OutputStream.nullOutputStream());
            }
            if (entry.getCodeSigners() == null) return false;
        }
        return true;
    }

    private Refusal refused(String why, Stamp now) {
        return new Refusal(file, "the desktop viewer cannot be started from there: " + why, now);
    }

    /** What the file is will not change unless the file does. */
    private static final class Refusal extends FileSystemException {
        private static final long serialVersionUID = 1L;

        private final transient Stamp stamp;

        Refusal(Path file, String reason, Stamp stamp) {
            super(file.toString(), null, reason);
            this.stamp = stamp;
        }
    }

    private static String digest(FileChannel channel) throws IOException {
        try {
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            ByteBuffer block = ByteBuffer.allocate(BLOCK_BYTES);
            for (long at = 0; channel.read(block.clear(), at) > 0; at += block.limit()) digest.update(block.flip());
            return HexFormat.of().formatHex(digest.digest());
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }
}
