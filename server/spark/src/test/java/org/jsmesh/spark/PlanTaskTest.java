package org.jsmesh.spark;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Instant;
import org.jsmesh.memory.HeapShortageException;
import org.jsmesh.objects.FolderObjectStore;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PlanTaskTest {
    private static final Row.Stamp STAMP = new Row.Stamp("run", "settings", 7);

    @TempDir
    private Path folder;

    private PlanTask task() {
        return new PlanTask(Cluster.settings("in", "out"), STAMP);
    }

    private ListedModel listed(String key) throws IOException {
        ListedModel file = new ListedModel(folder.toString(), key, key, -1, "", Instant.EPOCH);
        return file.at(new FolderObjectStore(folder).find(key).orElseThrow());
    }

    @Test
    void shouldTellBeforehandWhatIsTooLarge() throws IOException {
        int faces = 300_000_000;
        try (FileChannel file =
                FileChannel.open(folder.resolve("large.stl"), StandardOpenOption.CREATE, StandardOpenOption.WRITE)) {
            file.write(ByteBuffer.allocate(84).order(ByteOrder.LITTLE_ENDIAN).putInt(80, faces));
            file.write(ByteBuffer.allocate(1), 84 + 50L * faces - 1);
        }
        PlanRow plan = task().plan("large", listed("large.stl"), null);
        assertThat(plan.kind()).isEqualTo(PlanRow.Kind.REFUSED);
        Row.Failure failure = plan.row().failure();
        assertThat(failure.reason()).contains(faces + " faces need");
        assertThat(failure.remedy()).contains("--executor-memory");
        assertThat(failure.kind()).isEqualTo(Row.Kind.MEMORY);
    }

    @Test
    void shouldTakeAFileAsItHasBecome() throws IOException {
        Patches.write(folder.resolve("a.ply"), 4, 1);
        ListedModel before = listed("a.ply");
        Files.delete(folder.resolve("a.ply"));
        Patches.write(folder.resolve("a.ply"), 9, 2);
        PlanRow plan = task().plan("a", before, null);
        assertThat(plan.kind()).isEqualTo(PlanRow.Kind.ENCODE);
        assertThat(plan.planned().file()).isEqualTo(listed("a.ply"));
        assertThat(plan.planned().faces()).isEqualTo(2 * 8 * 8);

        Files.delete(folder.resolve("a.ply"));
        assertThat(task().plan("a", before, null).row().failure().reason()).isEqualTo("is not there");
    }

    @Test
    void shouldKeepWhatIsTheSameAndForgetFailuresThatAreGone() throws IOException {
        Patches.write(folder.resolve("a.ply"), 4, 1);
        Row done = new Row("a", listed("a.ply"), STAMP, "", "", null, null, "", "{}");
        assertThat(task().plan("a", listed("a.ply"), done)).isEqualTo(new PlanRow(PlanRow.Kind.KEPT, null, null));
        assertThat(task().plan("a", null, done).kind()).isEqualTo(PlanRow.Kind.ABSENT);
        assertThat(task().plan("a", null, RowParquetTest.failed("a")).kind()).isEqualTo(PlanRow.Kind.FORGOTTEN);
    }

    @Test
    void shouldAskForMemoryOfExecutors() throws IOException {
        Patches.write(folder.resolve("a.ply"), 4, 1);
        Row.Failure failure = PlanTask.failure(listed("a.ply"), new HeapShortageException(5L << 30, 1L << 30));
        assertThat(failure.kind()).isEqualTo(Row.Kind.MEMORY);
        assertThat(failure.remedy()).isEqualTo("Give executors more (--executor-memory 6g)");
    }
}
