package org.jsmesh.s3;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.objects.ObjectContent;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.ObjectStores;
import org.jsmesh.objects.Upload;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FolderObjectStoreTest extends ObjectStoreContract {
    @TempDir
    private Path folder;

    @Override
    ObjectStore empty() throws java.io.IOException {
        return ObjectStores.open(folder.resolve("new/store").toString());
    }

    @Test
    void shouldListInOrderOfBytesWhereThatIsNotTheOrderOfChars() throws Exception {
        List<String> keys = new ArrayList<>();
        try (ObjectStore store = empty()) {
            store.put(Upload.of("\ud83d\ude00", ObjectContent.of(new byte[1])));
            store.put(Upload.of("\uff5e", ObjectContent.of(new byte[1])));
            store.list("", "", object -> keys.add(object.key()));
        }
        assertThat(keys).containsExactly("\uff5e", "\ud83d\ude00");
    }

    @Test
    void shouldLeaveOutFilesThatAreHidden() throws Exception {
        try (ObjectStore store = empty()) {
            store.put(Upload.of("a/b", ObjectContent.of(new byte[1])));
            Files.write(folder.resolve("new/store/a/.partial"), new byte[1]);
            store.list("", "", object -> {
                assertThat(object.key()).isEqualTo("a/b");
                return true;
            });
            assertThat(store.signedAddress("a/b", java.time.Duration.ofHours(1)))
                    .isEmpty();
        }
    }
}
