package org.jsmesh.files;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.jsmesh.mesh.io.ModelFormat;

/**
 * Finds the model files among files and folders, and a place for each archive. The same files give the same places,
 * whatever the order of a folder.
 */
public final class EncodePlan {
    private static final String EXTENSION = ".jsm";

    private EncodePlan() {}

    /**
     * Plans to encode one file into one archive.
     *
     * @param file the model
     * @param out the archive, or the folder that it goes to
     * @return one job
     * @throws IllegalArgumentException when the archive would replace the file
     */
    public static List<EncodeJob> of(Path file, Path out) {
        return keepingInputs(
                List.of(new EncodeJob(file, Files.isDirectory(out) ? out.resolve(stem(file) + EXTENSION) : out)));
    }

    /**
     * Plans to encode files and folders into archives in {@code outFolder}. From a folder it takes every file with the
     * extension of a model format, at any depth, and keeps the sub-folders. {@code a/x.ply} gives {@code x.jsm}; where
     * two files would get that name, both keep their extension: {@code x.ply.jsm}, {@code x.obj.jsm}.
     *
     * @param inputs model files, and folders of them
     * @param outFolder the folder of the archives; it need not exist
     * @param unreadable is told of each folder that cannot be listed, and of each file and folder whose name the locale
     *     cannot hold; the others count
     * @return a job per model, in the order of the inputs; those of one folder are sorted by path
     * @throws IllegalArgumentException when two inputs still have the same place, or an archive would replace an input
     * @throws FileSystemException when a folder holds no model
     */
    public static List<EncodeJob> of(List<Path> inputs, Path outFolder, Consumer<IOException> unreadable)
            throws IOException {
        List<Path> files = new ArrayList<>();
        List<Path> places = new ArrayList<>();
        for (Path input : inputs) {
            if (!Files.isDirectory(input)) {
                files.add(input);
                places.add(Path.of(ModelFiles.fileName(input)));
                continue;
            }
            List<Path> found = models(input, unreadable);
            if (found.isEmpty())
                throw new FileSystemException(
                        input.toString(),
                        null,
                        "holds no model file (ply, obj, stl, off, m, glb, gltf, 3mf). Choose another folder");
            for (Path file : found) {
                files.add(file);
                places.add(input.relativize(file));
            }
        }
        Map<Path, Integer> uses = new HashMap<>();
        for (Path place : places) uses.merge(shortPlace(place), 1, Integer::sum);
        Map<Path, Path> taken = new HashMap<>();
        List<EncodeJob> jobs = new ArrayList<>();
        for (int i = 0; i < files.size(); i++) {
            Path place = places.get(i);
            Path name = uses.get(shortPlace(place)) == 1
                    ? shortPlace(place)
                    : place.resolveSibling(place.getFileName() + EXTENSION);
            Path other = taken.put(name, files.get(i));
            if (other != null)
                throw new IllegalArgumentException(other + " and " + files.get(i) + " would both become " + name);
            jobs.add(new EncodeJob(files.get(i), outFolder.resolve(name)));
        }
        return keepingInputs(jobs);
    }

    private static List<EncodeJob> keepingInputs(List<EncodeJob> jobs) {
        Set<Path> inputs = new HashSet<>();
        for (EncodeJob job : jobs) realPath(job.input()).ifPresent(inputs::add);
        for (EncodeJob job : jobs) {
            if (realPath(job.output()).filter(inputs::contains).isPresent())
                throw new IllegalArgumentException("the archive " + job.output()
                        + " would replace an input of the same name; write it somewhere else");
        }
        return jobs;
    }

    private static Optional<Path> realPath(Path file) {
        try {
            return Optional.of(file.toRealPath());
        } catch (IOException e) {
            return Optional.empty(); // it does not exist: reading it will fail, and nothing is replaced
        }
    }

    private static List<Path> models(Path folder, Consumer<IOException> unreadable) throws IOException {
        List<Path> found = new ArrayList<>();
        Files.walkFileTree(folder, new SimpleFileVisitor<>() {
            @Override
            public FileVisitResult preVisitDirectory(Path visited, BasicFileAttributes attributes) {
                return visited.equals(folder) || isNameable(visited)
                        ? FileVisitResult.CONTINUE
                        : FileVisitResult.SKIP_SUBTREE;
            }

            private boolean isNameable(Path path) {
                if (PathNames.areRepresentable(path)) return true;
                unreadable.accept(PathNames.skipped(path));
                return false;
            }

            @Override
            public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
                boolean model = ModelFormat.ofName(file.toString()) != null
                        && !ModelFiles.fileName(file).startsWith(".");
                if (model && Files.isRegularFile(file) && isNameable(file)) found.add(file);
                return FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult visitFileFailed(Path file, IOException e) {
                unreadable.accept(e);
                return FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult postVisitDirectory(Path visited, IOException e) {
                if (e != null) unreadable.accept(e);
                return FileVisitResult.CONTINUE;
            }
        });
        Collections.sort(found);
        return found;
    }

    private static Path shortPlace(Path place) {
        return place.resolveSibling(stem(place) + EXTENSION);
    }

    private static String stem(Path file) {
        String name = ModelFormat.withoutGzip(ModelFiles.fileName(file));
        int dot = name.lastIndexOf('.');
        return dot <= 0 ? name : name.substring(0, dot);
    }
}
