package org.jsmesh.spark;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.apache.spark.TaskContext;
import org.jsmesh.mesh.ProgressListener;

/**
 * Work on models that ends executors and takes all of their memory.
 *
 * @param work on all others
 * @param kills at the first attempt
 * @param killsAlways at each attempt
 * @param exhausts beside others
 * @param exhaustsAlways also alone
 */
record HardWork(ModelWork work, String kills, String killsAlways, String exhausts, String exhaustsAlways)
        implements ModelWork {
    private static final long serialVersionUID = 1;

    @Override
    public Row encode(PlannedModel model, int threads, ProgressListener progress)
            throws IOException, ModelChangedException {
        String id = model.id();
        if (id.equals(killsAlways) || id.equals(kills) && TaskContext.get().attemptNumber() == 0)
            Runtime.getRuntime().halt(1);
        boolean isAlone = Worker.gate().taken() == Worker.gate().capacity();
        if (id.equals(exhaustsAlways) || id.equals(exhausts) && !isAlone) {
            List<byte[]> all = new ArrayList<>();
            for (long sum = 0; sum < Runtime.getRuntime().maxMemory(); sum += 1 << 27) all.add(new byte[1 << 27]);
        }
        return work.encode(model, threads, progress);
    }
}
