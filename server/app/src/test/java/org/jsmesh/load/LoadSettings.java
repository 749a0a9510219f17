package org.jsmesh.load;

import java.util.List;
import java.util.Random;

/**
 * What a run does.
 *
 * @param viewers at the same time
 * @param seconds for which viewers who are done are replaced by new ones
 * @param arrivalSeconds over which the first ones come
 * @param restartSeconds when the server is ended and started again, from the beginning
 * @param waitMillis of a round, T
 * @param lookMillis longest time that viewers look at a model between two rounds
 * @param proxiedPercent viewers behind the proxy that injects faults
 * @param faultPercent rounds into which a viewer injects a fault itself, and connections into which the proxy does
 * @param decodeOneIn how many viewers one is among who decodes
 * @param longestExtraSeconds how long the last ones may take after that
 * @param sampleMillis between two looks at the server
 * @param heapMegabytes of the server
 * @param serverOptions further arguments of {@code jsm serve}
 * @param http2 what viewers speak, in place of HTTP/1.1
 */
record LoadSettings(
        int viewers,
        double seconds,
        double arrivalSeconds,
        List<Double> restartSeconds,
        int waitMillis,
        int lookMillis,
        long seed,
        int proxiedPercent,
        int faultPercent,
        int decodeOneIn,
        double longestExtraSeconds,
        int sampleMillis,
        int heapMegabytes,
        List<String> serverOptions,
        boolean http2) {
    /** How much longer than between rounds viewers look at the original. */
    private static final double LAST_LOOKS = 4;

    /** 500 viewers; the server restarts twice in the first third. */
    static LoadSettings soak(int viewers, double seconds, long seed) {
        List<Double> restarts = List.of(seconds / 6, seconds / 3);
        double arrivals = Math.min(30, seconds / 8);
        return new LoadSettings(
                viewers, seconds, arrivals, restarts, 2000, 3000, seed, 20, 6, 50, 180, 2000, 192, List.of(), false);
    }

    /** Few viewers with short rounds and many faults, in a good twenty seconds. */
    static LoadSettings brief() {
        return new LoadSettings(40, 14, 2, List.of(6.0), 600, 500, 1, 50, 25, 5, 120, 500, 96, List.of(), false);
    }

    LoadSettings withServerOptions(List<String> options) {
        return with(options, http2);
    }

    LoadSettings withHttp2(boolean spoken) {
        return with(serverOptions, spoken);
    }

    private LoadSettings with(List<String> options, boolean spoken) {
        return new LoadSettings(
                viewers,
                seconds,
                arrivalSeconds,
                restartSeconds,
                waitMillis,
                lookMillis,
                seed,
                proxiedPercent,
                faultPercent,
                decodeOneIn,
                longestExtraSeconds,
                sampleMillis,
                heapMegabytes,
                options,
                spoken);
    }

    /** How long a viewer looks at a model between two rounds: not at all, one time of three. */
    double pauseMillis(Random random) {
        return random.nextInt(3) == 0 ? 0 : random.nextInt(lookMillis);
    }

    /** How long a viewer looks at the original. */
    double lastLookMillis(Random random) {
        return random.nextDouble() * LAST_LOOKS * lookMillis;
    }
}
