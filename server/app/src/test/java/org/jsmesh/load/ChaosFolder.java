package org.jsmesh.load;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Arrays;
import java.util.List;
import java.util.Random;

/** A folder of models and archives in which somebody replaces, cuts, overwrites and removes files all the time. */
final class ChaosFolder {
    private final Path folder;
    private final List<byte[]> archives;
    private final List<byte[]> models;
    private final Random random;
    private final int count;
    private int changes;

    /**
     * @param archives contents of archives
     * @param models contents of model files
     * @param count files of each kind
     */
    ChaosFolder(Path folder, List<byte[]> archives, List<byte[]> models, int count, long seed) throws IOException {
        this.folder = folder;
        this.archives = archives;
        this.models = models;
        this.count = count;
        random = new Random(seed);
        mend();
    }

    int changes() {
        return changes;
    }

    /** The ids of all of them. */
    String[] ids() {
        String[] ids = new String[2 * count];
        for (int i = 0; i < count; i++) {
            ids[i] = "archive-" + i;
            ids[count + i] = "model-" + i;
        }
        return ids;
    }

    /** Every file is whole again. */
    void mend() throws IOException {
        for (int i = 0; i < count; i++) {
            Files.write(file(true, i), archives.get(i % archives.size()));
            Files.write(file(false, i), models.get(i % models.size()));
        }
    }

    private Path file(boolean isArchive, int number) {
        return folder.resolve(isArchive ? "archive-" + number + ".jsm" : "model-" + number + ".ply");
    }

    /** Does one thing to one file. */
    void change() throws IOException {
        boolean isArchive = random.nextBoolean();
        List<byte[]> contents = isArchive ? archives : models;
        byte[] content = contents.get(random.nextInt(contents.size()));
        Path file = file(isArchive, random.nextInt(count));
        switch (random.nextInt(6)) {
            case 0 -> Files.deleteIfExists(file);
            case 1 -> Files.write(file, Arrays.copyOf(content, random.nextInt(content.length)));
            case 2 -> Files.write(file, content);
            default -> {
                Path beside = Files.write(folder.resolve(".new"), content);
                Files.move(beside, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
            }
        }
        changes++;
    }
}
