package org.jsmesh.files;

import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.io.ByteSource;
import org.jsmesh.mesh.io.ModelFormat;
import org.jsmesh.mesh.io.ModelFormatException;
import org.jsmesh.mesh.io.ModelReader;
import org.jsmesh.mesh.io.ResourceResolver;
import org.jsmesh.mesh.io.WholeFile;
import org.jsmesh.mesh.io.zip.PackedException;
import org.jsmesh.mesh.io.zip.Unpacker;
import org.jsmesh.mesh.io.zip.ZipArchive;

/**
 * The model in a file that may be packed: by gzip, or as the one model of a ZIP archive with the files that it refers
 * to. The content tells, not the name. Nothing of an archive is unpacked but the model and what the model asks for.
 *
 * @param name of the model file, without folders
 * @param content its bytes, unpacked
 * @param companions finds the files that it refers to
 */
record PackedModel(String name, ByteSource content, ResourceResolver companions) {
    /** A gzip file may be in an archive, and an archive in a gzip file. */
    private static final int MOST_LAYERS = 2;

    /** Gzip files up to here are unpacked in memory, and only once. */
    private static final int SMALL = 1 << 20;

    private static final int START_BYTES = 32;

    /**
     * @param mostBytes that the model and its companions may have, unpacked, with all that they are unpacked from
     * @param progress may cancel while something large is unpacked to count its bytes
     */
    static PackedModel open(
            String name, ByteSource content, ResourceResolver companions, long mostBytes, ProgressListener progress)
            throws IOException {
        PackedModel model = new PackedModel(name, content, companions);
        Unpacker unpacker = new Unpacker(mostBytes);
        try {
            for (int layer = 0; layer < MOST_LAYERS; layer++) {
                byte[] start = start(model.content);
                if (Unpacker.isGzip(start)) {
                    ByteSource unpacked = model.content.length() <= SMALL
                            ? ByteSource.of(unpacker.gunzip(WholeFile.of(name, model.content)))
                            : GzipSource.of(model.content, unpacker, progress);
                    model = new PackedModel(ModelFormat.withoutGzip(model.name), unpacked, model.companions);
                } else if (ZipArchive.isZip(start) && !isModel(model)) {
                    model = inZip(name, new ZipArchive(WholeFile.of(name, model.content), unpacker));
                }
            }
        } catch (PackedException e) {
            throw new ModelFormatException(name, "", e.reason(), e.remedy());
        }
        return model;
    }

    private static byte[] start(ByteSource content) throws IOException {
        try (InputStream in = content.from(0)) {
            return in.readNBytes(START_BYTES);
        }
    }

    /** 3MF is an archive, too. */
    private static boolean isModel(PackedModel model) throws IOException {
        try {
            ModelReader.formatOf(model.name, model.content);
            return true;
        } catch (ModelFormatException e) {
            return false;
        }
    }

    private static PackedModel inZip(String archive, ZipArchive zip) throws PackedException, ModelFormatException {
        List<String> models = new ArrayList<>();
        for (String path : zip.names()) {
            String name = last(path);
            // macOS puts a file of attributes beside each file
            boolean hidden = name.startsWith(".") || path.startsWith("__MACOSX/");
            if (!hidden && ModelFormat.ofName(name) != null) models.add(path);
        }
        if (models.size() != 1) {
            String which = models.isEmpty()
                    ? ""
                    : " (" + models.get(0) + ", " + models.get(1) + (models.size() > 2 ? ", …)" : ")");
            throw new ModelFormatException(
                    archive,
                    "",
                    "the ZIP archive holds " + (models.isEmpty() ? "no" : models.size()) + " model files" + which,
                    "Pack one model with its materials and images");
        }
        String path = models.get(0);
        String folder = path.substring(0, path.length() - last(path).length());
        return new PackedModel(last(path), ByteSource.of(zip.find(path)), new ZipResources(archive, zip, folder));
    }

    private static String last(String path) {
        return path.substring(path.lastIndexOf('/') + 1);
    }
}
