package org.jsmesh.spark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.apache.spark.TaskKilledException;
import org.jsmesh.objects.FolderObjectStore;
import org.jsmesh.objects.ObjectConflictException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class BinTaskTest {
    private static final Row.Stamp STAMP = new Row.Stamp("run", "settings", 7);
    private static final Bin BIN = new Bin(3, Packed.planned(List.of(model("a", 10), model("b", 10))));

    @TempDir
    private Path folder;

    private Ledger ledger;

    private record Try(int number, long id, boolean isInterrupted) implements Attempt {}

    @BeforeEach
    void open() {
        ledger = new Ledger(new FolderObjectStore(folder));
    }

    private static PlannedModel model(String id, long heapBytes) {
        ListedModel file = new ListedModel("s3://b", id + ".ply", id + ".ply", 5, "t", Instant.EPOCH);
        return new PlannedModel(id, file, 4, heapBytes);
    }

    private static Row row(PlannedModel model) {
        return new Row(model.id(), model.file(), STAMP, "", "", null, null, "", "{}");
    }

    private BinTask.Result run(ModelWork work, int number, long id) throws IOException, InterruptedException {
        return new BinTask(work, folder.toString(), STAMP, 1, false).run(BIN, new Try(number, id, false));
    }

    private List<Row> rows(String journal) throws IOException {
        List<Row> rows = new ArrayList<>();
        ledger.read(journal, rows::add);
        return rows;
    }

    @Test
    void shouldWriteAJournalOfItsOwnInEachAttempt() throws Exception {
        BinTask.Result first = run((model, threads, progress) -> row(model), 0, 41);
        assertThat(first.encoded()).isEqualTo(2);
        // The second is stopped at once; it takes nothing from what the first has told.
        BinTask second = new BinTask((m, t, p) -> row(m), folder.toString(), STAMP, 1, false);
        assertThatThrownBy(() -> second.run(BIN, new Try(0, 42, true))).isInstanceOf(TaskKilledException.class);
        assertThat(rows(first.journal())).extracting(Row::id).containsExactly("a", "b");
        BinTask.Result third = run((model, threads, progress) -> row(model), 0, 43);
        assertThat(third.journal()).isNotEqualTo(first.journal());
    }

    @Test
    void shouldGoOnWhereAnAttemptWasLost() throws Exception {
        ModelWork dies = (model, threads, progress) -> {
            if (model.id().equals("b")) throw new InternalError();
            return row(model);
        };
        assertThatThrownBy(() -> run(dies, 1, 41)).isInstanceOf(InternalError.class);
        List<String> asked = new ArrayList<>();
        ModelWork work = (model, threads, progress) -> {
            asked.add(model.id());
            return row(model);
        };
        BinTask.Result result = run(work, 2, 42);
        assertThat(asked).containsExactly("b");
        assertThat(rows(result.journal())).extracting(Row::id).containsExactly("a", "b");
    }

    @Test
    void shouldNotTakeAFailureForALoss() throws Exception {
        ModelWork fails = (model, threads, progress) -> {
            throw new NoClassDefFoundError();
        };
        for (int i = 1; i < 5; i++) {
            int number = i;
            assertThatThrownBy(() -> run(fails, number, number)).isInstanceOf(NoClassDefFoundError.class);
        }
        assertThat(run((model, threads, progress) -> row(model), 5, 5).encoded())
                .isEqualTo(2);
    }

    @Test
    void shouldGiveARowToWhatTheSiteDidNotTake() throws Exception {
        BinTask.Result result = run(
                (model, threads, progress) -> {
                    if (model.id().equals("a")) throw new IOException("no space. Make some");
                    return row(model);
                },
                0,
                1);
        assertThat(List.of(result.encoded(), result.failed())).containsExactly(1, 1);
        Row.Failure failure = rows(result.journal()).get(0).failure();
        assertThat(failure).isEqualTo(new Row.Failure("s3://b/a.ply", "no space", "Make some", Row.Kind.ROAD));
    }

    @Test
    void shouldGiveARowToWhatFillsTheStack() throws Exception {
        ModelWork fills = (model, threads, progress) -> {
            if (model.id().equals("a")) throw new StackOverflowError();
            throw new AssertionError("odd");
        };
        for (int number = 0; number < 2; number++) {
            BinTask.Result result = run(fills, number, number);
            assertThat(result.failed()).isEqualTo(2);
            assertThat(rows(result.journal()))
                    .extracting(row -> row.failure().reason())
                    .containsExactly("is nested too deeply", "java.lang.AssertionError: odd");
        }
    }

    @Test
    void shouldGiveUpWhereTheProcessEndedTwice() throws Exception {
        ModelWork ends = (model, threads, progress) -> {
            if (model.id().equals("a")) throw new InternalError("a page could not be read");
            return row(model);
        };
        for (int i = 1; i < 3; i++) {
            int number = i;
            assertThatThrownBy(() -> run(ends, number, number)).isInstanceOf(InternalError.class);
        }
        assertThat(rows(run(ends, 3, 3).journal())).extracting(Row::isFailed).containsExactly(true, false);
    }

    @Test
    void shouldGiveUpWhatExecutorsWereLostAt() throws Exception {
        String bin = Ledger.bin("run", 3);
        Losses.begin(ledger, bin, "a");
        Losses.begin(ledger, bin, "a");
        BinTask.Result result = run((model, threads, progress) -> row(model), 3, 9);
        assertThat(rows(result.journal()).get(0).failure().reason()).contains("executors were lost twice");
        assertThat(result.encoded()).isEqualTo(1);
    }

    @Test
    void shouldRememberWhatRanOutOfMemoryInAnEarlierAttempt() throws Exception {
        ModelWork dies = (model, threads, progress) -> {
            if (model.id().equals("a")) throw new OutOfMemoryError();
            throw new InternalError();
        };
        assertThatThrownBy(() -> run(dies, 1, 1)).isInstanceOf(InternalError.class);
        BinTask.Result result = run((model, threads, progress) -> row(model), 2, 2);
        assertThat(Packed.planned(result.exhausted()))
                .extracting(PlannedModel::id)
                .containsExactly("a");
    }

    @Test
    void shouldLetAChangedModelInAnew() throws Exception {
        List<Long> taken = new ArrayList<>();
        ModelWork work = (model, threads, progress) -> {
            taken.add(Worker.gate().taken());
            if (model.heapBytes() == 10)
                throw new ModelChangedException(
                        model(model.id(), 20),
                        new ObjectConflictException(model.file().input(), "was replaced"));
            return row(model);
        };
        assertThat(run(work, 0, 1).encoded()).isEqualTo(2);
        assertThat(taken).containsExactly(10L, 20L, 10L, 20L);
        BinTask.Result never = run(
                (model, threads, progress) -> {
                    throw new ModelChangedException(
                            model, new ObjectConflictException(model.file().input(), "was replaced"));
                },
                0,
                2);
        assertThat(rows(never.journal()).get(0).failure().kind()).isEqualTo(Row.Kind.ROAD);
    }
}
