package org.jsmesh.app;

import java.io.IOException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.jsmesh.app.console.Output;
import org.jsmesh.app.heap.HeapPlan;
import org.jsmesh.app.heap.HeapSize;
import org.jsmesh.app.heap.Relaunch;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.files.EncodeJob;
import org.jsmesh.memory.MemoryEstimate;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** How much heap {@code jsm encode} takes. A mixin. */
final class HeapOptions {
    /** Models of many that are estimated before any is encoded. Each look takes a few milliseconds. */
    private static final int MOST_LOOKS = 500;

    private static final List<String> PACKED = List.of(".gz", ".zip", ".3mf", ".glb", ".gltf");
    private static final long PACKED_WEIGHT = 20;

    @Spec(Spec.Target.MIXEE)
    private CommandSpec spec;

    @Option(
            names = "--max-heap",
            paramLabel = "SIZE",
            description = {
                "Heap to take at most, such as 6g: the command starts itself again with it.",
                "Default: what the models need, up to four fifths of the memory; what Java's -Xmx says, if given."
            })
    private HeapSize wanted;

    @Option(
            names = "--no-relaunch",
            description = "Stay in this process with the heap that Java took, a quarter of the memory if not told.")
    private boolean stays;

    /**
     * Does the command in another process with another heap, if that is better.
     *
     * @return the exit code, or null when it is to be done here
     */
    Integer elsewhere(List<EncodeJob> jobs, EncoderSettings settings, Output output) throws InterruptedException {
        if (stays && wanted != null)
            throw new ParameterException(
                    spec.commandLine(),
                    "--max-heap takes another process, and --no-relaunch forbids it; give Java the heap: "
                            + wanted.option());
        Relaunch relaunch = stays ? null : ((Jsm) spec.root().userObject()).relaunch();
        if (relaunch == null) return null;
        HeapPlan plan = relaunch.plan();
        if (relaunch.obstacle() != null) {
            if (wanted != null && plan.forUser(wanted) != 0)
                output.error("--max-heap has no effect, because " + relaunch.obstacle() + ". Give Java the heap: "
                        + wanted.option());
            return null;
        }
        long heap = 0;
        if (wanted != null) heap = plan.forUser(wanted);
        else if (!plan.isChosen()) heap = heapFor(jobs, settings, plan);
        if (heap == 0) return null;
        try {
            int code = relaunch.run(new HeapSize(heap));
            if (Relaunch.isKilled(code)) {
                output.error("the process with a heap of " + (heap >> 20)
                        + " MiB was ended from outside, as systems do that are short of memory. Give less: --max-heap "
                        + (heap * 3 / 4 >> 20) + "m, or close other programs.");
            }
            return code;
        } catch (IOException e) {
            return null; // there is this process, at least
        }
    }

    /**
     * What the models need that take the most of those that can be encoded on this machine, as many as are encoded at a
     * time. The others are refused, with any heap.
     */
    static long heapFor(List<EncodeJob> jobs, EncoderSettings settings, HeapPlan plan) {
        List<MemoryEstimate> needs = new ArrayList<>();
        int looks = Math.max(MOST_LOOKS, settings.threads());
        for (EncodeJob job : likelyFirst(jobs)) {
            if (looks == 0) break;
            try {
                if (!Files.isRegularFile(job.input())) continue;
                looks--;
                MemoryEstimate need = MemoryEstimate.of(job.input(), settings);
                if (need.leastBytes() <= plan.mostBytes()) needs.add(need);
            } catch (IOException e) {
                // Reading it will tell.
            }
        }
        needs.sort(Collections.reverseOrder(Comparator.comparingLong(MemoryEstimate::bytes)));
        needs = needs.subList(0, Math.min(needs.size(), settings.threads()));
        long all = needs.stream().mapToLong(MemoryEstimate::bytes).sum();
        long least = needs.stream().mapToLong(MemoryEstimate::leastBytes).max().orElse(0);
        return plan.forWork(all, least);
    }

    private static List<EncodeJob> likelyFirst(List<EncodeJob> jobs) {
        if (jobs.size() <= MOST_LOOKS) return jobs;
        Map<EncodeJob, Long> weights = new IdentityHashMap<>();
        for (EncodeJob job : jobs) weights.put(job, weight(job));
        List<EncodeJob> sorted = new ArrayList<>(jobs);
        sorted.sort(Collections.reverseOrder(Comparator.comparingLong(weights::get)));
        return sorted;
    }

    /** Its bytes, more where a model may be packed in few of them or beside them. */
    private static long weight(EncodeJob job) {
        String name = job.input().toString().toLowerCase(Locale.ROOT);
        long bytes = job.input().toFile().length();
        return PACKED.stream().anyMatch(name::endsWith) ? PACKED_WEIGHT * bytes : bytes;
    }
}
