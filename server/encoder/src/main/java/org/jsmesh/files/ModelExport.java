package org.jsmesh.files;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.jsmesh.archive.ImageInfo;
import org.jsmesh.archive.OriginalWords;
import org.jsmesh.archive.Provenance;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Texture;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.mesh.io.ModelFormat;

/**
 * A resolution of an archive, or the original, on its way into a model file, and what people are told of it. The
 * command and the window take this road, so the same mesh gives the same file and the same words. Immutable.
 */
public final class ModelExport {
    private static final int MOST_NAMES = 4;

    private final Path file;
    private final ModelFormat format;

    private ModelExport(Path file, ModelFormat format) {
        this.file = file;
        this.format = format;
    }

    /**
     * Checks the name of a file; nothing is written yet.
     *
     * @param file to be written; its extension chooses the format
     * @return the export
     * @throws IllegalArgumentException when nothing is written under such a name; the message goes on after the name
     */
    public static ModelExport to(Path file) {
        String name = file.toString();
        ModelFormat format = ModelFormat.toWrite(name);
        if (format != null) return new ModelExport(file, format);
        if (ModelFormat.isGltfText(name))
            throw new IllegalArgumentException(": glTF is written in its binary form, name it .glb");
        throw new IllegalArgumentException(
                ModelFormat.ofName(name) == ModelFormat.THREE_MF
                        ? ": 3MF is read and not written, choose glb or obj"
                        : " has no known extension (ply, obj, stl, off, m, glb)");
    }

    /**
     * Writes the mesh, with its material library and its images beside it where the format has them there.
     *
     * @param mesh any resolution
     * @param up the axis of the mesh that points up
     * @return what the file does not hold, and what other programs may not find in it
     * @throws IOException when a file cannot be written
     */
    public WrittenModel write(Mesh mesh, UpAxis up) throws IOException {
        return ModelFiles.write(mesh, up, file, format);
    }

    /**
     * Says how much of its file an original is that was written.
     *
     * @param losses of the writing, a sentence each
     * @param from the file that the archive was made from, and what of it was lost then
     * @return a clause
     */
    public static String claim(List<String> losses, Provenance from) {
        boolean whole = !OriginalWords.hasWarning(from);
        String claim = (whole ? "" : "warning: ") + OriginalWords.claim(from);
        if (losses.isEmpty()) return claim;
        String written = "every face of the " + (whole ? "original" : "archive") + ", but: " + String.join(" ", losses);
        return whole ? written : written + " " + claim;
    }

    /**
     * Names the images that the file refers to and that have not come yet.
     *
     * @param mesh a resolution
     * @param images all images of the archive
     * @return a clause and a remedy; empty when none is missing
     */
    public String missing(Mesh mesh, List<ImageInfo> images) {
        if (format != ModelFormat.OBJ && format != ModelFormat.PLY && format != ModelFormat.GLB) return "";
        Set<String> known = new HashSet<>();
        for (ImageInfo image : images) known.addAll(image.paths());
        Set<String> missing = new TreeSet<>();
        for (Material material : mesh.materials())
            for (Material.TextureReference reference : material.textures()) missing.add(reference.path());
        missing.retainAll(known);
        for (Texture texture : mesh.textures()) missing.remove(texture.path());
        if (missing.isEmpty()) return "";
        boolean one = missing.size() == 1;
        String names = String.join(", ", missing.stream().limit(MOST_NAMES).toList());
        String more = missing.size() > MOST_NAMES ? " and " + (missing.size() - MOST_NAMES) + " more" : "";
        return missing.size()
                + (one ? " image that it refers to comes" : " images that it refers to come")
                + " later in the archive and " + (one ? "is" : "are") + " not written: " + names + more
                + ". Ask for a finer resolution to get " + (one ? "it." : "them.");
    }
}
