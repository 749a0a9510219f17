package org.jsmesh.app.paper;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;

/**
 * Processor time of work of one thread, once it is compiled. Other programs do not change it much.
 *
 * @param warmUpMillis that the work runs before it is measured
 */
record Timing(double warmUpMillis) {
    static final Timing USUAL = new Timing(1000);
    private static final int LEAST_WARM_UPS = 3;
    private static final int RUNS = 5;
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    /** Median of five runs in milliseconds. */
    double median(Runnable work) {
        double begin = millis();
        for (int i = 0; i < LEAST_WARM_UPS || millis() - begin < warmUpMillis; i++) work.run();
        double[] times = new double[RUNS];
        for (int i = 0; i < RUNS; i++) {
            double start = millis();
            work.run();
            times[i] = millis() - start;
        }
        return Figures.median(times);
    }

    private static double millis() {
        return THREADS.getCurrentThreadCpuTime() / 1e6;
    }
}
