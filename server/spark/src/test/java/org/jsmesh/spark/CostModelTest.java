package org.jsmesh.spark;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.files.ModelEncoding;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.objects.FolderObjectStore;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.site.ModelPublisher;
import org.jsmesh.webapp.ViewerFiles;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CostModelTest {
    @TempDir
    private Path folder;

    @Test
    void shouldCountTheRequestsOfAModelThatIsNew() throws Exception {
        SortedMap<String, Integer> counts = new TreeMap<>();
        ObjectStore folderStore = new FolderObjectStore(folder);
        ObjectStore store = (ObjectStore) Proxy.newProxyInstance(
                ObjectStore.class.getClassLoader(), new Class<?>[] {ObjectStore.class}, (proxy, method, args) -> {
                    counts.merge(method.getName(), 1, Integer::sum);
                    try {
                        return method.invoke(folderStore, args);
                    } catch (InvocationTargetException e) {
                        throw e.getCause();
                    }
                });
        EncodedArchive archive = new ModelEncoding(EncoderSettings.defaults())
                .encode(
                        "a.ply",
                        Patches.ply(9, 1).getBytes(StandardCharsets.UTF_8),
                        path -> Optional.empty(),
                        ProgressListener.NONE);
        new ModelPublisher(store, ViewerFiles.read().get("index.html"), null).publish("a", "a", archive, null);
        SortedMap<String, Integer> expected = new TreeMap<>();
        expected.put("find", CostModel.FINDS);
        expected.put("put", CostModel.PUTS);
        assertThat(counts).isEqualTo(expected);
    }
}
