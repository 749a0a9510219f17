package org.jsmesh.encoder;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.jsmesh.mesh.io.ModelFormat;

/** Finds the model files among files and folders, and a place for each archive. The same files give the same places, whatever the order of a folder. */
public final class EncodePlan {
    private static final String EXTENSION = ".jsm";

    private EncodePlan() {}

    /**
     * One file to one archive: {@code out} itself, or in it when it is a folder.
     *
     * @throws IOException when a folder cannot be listed
     */
    public static List<EncodeJob> of(Path file, Path out) {
        return List.of(new EncodeJob(file, Files.isDirectory(out) ? out.resolve(stem(file) + EXTENSION) : out));
    }

    /**
     * Files and folders to archives in {@code outFolder}. Of a folder every file with the extension of a model format is taken, at any depth, and its sub-folders are kept.
     * {@code a/x.ply} gives {@code x.jsm}; where that would name two, both keep their extension: {@code x.ply.jsm}, {@code x.obj.jsm}.
     *
     * @throws IllegalArgumentException when two inputs still have the same place
     * @throws NoSuchFileException when a folder holds no model
     * @throws IOException when a folder cannot be listed
     */
    public static List<EncodeJob> of(List<Path> inputs, Path outFolder) throws IOException {
        List<Path> files = new ArrayList<>();
        List<Path> places = new ArrayList<>();
        for (Path input : inputs) {
            if (!Files.isDirectory(input)) {
                files.add(input);
                places.add(Path.of(ModelFiles.fileName(input)));
                continue;
            }
            List<Path> found = models(input);
            if (found.isEmpty())
                throw new NoSuchFileException(input + ": no model file (ply, obj, stl, off, m, glb) in this folder");
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
        return jobs;
    }

    private static List<Path> models(Path folder) throws IOException {
        try (Stream<Path> walk = Files.walk(folder)) {
            return walk.filter(p -> ModelFormat.ofName(p.toString()) != null
                            && !ModelFiles.fileName(p).startsWith("."))
                    .filter(Files::isRegularFile)
                    .sorted()
                    .toList();
        }
    }

    private static Path shortPlace(Path place) {
        return place.resolveSibling(stem(place) + EXTENSION);
    }

    private static String stem(Path file) {
        String name = ModelFiles.fileName(file);
        int dot = name.lastIndexOf('.');
        return dot <= 0 ? name : name.substring(0, dot);
    }
}
