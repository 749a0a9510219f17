package org.jsmesh.spark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
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

    private List<Row> rows(List<String> journals) throws IOException {
        List<Row> rows = new ArrayList<>();
        for (String journal : journals) ledger.read(journal, rows::add);
        return rows;
    }

    @Test
    void shouldWriteAJournalOfItsOwnInEachAttempt() throws Exception {
        BinTask.Result first = run((model, threads, progress) -> row(model), 0, 41);
        assertThat(first.encoded()).isEqualTo(2);
        // The second is stopped at once; it takes nothing from what the first has told.
        BinTask second = new BinTask((m, t, p) -> row(m), folder.toString(), STAMP, 1, false);
        assertThatThrownBy(() -> second.run(BIN, new Try(0, 42, true))).isInstanceOf(TaskKilledException.class);
        assertThat(rows(first.journals())).extracting(Row::id).containsExactly("a", "b");
        BinTask.Result third = run((model, threads, progress) -> row(model), 0, 43);
        assertThat(third.journals()).doesNotContainAnyElementsOf(first.journals());
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
        assertThat(rows(result.journals())).extracting(Row::id).containsExactly("a", "b");
    }

    @Test
    void shouldWriteRowsAtOnceAfterALossButNotAllAnew() throws Exception {
        List<PlannedModel> models = new ArrayList<>();
        for (int i = 0; i < 2 * Journal.MANY + 10; i++) models.add(model("m" + i, 10));
        String begin = Ledger.bin("run", 4);
        ModelWork work = (model, threads, progress) -> {
            // All rows before this one are known to the next attempt.
            Set<String> known = new HashSet<>();
            for (Row row : rows(ledger.journalsOf(begin))) known.add(row.id());
            assertThat(known).hasSize(Integer.parseInt(model.id().substring(1)));
            return row(model);
        };
        ModelWork dies = (model, threads, progress) -> {
            if (model.id().equals("m" + (Journal.MANY + 2))) throw new InternalError();
            return work.encode(model, threads, progress);
        };
        Bin bin = new Bin(4, Packed.planned(models));
        assertThatThrownBy(() -> new BinTask(dies, folder.toString(), STAMP, 1, false).run(bin, new Try(1, 7, false)))
                .isInstanceOf(InternalError.class);
        assertThat(rows(List.of(begin + "7-0.json"))).hasSize(Journal.MANY);
        assertThat(rows(List.of(begin + "7-1.json"))).hasSize(2);
        BinTask.Result result = new BinTask(work, folder.toString(), STAMP, 1, false).run(bin, new Try(2, 8, false));
        assertThat(result.encoded()).isEqualTo(models.size());
        assertThat(rows(result.journals()))
                .extracting(Row::id)
                .isEqualTo(models.stream().map(PlannedModel::id).toList());
        // What the first attempt had done is written once, with the first row that is new; then 32 rows each.
        assertThat(result.journals()).hasSize(3);
        assertThat(rows(result.journals().subList(0, 1))).hasSize(Journal.MANY + 3);
        assertThat(rows(result.journals().subList(1, 2))).hasSize(Journal.MANY);
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
        Row.Failure failure = rows(result.journals()).get(0).failure();
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
            assertThat(rows(result.journals()))
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
        assertThat(rows(run(ends, 3, 3).journals())).extracting(Row::isFailed).containsExactly(true, false);
    }

    @Test
    void shouldGiveUpWhatExecutorsWereLostAt() throws Exception {
        String bin = Ledger.bin("run", 3);
        Losses.begin(ledger, bin, "a");
        Losses.begin(ledger, bin, "a");
        BinTask.Result result = run((model, threads, progress) -> row(model), 3, 9);
        assertThat(rows(result.journals()).get(0).failure().reason()).contains("executors were lost twice");
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
        assertThat(rows(never.journals()).get(0).failure().kind()).isEqualTo(Row.Kind.ROAD);
    }
}
