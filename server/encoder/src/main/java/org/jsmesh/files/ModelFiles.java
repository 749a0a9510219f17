package org.jsmesh.files;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.files.gltf.GltfReader;
import org.jsmesh.files.gltf.write.GltfWriter;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.Sizes;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.mesh.io.ByteSource;
import org.jsmesh.mesh.io.ModelFile;
import org.jsmesh.mesh.io.ModelFormat;
import org.jsmesh.mesh.io.ModelFormatException;
import org.jsmesh.mesh.io.ModelReader;
import org.jsmesh.mesh.io.ModelWriter;
import org.jsmesh.mesh.io.ResourceResolver;
import org.jsmesh.mesh.io.WholeFile;

/** Model files of all formats on disk, with the material libraries and images beside them. */
public final class ModelFiles {
    /** No limit of what a packed model may unpack to but that of what unpacks it. */
    static final long ANY_BYTES = Long.MAX_VALUE;

    private ModelFiles() {}

    /**
     * Reads a model file. Its content tells its format, and whether it is packed: by gzip, or as the one model of a ZIP
     * archive. Files that it refers to are looked for only in its folder and below, or in its archive.
     *
     * @param file its path
     * @return the mesh, its format, and what was changed or skipped
     * @throws ModelFormatException when it is no model or a damaged one
     * @throws IOException when it cannot be read
     */
    public static ModelFile read(Path file) throws IOException {
        return read(file, new ModelInputs(), ANY_BYTES, Integer.MAX_VALUE, ProgressListener.NONE);
    }

    /**
     * @param inputs are told of every byte that is read
     * @param mostBytes of a packed model and its companions, unpacked
     * @param mostFaces of a model whose faces are counted before they take memory
     * @param progress may cancel
     */
    static ModelFile read(Path file, ModelInputs inputs, long mostBytes, int mostFaces, ProgressListener progress)
            throws IOException {
        String name = fileName(file);
        ResourceResolver companions = inputs.noting(new FolderResources(folder(file)));
        if (!FileSource.isFor(file)) {
            byte[] content = bytes(file);
            inputs.model(content);
            return read(name, ByteSource.of(content), companions, mostBytes, mostFaces, progress);
        }
        HashedSource content = new HashedSource(FileSource.of(file));
        ModelFile model = read(name, content, companions, mostBytes, mostFaces, progress);
        inputs.model(content.sha256());
        return model;
    }

    /**
     * Reads the bytes of a model file. They tell its format, and whether it is packed.
     *
     * @param name of the file, for messages, and as a hint where the content leaves the format open
     * @param content the whole file
     * @param companions finds the files that it refers to
     * @return the mesh, its format, and what was changed or skipped
     * @throws ModelFormatException when it is no model or a damaged one
     * @throws IOException when a companion cannot be read
     */
    public static ModelFile read(String name, byte[] content, ResourceResolver companions) throws IOException {
        return read(name, ByteSource.of(content), companions);
    }

    /**
     * Reads a model file that need not be in memory. Of a PLY, OBJ or STL file, packed by gzip or not, only a small
     * part is in memory at a time, and it may have any size; others are read into memory.
     *
     * @param name of the file, for messages, and as a hint where the content leaves the format open
     * @param content the whole file
     * @param companions finds the files that it refers to
     * @return the mesh, its format, and what was changed or skipped
     * @throws ModelFormatException when it is no model or a damaged one
     * @throws IOException when the content or a companion cannot be read
     */
    public static ModelFile read(String name, ByteSource content, ResourceResolver companions) throws IOException {
        return read(name, content, companions, ANY_BYTES, Integer.MAX_VALUE, ProgressListener.NONE);
    }

    /**
     * @param mostBytes of a packed model and its companions, unpacked
     * @param mostFaces of a model whose faces are counted before they take memory
     * @param progress may cancel
     */
    static ModelFile read(
            String name,
            ByteSource content,
            ResourceResolver companions,
            long mostBytes,
            int mostFaces,
            ProgressListener progress)
            throws IOException {
        PackedModel model = PackedModel.open(name, content, companions, mostBytes, progress);
        boolean gltf = ModelReader.formatOf(model.name(), model.content()) == ModelFormat.GLB;
        return gltf
                ? GltfReader.read(
                        model.name(), WholeFile.of(model.name(), model.content()), model.companions(), mostFaces)
                : ModelReader.read(model.name(), model.content(), model.companions());
    }

    /**
     * Writes a mesh as a model file, with its material library and textures beside it.
     *
     * @param mesh any mesh
     * @param file its path
     * @param format to write, whatever the name of the file promises
     * @return what the file does not hold
     * @throws IOException when a file cannot be written or is no regular file, or a texture's name is taken by a file
     *     with other content
     */
    public static WrittenModel write(Mesh mesh, Path file, ModelFormat format) throws IOException {
        return write(mesh, UpAxis.UNKNOWN, file, format);
    }

    /**
     * Writes a mesh whose axis that points up is known. In glTF y points up: there a node turns a mesh with another
     * axis; its coordinates stay. The other formats do not say.
     *
     * @param mesh any mesh
     * @param up the axis of the mesh that points up
     * @param file its path
     * @param format to write, whatever the name of the file promises
     * @return what the file does not hold
     * @throws IOException when a file cannot be written or is no regular file, or a texture's name is taken by a file
     *     with other content
     */
    public static WrittenModel write(Mesh mesh, UpAxis up, Path file, ModelFormat format) throws IOException {
        String name = fileName(file);
        List<String> remarks = new ArrayList<>();
        try (FolderSink sink = new FolderSink(folder(file), name)) {
            List<String> losses = format == ModelFormat.GLB
                    ? GltfWriter.write(mesh, up, name, sink, remarks)
                    : ModelWriter.write(mesh, format, name, sink);
            sink.commit();
            return new WrittenModel(losses, remarks);
        }
    }

    /** Reads the whole file. Refuses a folder with a message that helps. */
    static byte[] bytes(Path file) throws IOException {
        if (Files.isDirectory(file))
            throw new FileSystemException(file.toString(), null, "is a folder. Name a file in it");
        try (InputStream in = Files.newInputStream(file)) {
            byte[] bytes = in.readNBytes(Sizes.MOST);
            if (bytes.length == Sizes.MOST && in.read() >= 0)
                throw new FileSystemException(
                        file.toString(), null, "is longer than 2 GiB. Larger models must be PLY, OBJ or STL files");
            return bytes;
        }
    }

    static Path folder(Path file) {
        Path parent = file.toAbsolutePath().normalize().getParent();
        if (parent == null) throw new IllegalArgumentException(file + " is a folder");
        return parent;
    }

    static String fileName(Path file) {
        Path name = file.toAbsolutePath().normalize().getFileName();
        if (name == null) throw new IllegalArgumentException(file + " is a folder");
        return name.toString();
    }
}
