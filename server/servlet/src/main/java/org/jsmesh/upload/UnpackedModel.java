package org.jsmesh.upload;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.ZipEntry;
import java.util.zip.ZipException;
import java.util.zip.ZipInputStream;
import org.jsmesh.mesh.io.ModelFormat;

/**
 * A model that came as a ZIP archive with its materials and images. Names in the archive are not trusted, and its size
 * counts only as it is unpacked.
 */
final class UnpackedModel {
    private static final int MOST_FILES = 1000;
    private static final int MOST_FOLDERS_DEEP = 16;

    /** Length of a name that file systems accept. */
    private static final int LONGEST_NAME_BYTES = 255;

    private static final int LONGEST_PATH_BYTES = 1000;

    private UnpackedModel() {}

    /**
     * Unpacks beside the archive.
     *
     * @return the one model file
     * @throws UploadFailure when it is no such archive
     */
    static Path of(Path zip, Path place, long mostBytes) throws UploadFailure, IOException {
        // Names are compared with this path, which must not have dots of its own.
        Path folder = place.toAbsolutePath().normalize();
        List<Path> models = new ArrayList<>();
        long bytes = 0;
        int files = 0;
        Ticket.delete(folder);
        Files.createDirectories(folder);
        try (InputStream in = Files.newInputStream(zip);
                ZipInputStream entries = new ZipInputStream(in)) {
            for (ZipEntry entry = entries.getNextEntry(); entry != null; entry = entries.getNextEntry()) {
                if (++files > MOST_FILES)
                    throw new UploadFailure("the ZIP archive holds more than " + MOST_FILES + " files", "send fewer");
                if (entry.isDirectory()) {
                    // Folders have no bytes, but an entry that claims to be one may unpack to any number.
                    bytes += copy(entries, OutputStream.nullOutputStream(), mostBytes - bytes);
                    continue;
                }
                Path file = place(folder, entry.getName());
                makeFolders(folder, file);
                bytes += write(entries, file, mostBytes - bytes);
                String name = String.valueOf(file.getFileName());
                if (!name.startsWith(".") && ModelFormat.ofName(name) != null) models.add(file);
            }
        } catch (ZipException | IllegalArgumentException e) {
            throw new UploadFailure("the ZIP archive is damaged", "pack it again");
        } catch (EOFException e) {
            throw new UploadFailure("the ZIP archive is cut off", "send it again");
        }
        if (files == 0) throw new UploadFailure("the file is no ZIP archive", "send a ZIP archive, or the model alone");
        if (models.size() != 1) {
            throw new UploadFailure(
                    "the ZIP archive holds " + models.size() + " model files",
                    "pack one model with its materials and images");
        }
        return models.get(0);
    }

    private static int bytes(String name) {
        return name.getBytes(StandardCharsets.UTF_8).length;
    }

    private static Path place(Path folder, String name) throws UploadFailure {
        String unified = name.replace('\\', '/');
        boolean tooLong = bytes(unified) > LONGEST_PATH_BYTES;
        for (String part : unified.split("/")) tooLong |= bytes(part) > LONGEST_NAME_BYTES;
        if (tooLong) throw new UploadFailure("a name in the ZIP archive is too long", "pack it with shorter names");
        try {
            Path file = folder.resolve(unified).normalize();
            if (file.getNameCount() - folder.getNameCount() > MOST_FOLDERS_DEEP)
                throw new UploadFailure("the ZIP archive's folders are nested too deep", "pack it with fewer folders");
            if (!unified.startsWith("/") && file.startsWith(folder) && !file.equals(folder)) return file;
        } catch (InvalidPathException e) {
            // Told below.
        }
        throw new UploadFailure("a name in the ZIP archive leads out of it", "pack it with relative names");
    }

    private static void makeFolders(Path folder, Path file) throws UploadFailure, IOException {
        boolean clash = Files.isDirectory(file);
        for (Path up = file.getParent(); up != null && !up.equals(folder); up = up.getParent()) {
            clash |= Files.isRegularFile(up);
        }
        if (clash) {
            throw new UploadFailure(
                    "the ZIP archive holds a file and a folder of one name", "pack it with different names");
        }
        Path parent = file.getParent();
        if (parent != null) Files.createDirectories(parent);
    }

    private static long write(InputStream in, Path file, long mostBytes) throws UploadFailure, IOException {
        try (OutputStream out = Files.newOutputStream(file)) {
            return copy(in, out, mostBytes);
        }
    }

    private static long copy(InputStream in, OutputStream out, long mostBytes) throws UploadFailure, IOException {
        long bytes = 0;
        byte[] block = new byte[1 << 16];
        for (int count = in.read(block); count >= 0; count = in.read(block)) {
            bytes += count;
            if (bytes > mostBytes)
                throw new UploadFailure("the ZIP archive unpacks to more bytes than allowed", "send a smaller model");
            out.write(block, 0, count);
        }
        return bytes;
    }
}
