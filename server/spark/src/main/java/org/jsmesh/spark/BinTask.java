package org.jsmesh.spark;

import java.io.IOException;
import java.io.Serializable;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.apache.spark.TaskContext;
import org.apache.spark.TaskKilledException;
import org.jsmesh.files.Explanation;
import org.jsmesh.memory.MemoryAdmission;
import org.jsmesh.mesh.ProgressListener;

/**
 * Encodes the models of a bin, as many at a time in an executor as fit its heap, and writes their rows into the
 * journal.
 *
 * <p>A task whose executor was lost is tried again by Spark, and goes more carefully then: each model alone, with a
 * note of it in the journal. A model at which executors are lost twice more is given up, so that one cannot stop a run.
 */
final class BinTask implements Serializable {
    private static final long serialVersionUID = 1;
    private static final int MOST_LOSSES = 2;

    private final ModelWork work;
    private final String report;
    private final Row.Stamp stamp;
    private final int cores;
    private final boolean alone;

    /**
     * @param report address of the report
     * @param cores of an executor
     * @param alone whether each model has an executor's heap for itself
     */
    BinTask(ModelWork work, String report, Row.Stamp stamp, int cores, boolean alone) {
        this.work = work;
        this.report = report;
        this.stamp = stamp;
        this.cores = cores;
        this.alone = alone;
    }

    /**
     * What came of a bin.
     *
     * @param encoded number of models
     * @param failed number of models
     * @param exhausted models that took more memory than there was, see {@link Packed}; they count as failed
     */
    record Result(int encoded, int failed, byte[] exhausted) implements Serializable {
        private static final long serialVersionUID = 1;
    }

    Result run(Bin bin) throws IOException, InterruptedException {
        TaskContext context = TaskContext.get();
        Ledger ledger = new Ledger(Worker.store(report));
        String journal = Ledger.journal(stamp.run(), bin.number());
        boolean careful = context.attemptNumber() > 0;
        List<Row> rows = new ArrayList<>();
        Set<String> done = new HashSet<>();
        if (careful && ledger.note(journal).isPresent()) ledger.read(journal, rows::add);
        rows.forEach(row -> done.add(row.id()));
        List<PlannedModel> exhausted = new ArrayList<>();
        for (PlannedModel model : bin.models()) {
            if (context.isInterrupted()) throw new TaskKilledException("another attempt has done the work");
            if (done.contains(model.id())) continue;
            Losses losses = careful ? Losses.begin(ledger, journal, model.id()) : Losses.NONE;
            Row row = losses.count() >= MOST_LOSSES ? givenUp(model) : encode(model, careful, context);
            if (row == null) {
                row = exhausted(model);
                exhausted.add(model);
            }
            rows.add(row);
            if (careful) ledger.writeJournal(journal, rows);
        }
        ledger.writeJournal(journal, rows);
        int failed = (int) rows.stream().filter(Row::isFailed).count();
        return new Result(rows.size() - failed, failed, Packed.planned(exhausted));
    }

    /** Null when the heap is too small. */
    private Row encode(PlannedModel model, boolean careful, TaskContext context)
            throws IOException, InterruptedException {
        MemoryAdmission gate = Worker.gate();
        try (MemoryAdmission.Admission room = alone || careful ? gate.admitAlone() : gate.admit(model.heapBytes())) {
            return work.encode(model, threads(room), new Stopping(context));
        } catch (OutOfMemoryError e) {
            return null;
        }
    }

    /** Of the cores that would be idle, as no other model fits beside this one. */
    private int threads(MemoryAdmission.Admission room) {
        long atATime = Worker.gate().capacity() / Math.max(1, room.bytes());
        return (int) Math.max(1, cores / Math.max(1, Math.min(cores, atATime)));
    }

    private Row exhausted(PlannedModel model) {
        Explanation words = Explanation.of(model.file().input(), new OutOfMemoryError());
        String how = alone ? ", also alone in an executor" : "";
        return failed(model, words.reason() + how, "Give executors more (--executor-memory)");
    }

    private Row givenUp(PlannedModel model) {
        return failed(
                model,
                "executors were lost twice while it was encoded alone",
                "Look at their logs, and give them more memory (--executor-memory, spark.executor.memoryOverhead)");
    }

    private Row failed(PlannedModel model, String reason, String remedy) {
        Row.Failure failure = new Row.Failure(model.file().input(), reason, remedy, Row.Kind.MEMORY);
        return new Row(model.id(), model.file(), stamp, "", "", null, failure, "", "");
    }

    /** Stops where Spark has given up the task. */
    private record Stopping(TaskContext context) implements ProgressListener {
        @Override
        public void progress(String stage, double fraction) {}

        @Override
        public boolean isCancelled() {
            return context.isInterrupted();
        }
    }
}
