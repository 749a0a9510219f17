package org.jsmesh.objects;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

@EnabledOnOs({OS.LINUX, OS.MAC})
class FolderLinksTest {
    @TempDir
    private Path folder;

    private List<String> keys() throws IOException {
        List<String> keys = new ArrayList<>();
        try (FolderObjectStore store = new FolderObjectStore(folder.resolve("store"))) {
            // Where links were followed upwards, there would be no end.
            store.list("", "", object -> keys.add(object.key()) && keys.size() < 100);
        }
        return keys;
    }

    private void file(String path) throws IOException {
        Path file = folder.resolve(path);
        Files.createDirectories(file.getParent());
        Files.write(file, new byte[1]);
    }

    private void link(String path, String target) throws IOException {
        Files.createSymbolicLink(folder.resolve(path), Path.of(target));
    }

    @Test
    void shouldListFilesOnceWhereLinksLeadUpwards() throws Exception {
        file("store/a/b/x");
        link("store/l1", ".");
        link("store/l2", ".");
        link("store/a/b/up", "../..");
        assertThat(keys()).containsExactly("a/b/x");
    }

    @Test
    void shouldEnterNoFolderByALinkAsTheCommandDoesNot() throws Exception {
        file("elsewhere/in/x");
        file("store/y");
        link("store/one", "../elsewhere");
        link("store/two", "../elsewhere/in");
        link("store/file", "../elsewhere/in/x");
        assertThat(keys()).containsExactly("file", "y");
    }
}
