package org.jsmesh.load;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;

/** How the server was over time. Filled by one thread, read afterwards. */
final class Samples {
    private final List<Sample> samples = new ArrayList<>();

    /**
     * One look.
     *
     * @param seconds since the run began
     * @param start of the server that it belongs to, counted from 1
     * @param liveHeapMegabytes after a full collection; −1 when none was made
     * @param directBytes of direct buffers; −1 when not told
     * @param viewers at that time
     * @param load1 of the machine in the last minute
     * @param lagMillis the latest that a task of the viewers began after its time, since the look before
     */
    record Sample(
            double seconds,
            int start,
            ProcessFigures figures,
            int liveHeapMegabytes,
            double directBytes,
            int viewers,
            double load1,
            double lagMillis) {}

    /** A straight line through a quantity over the last minutes. */
    record Trend(double first, double last, double perMinute, int count) {}

    void add(Sample sample) {
        samples.add(sample);
    }

    List<Sample> all() {
        return samples;
    }

    static double direct(Map<String, Double> metrics) {
        return metrics.entrySet().stream()
                .filter(e -> e.getKey().startsWith("jvm_buffer_memory_used_bytes{")
                        && e.getKey().contains("\"direct\""))
                .mapToDouble(Map.Entry::getValue)
                .findFirst()
                .orElse(-1);
    }

    /** What a quantity does between two times, by least squares; NaN values are left out. */
    Trend trend(double fromSeconds, double toSeconds, ToDoubleFunction<Sample> quantity) {
        double n = 0;
        double x = 0;
        double y = 0;
        double xx = 0;
        double xy = 0;
        double first = Double.NaN;
        double last = Double.NaN;
        for (Sample s : samples) {
            double value = quantity.applyAsDouble(s);
            if (s.seconds() < fromSeconds || s.seconds() > toSeconds || Double.isNaN(value)) continue;
            if (n == 0) first = value;
            last = value;
            double t = s.seconds() / 60;
            n++;
            x += t;
            y += value;
            xx += t * t;
            xy += t * value;
        }
        double slope = n < 2 ? 0 : (n * xy - x * y) / (n * xx - x * x);
        return new Trend(first, last, slope, (int) n);
    }
}
