package org.jsmesh.spark;

import java.io.IOException;
import java.io.Serializable;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import org.apache.spark.TaskKilledException;
import org.jsmesh.files.Explanation;
import org.jsmesh.memory.MemoryAdmission;
import org.jsmesh.mesh.ProgressListener;

/**
 * Encodes the models of a bin, as many at a time in an executor as fit its heap, and writes their rows into journals of
 * its own.
 *
 * <p>A task that is tried again goes more carefully: each model alone, with a note of it, and its rows are written at
 * once. A model at which executors are lost twice more is given up, so that one cannot stop a run. What earlier
 * attempts wrote is not done again. Only the journals count that are named in the result: attempts may go on that Spark
 * knows nothing of any more.
 */
final class BinTask implements Serializable {
    private static final long serialVersionUID = 1;
    private static final int MOST_LOSSES = 2;
    private static final int MOST_CHANGES = 3;

    private final ModelWork work;
    private final String report;
    private final Row.Stamp stamp;
    private final int cores;
    private final boolean alone;

    /**
     * @param report address of the report
     * @param cores of an executor; 0 for all of its machine
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
     * @param journals names of the journals with all rows
     */
    record Result(int encoded, int failed, byte[] exhausted, List<String> journals) implements Serializable {
        private static final long serialVersionUID = 1;
    }

    Result run(Bin bin, Attempt attempt) throws IOException, InterruptedException {
        Ledger ledger = new Ledger(Worker.store(report));
        String begin = Ledger.bin(stamp.run(), bin.number());
        Journal journal = new Journal(ledger, Ledger.attempt(stamp.run(), bin.number(), attempt.id()));
        boolean careful = attempt.number() > 0;
        Map<String, Row> done = new HashMap<>();
        if (careful)
            for (String earlier : ledger.journalsOf(begin)) ledger.read(earlier, row -> done.put(row.id(), row));
        int failed = 0;
        List<PlannedModel> exhausted = new ArrayList<>();
        List<PlannedModel> models = bin.models();
        for (PlannedModel model : models) {
            if (attempt.isInterrupted()) throw killed();
            Row row = done.get(model.id());
            boolean isNew = row == null;
            if (isNew) row = careful ? carefully(model, ledger, begin, attempt) : encode(model, false, attempt);
            if (row == null) row = exhausted(model);
            journal.add(row);
            if (isNew && careful) journal.write();
            if (row.isFailed()) failed++;
            if (row.isFailed() && row.failure().equals(exhausted(model).failure())) exhausted.add(model);
        }
        return new Result(models.size() - failed, failed, Packed.planned(exhausted), journal.end());
    }

    private static TaskKilledException killed() {
        return new TaskKilledException("another attempt has done the work");
    }

    /** Null when the heap is too small. */
    private Row carefully(PlannedModel model, Ledger ledger, String begin, Attempt attempt)
            throws IOException, InterruptedException {
        if (Losses.begin(ledger, begin, model.id()).count() >= MOST_LOSSES) return givenUp(model);
        try {
            return encode(model, true, attempt);
        } catch (InterruptedException | RuntimeException | LinkageError e) {
            Losses.end(ledger, begin);
            throw e;
        }
    }

    /** Null when the heap is too small. */
    private Row encode(PlannedModel planned, boolean careful, Attempt attempt) throws InterruptedException {
        PlannedModel model = planned;
        for (int i = 1; ; i++) {
            try (MemoryAdmission.Admission room = admit(model, careful, attempt)) {
                return work.encode(model, threads(room), new Stopping(attempt));
            } catch (ModelChangedException e) {
                model = e.now();
                if (i == MOST_CHANGES) return row(model, PlanTask.failure(model.file(), e.getCause()));
            } catch (OutOfMemoryError e) {
                return null;
            } catch (CancellationException e) {
                throw e;
            } catch (IOException | RuntimeException | StackOverflowError | AssertionError e) {
                // What the site did not take; what the model did is in the row that the work gives.
                if (attempt.isInterrupted() || Thread.currentThread().isInterrupted()) throw killed();
                return row(model, PlanTask.road(model.file(), e));
            }
        }
    }

    private MemoryAdmission.Admission admit(PlannedModel model, boolean careful, Attempt attempt)
            throws InterruptedException {
        MemoryAdmission gate = Worker.gate();
        long bytes = alone || careful ? gate.capacity() : model.heapBytes();
        MemoryAdmission.Admission room = gate.admit(bytes, attempt::isInterrupted);
        if (room == null) throw killed();
        return room;
    }

    /** Of the cores that would be idle, as no other model fits beside this one. */
    private int threads(MemoryAdmission.Admission room) {
        int all = cores > 0 ? cores : Runtime.getRuntime().availableProcessors();
        long atATime = Worker.gate().capacity() / Math.max(1, room.bytes());
        return (int) Math.max(1, all / Math.max(1, Math.min(all, atATime)));
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
        return row(model, new Row.Failure(model.file().input(), reason, remedy, Row.Kind.MEMORY));
    }

    private Row row(PlannedModel model, Row.Failure failure) {
        return new Row(model.id(), model.file(), stamp, "", "", null, failure, "", "");
    }

    /** Stops where Spark has given up the task. */
    private record Stopping(Attempt attempt) implements ProgressListener {
        @Override
        public void progress(String stage, double fraction) {}

        @Override
        public boolean isCancelled() {
            return attempt.isInterrupted();
        }
    }
}
