package org.jsmesh.app.paper;

import java.util.List;

/**
 * A link to measure over.
 *
 * @param name as the tables have it
 * @param bitsPerSecond towards the client
 * @param delayMillis of a round trip
 */
record LinkKind(String name, double bitsPerSecond, long delayMillis) {
    /** Those of the paper: 100BaseT, 10BaseT and PHS. It does not tell their round trips. */
    static final List<LinkKind> ALL = List.of(
            new LinkKind("100 Mbit/s", 100e6, 1),
            new LinkKind("10 Mbit/s", 10e6, 1),
            new LinkKind("64 kbit/s", 64e3, 100));

    String described() {
        return name + " with " + delayMillis + " ms from end to end and back";
    }
}
