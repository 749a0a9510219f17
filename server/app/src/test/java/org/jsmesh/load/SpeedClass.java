package org.jsmesh.load;

import java.util.List;

/**
 * Viewers of one bandwidth.
 *
 * @param name for people
 */
record SpeedClass(String name, double bitsPerSecond) {
    /** From a poor mobile connection to a good one at home; as many viewers of each. */
    static final List<SpeedClass> ALL = List.of(
            new SpeedClass("256 kbit/s", 256e3),
            new SpeedClass("1 Mbit/s", 1e6),
            new SpeedClass("4 Mbit/s", 4e6),
            new SpeedClass("10 Mbit/s", 10e6),
            new SpeedClass("25 Mbit/s", 25e6),
            new SpeedClass("50 Mbit/s", 50e6));
}
