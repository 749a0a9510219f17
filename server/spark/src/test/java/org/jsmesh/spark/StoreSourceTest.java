package org.jsmesh.spark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import org.jsmesh.objects.FolderObjectStore;
import org.jsmesh.objects.ObjectConflictException;
import org.jsmesh.objects.StoredObject;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class StoreSourceTest {
    @TempDir
    private Path folder;

    @Test
    void shouldReadOneVersionInPortions() throws IOException {
        byte[] content = new byte[300_000];
        new Random(1).nextBytes(content);
        Path file = Files.write(folder.resolve("a.ply"), content);
        FolderObjectStore store = new FolderObjectStore(folder);
        StoredObject object = store.find("a.ply").orElseThrow();
        StoreSource source = new StoreSource(store, object);
        assertThat(source.length()).isEqualTo(content.length);
        for (int from : new int[] {0, 1, 65_535, 299_999, 300_000}) {
            try (InputStream in = source.from(from)) {
                assertThat(in.readAllBytes()).isEqualTo(Arrays.copyOfRange(content, from, content.length));
                assertThat(in.read()).isEqualTo(-1);
            }
        }
        Files.write(file, new byte[7]);
        assertThatThrownBy(() -> source.from(0).read()).isInstanceOf(ObjectConflictException.class);
    }
}
