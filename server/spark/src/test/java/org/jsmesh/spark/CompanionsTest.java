package org.jsmesh.spark;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.Optional;
import org.jsmesh.files.FolderResources;
import org.jsmesh.mesh.io.Resource;
import org.jsmesh.objects.FolderObjectStore;
import org.jsmesh.objects.ObjectStore;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CompanionsTest {
    @TempDir
    private Path folder;

    private ObjectStore store;

    @BeforeEach
    void makeFiles() throws IOException {
        Files.createDirectories(folder.resolve("chair/Maps/deep"));
        Files.writeString(folder.resolve("secret.png"), "secret");
        Files.writeString(folder.resolve("chair/Wood.png"), "wood");
        Files.writeString(folder.resolve("chair/Maps/oak.png"), "oak");
        Files.writeString(folder.resolve("chair/Maps/deep/a.png"), "a");
        Files.writeString(folder.resolve("chair/zebra.png"), "zebra");
        store = new FolderObjectStore(folder);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "Wood.png",
                "wood.PNG",
                "./Wood.png",
                "Maps/oak.png",
                "maps\\OAK.png",
                "maps/../wood.png",
                "../secret.png",
                "/secret.png",
                "Maps",
                "C:\\me\\WOOD.png",
                "/home/me/zebra.png",
                "Maps/DEEP/A.png",
                "deep/a.png",
                "nothing.png",
                "",
                ".",
                "a\u0000b"
            })
    void shouldFindWhatIsFoundInAFolder(String path) throws IOException {
        Optional<Resource> expected = new FolderResources(folder.resolve("chair")).locate(path);
        Optional<Resource> found = new Companions(store, "chair/").locate(path);
        assertThat(found.map(Resource::path)).isEqualTo(expected.map(Resource::path));
        assertThat(found.map(r -> new String(r.content()))).isEqualTo(expected.map(r -> new String(r.content())));
    }

    @Test
    void shouldNoticeWhatHasChanged() throws IOException {
        Companions companions = new Companions(store, "chair/");
        companions.locate("WOOD.png");
        companions.locate("nothing.png");
        Collection<CompanionTag> asked = CompanionTag.fromJson(CompanionTag.toJson(companions.asked()));
        assertThat(asked).hasSize(2);
        assertThat(new Companions(store, "chair/").have(asked)).isTrue();

        Files.writeString(folder.resolve("chair/nothing.png"), "something");
        assertThat(new Companions(store, "chair/").have(asked)).isFalse();
        Files.delete(folder.resolve("chair/nothing.png"));
        assertThat(new Companions(store, "chair/").have(asked)).isTrue();
        Files.writeString(folder.resolve("chair/Wood.png"), "other wood");
        assertThat(new Companions(store, "chair/").have(asked)).isFalse();
    }
}
