package org.jsmesh.files;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Executor;
import java.util.concurrent.ForkJoinPool;
import org.jsmesh.archive.Provenance;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.memory.ByteRanges;
import org.jsmesh.memory.HeapShortageException;
import org.jsmesh.memory.MemoryEstimate;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Picture;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.Sizes;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.mesh.io.ByteSource;
import org.jsmesh.mesh.io.ModelFile;
import org.jsmesh.mesh.io.ModelFormatException;
import org.jsmesh.mesh.io.ResourceResolver;
import org.jsmesh.poster.Poster;

/**
 * The road from a model file, packed or not, and its companions (material libraries, images, buffers) to an archive.
 * The command, the server and its uploads take it, so the same model gives the same bytes everywhere:
 *
 * <pre>
 *     ModelEncoding encoding = new ModelEncoding(EncoderSettings.defaults());
 *     encoding.write(Path.of("chair.obj"), Path.of("chair.jsm"), ProgressListener.NONE);
 * </pre>
 *
 * A model that does not come from a file is given as bytes, with a {@link ResourceResolver} that finds its companions:
 *
 * <pre>
 *     EncodedArchive archive = encoding.encode("chair.obj", bytes, new FolderResources(folder), ProgressListener.NONE);
 * </pre>
 *
 * The listener hears of the stages: {@code reading}, {@code textures} where there are any, those of
 * {@link MeshEncoder}, and {@code writing} where a file is written. It may cancel between two steps of each. Immutable
 * and thread-safe. The bytes depend on model, companions and settings, not on threads.
 */
public final class ModelEncoding {
    /**
     * Changes when the same model with the same settings gives other bytes than before. Who keeps archives keeps them
     * under it.
     */
    public static final int VERSION = 2;

    private final EncoderSettings settings;
    private final Executor helpers;
    private final int mostFaces;
    private final long mostBytes;

    /** @param settings {@code threads - 1} tasks at a time go to {@link ForkJoinPool#commonPool} */
    public ModelEncoding(EncoderSettings settings) {
        this(settings, ForkJoinPool.commonPool(), Integer.MAX_VALUE, ModelFiles.ANY_BYTES);
    }

    private ModelEncoding(EncoderSettings settings, Executor helpers, int mostFaces, long mostBytes) {
        this.settings = settings;
        this.helpers = helpers;
        this.mostFaces = mostFaces;
        this.mostBytes = mostBytes;
    }

    /**
     * Changes who does the work of the threads beyond the calling one.
     *
     * @param executor which runs that work
     * @return an encoding that differs in that alone
     */
    public ModelEncoding withHelpers(Executor executor) {
        return new ModelEncoding(settings, executor, mostFaces, mostBytes);
    }

    /**
     * Changes which models are refused before they are encoded.
     *
     * @param faces that a model may have
     * @return an encoding that differs in that alone
     */
    public ModelEncoding withMostFaces(int faces) {
        if (faces < 1) throw new IllegalArgumentException("faces: " + faces);
        return new ModelEncoding(settings, helpers, faces, mostBytes);
    }

    /**
     * Changes which packed models (gzip files and ZIP archives) are refused before they are read.
     *
     * @param bytes that a model and its companions may unpack to
     * @return an encoding that differs in that alone
     */
    public ModelEncoding withMostBytes(long bytes) {
        if (bytes < 1) throw new IllegalArgumentException("bytes: " + bytes);
        return new ModelEncoding(settings, helpers, mostFaces, bytes);
    }

    /**
     * Encodes a model file. Companions are looked for in its folder and below, see {@link FolderResources}.
     *
     * @param model the file
     * @param progress hears how far the work is and may stop it
     * @return the archive; its notes say what of the file it does not hold as it was
     * @throws ModelFormatException when the file is no model or a damaged one
     * @throws IOException when a file cannot be read
     * @throws IllegalArgumentException when the model cannot be encoded, for instance because it has no faces, or more
     *     than allowed; the message says why and what to do
     * @throws HeapShortageException when its header says that the heap is too small for it, before it is read
     * @throws java.util.concurrent.CancellationException when the listener cancels
     */
    public EncodedArchive encode(Path model, ProgressListener progress) throws IOException {
        return encode(model, new ModelInputs(), progress);
    }

    /**
     * Encodes a model file and tells what it read; throws as {@link #encode(Path, ProgressListener)} does.
     *
     * @param model the file
     * @param inputs are told of every byte that is read
     * @param progress hears how far the work is and may stop it
     * @return the archive
     * @throws IOException when a file cannot be read
     */
    public EncodedArchive encode(Path model, ModelInputs inputs, ProgressListener progress) throws IOException {
        progress.step("reading", 0);
        if (Files.isRegularFile(model)) HeapShortageException.check(MemoryEstimate.of(model, settings));
        return encodeChecked(model, inputs, progress);
    }

    private EncodedArchive encodeChecked(Path model, ModelInputs inputs, ProgressListener progress) throws IOException {
        return encode(ModelFiles.read(model, inputs, mostBytes, mostFaces, progress), progress);
    }

    /**
     * Encodes the bytes of a model file; throws as {@link #encode(Path, ProgressListener)} does.
     *
     * @param name of the file, for messages, and as a hint where the content leaves the format open
     * @param content the whole file, not changed
     * @param companions finds the files that it refers to; {@link ResourceResolver#NONE} when there are none
     * @param progress hears how far the work is and may stop it
     * @return the archive; its notes say what of the model it does not hold as it was
     * @throws IOException when a companion cannot be read, or the content is no model
     */
    public EncodedArchive encode(String name, byte[] content, ResourceResolver companions, ProgressListener progress)
            throws IOException {
        progress.step("reading", 0);
        HeapShortageException.check(MemoryEstimate.of(name, content.length, ByteRanges.ofStart(content), settings));
        return encode(
                ModelFiles.read(name, ByteSource.of(content), companions, mostBytes, mostFaces, progress), progress);
    }

    /**
     * Encodes a model file that need not be in memory and may be larger than 2 GiB, see {@link ModelFiles#read(String,
     * ByteSource, ResourceResolver)}; throws as {@link #encode(Path, ProgressListener)} does.
     *
     * @param name of the file, for messages, and as a hint where the content leaves the format open
     * @param content the whole file
     * @param companions finds the files that it refers to; {@link ResourceResolver#NONE} when there are none
     * @param progress hears how far the work is and may stop it
     * @return the archive; its notes say what of the model it does not hold as it was
     * @throws IOException when the content or a companion cannot be read, or the content is no model
     */
    public EncodedArchive encode(
            String name, ByteSource content, ResourceResolver companions, ProgressListener progress)
            throws IOException {
        progress.step("reading", 0);
        ByteRanges ranges = (from, bytes) -> {
            try (InputStream in = content.from(from)) {
                return in.readNBytes(bytes);
            }
        };
        HeapShortageException.check(MemoryEstimate.of(name, content.length(), ranges, settings));
        return encode(ModelFiles.read(name, content, companions, mostBytes, mostFaces, progress), progress);
    }

    /**
     * Encodes a model that a stream brings; throws as {@link #encode(Path, ProgressListener)} does.
     *
     * @param name of the file, for messages, and as a hint where the content leaves the format open
     * @param content the whole file; it is read to its end and not closed
     * @param companions finds the files that it refers to; {@link ResourceResolver#NONE} when there are none
     * @param progress hears how far the work is and may stop it
     * @return the archive; its notes say what of the model it does not hold as it was
     * @throws IOException when the stream or a companion cannot be read, or the content is no model
     */
    public EncodedArchive encode(
            String name, InputStream content, ResourceResolver companions, ProgressListener progress)
            throws IOException {
        progress.step("reading", 0);
        byte[] bytes = content.readNBytes(Sizes.MOST);
        if (bytes.length == Sizes.MOST && content.read() >= 0)
            throw new ModelFormatException(
                    name,
                    "",
                    "the stream is longer than 2 GiB",
                    "Give the model as a file or a ByteSource, which may be larger");
        return encode(name, bytes, companions, progress);
    }

    /**
     * Encodes a model file and writes the archive, whole or not at all; throws as {@link #encode(Path,
     * ProgressListener)} does.
     *
     * @param model the file
     * @param archive the file to write; replaced when it is there, its folders are made
     * @param progress hears how far the work is and may stop it
     * @return what was written
     * @throws java.nio.file.FileSystemException also when the archive cannot be written, or something is there that is
     *     no file
     */
    public EncodedArchive write(Path model, Path archive, ProgressListener progress) throws IOException {
        OutputFiles.requireReplaceable(archive);
        return write(encode(model, new ModelInputs(), progress), archive, progress);
    }

    /** The same for a model whose estimate was checked before. */
    EncodedArchive writeChecked(Path model, Path archive, ProgressListener progress) throws IOException {
        OutputFiles.requireReplaceable(archive);
        progress.step("reading", 0);
        return write(encodeChecked(model, new ModelInputs(), progress), archive, progress);
    }

    private static EncodedArchive write(EncodedArchive encoded, Path archive, ProgressListener progress)
            throws IOException {
        progress.step("writing", 0);
        AtomicFiles.write(archive, encoded::writeTo);
        return encoded;
    }

    private EncodedArchive encode(ModelFile file, ProgressListener progress) {
        Mesh mesh = file.mesh();
        if (mesh.faces() > mostFaces)
            throw new IllegalArgumentException("the model has " + mesh.faces() + " faces, more than the " + mostFaces
                    + " allowed. Give a smaller model");
        if (!mesh.textures().isEmpty()) progress.step("textures", 0);
        List<Picture> pictures = ModelPictures.of(mesh);
        Provenance from = new Provenance(file.format().title(), file.notes());
        EncoderSettings own =
                settings.up() == UpAxis.UNKNOWN ? settings.withUp(file.format().up()) : settings;
        return new MeshEncoder(own, helpers)
                .withPoster((clean, up) -> Poster.jpeg(clean, up, pictures))
                .encode(mesh, from, pictures, progress);
    }
}
