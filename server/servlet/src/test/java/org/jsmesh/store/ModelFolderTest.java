package org.jsmesh.store;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ModelFolderTest {
    @TempDir
    private Path temp;

    private Path folder;
    private final List<ModelFolder> opened = new ArrayList<>();

    @BeforeEach
    void makeFolder() throws IOException {
        folder = Files.createDirectory(temp.resolve("models"));
    }

    @AfterEach
    void close() {
        opened.forEach(ModelFolder::close);
    }

    private ModelFolder open(boolean isWatched) throws IOException {
        FolderWatch watch = isWatched ? FolderWatch.of(folder) : FolderWatch.none();
        ModelFolder models = new ModelFolder(folder, e -> null, () -> {}, watch);
        opened.add(models);
        models.open();
        return models;
    }

    /** Files and folders come, change, are moved and go, as fast as can be. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void shouldComeToWhatAnotherLookFinds(long seed) throws Exception {
        ModelFolder models = open(true);
        Random random = new Random(seed);
        for (int round = 0; round < 4; round++) {
            for (int i = 0; i < 60; i++) change(random);
            Await.until("the changes of round " + round, () -> models.entries().equals(found()));
            for (ModelEntry entry : models.entries()) {
                assertThat(models.known(entry.id())).isEqualTo(entry);
                assertThat(models.of(entry.path())).isEqualTo(entry);
            }
        }
    }

    /** The same where nobody tells of changes. Those in files show when these are asked for. */
    @Test
    void shouldFindChangedFolders() throws Exception {
        ModelFolder models = open(false);
        Random random = new Random(4);
        for (int i = 0; i < 100; i++) change(random);
        Await.until("the changes", () -> ids(models.entries()).equals(ids(found())));
    }

    private List<ModelEntry> found() throws IOException {
        return List.copyOf(Folders.entries(Folders.scan(folder)).values());
    }

    private static List<String> ids(List<ModelEntry> entries) {
        return entries.stream().map(ModelEntry::id).toList();
    }

    private void change(Random random) throws IOException {
        List<Path> all;
        try (Stream<Path> walk = Files.walk(folder)) {
            all = walk.sorted().toList();
        }
        List<Path> folders = all.stream().filter(Files::isDirectory).toList();
        Path in = folders.get(random.nextInt(folders.size()));
        Path any = all.get(random.nextInt(all.size()));
        String format = List.of(".obj", ".stl", ".jsm", ".txt").get(random.nextInt(4));
        Path name = in.resolve("m" + random.nextInt(6) + format);
        switch (random.nextInt(8)) {
            case 0, 1, 2 -> Files.writeString(name, "x".repeat(random.nextInt(9)));
            case 3 -> Files.createDirectories(in.resolve("f" + random.nextInt(3)));
            case 4 -> {
                if (Files.isRegularFile(any)) Files.writeString(any, "more", StandardOpenOption.APPEND);
            }
            case 5 -> {
                if (!any.equals(folder)) delete(any);
            }
            default -> {
                Path to = in.resolve(any.getFileName());
                boolean mayMove = !any.equals(folder) && !in.startsWith(any) && !Files.exists(to);
                if (mayMove) Files.move(any, to);
            }
        }
    }

    private static void delete(Path tree) throws IOException {
        List<Path> files;
        try (Stream<Path> walk = Files.walk(tree)) {
            files = walk.sorted(Comparator.reverseOrder()).toList();
        }
        for (Path file : files) Files.delete(file);
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void shouldFindANewFileThatIsAskedFor(boolean isWatched) throws Exception {
        Files.createDirectories(folder.resolve("a/b"));
        ModelFolder models = open(isWatched);
        Files.writeString(folder.resolve("a/b/new.ply"), "new");
        Await.until("the new file", () -> models.find("a--b--new") != null);
    }

    @Test
    void shouldTellTheSizeOfAFileThatIsBeingCopied() throws Exception {
        ModelFolder models = open(true);
        Path file = folder.resolve("slow.ply");
        for (int i = 1; i <= 3; i++) {
            Files.writeString(file, "part", StandardOpenOption.CREATE, StandardOpenOption.APPEND);
            int bytes = 4 * i;
            Await.until("part " + i, () -> {
                ModelEntry entry = models.known("slow");
                return entry != null && entry.bytes() == bytes;
            });
        }
    }

    @Test
    void shouldFollowASingleFile() throws Exception {
        Path file = Files.writeString(folder.resolve("one.ply"), "1");
        ModelFolder models = new ModelFolder(file, e -> null, () -> {});
        opened.add(models);
        models.open();
        assertThat(models.known("one").path()).isEqualTo(file);
        assertThat(models.of(file)).isNotNull();
        Files.writeString(file, "longer");
        Await.until("the change", () -> models.known("one").bytes() == 6);
    }

    @Test
    void shouldSayThatTheFolderIsGoneAndGoOnWhenItIsBack() throws Exception {
        Files.writeString(folder.resolve("one.ply"), "1");
        ModelFolder models = open(true);
        models.check();
        Path away = Files.move(folder, temp.resolve("away"));
        Await.until("the folder's end", () -> {
            try {
                models.check();
                return false;
            } catch (IOException e) {
                return true;
            }
        });
        assertThatThrownBy(models::look).isInstanceOf(IOException.class);
        assertThat(models.known("one")).as("what is known stays").isNotNull();
        Files.writeString(away.resolve("two.ply"), "2");
        Files.move(away, folder);
        Await.until("the folder's return", () -> models.known("two") != null);
        models.check();
    }
}
