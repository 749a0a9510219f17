package org.jsmesh.app.paper;

import java.util.List;
import java.util.Locale;

/** The five models of the paper with the figures of its tables 1 and 2, and files that hold them or stand for them. */
enum PaperModel {
    BUNNY(
            new Counts(2915, 1494, 531, 302),
            681,
            new Sizes(73_238, 13_984, 33.451),
            List.of("bunny", "stanford-bunny", "bun_zipper", "octopus")),
    DRAGON(
            new Counts(2730, 1257, 1704, 744),
            540,
            new Sizes(63_811, 37_328, 34.058),
            List.of("dragon", "gargo", "octopus")),
    HAND(
            new Counts(2130, 1055, 1852, 916),
            370,
            new Sizes(50_715, 42_960, 33.856),
            List.of("hand", "horse", "amphora")),
    CESSNA(
            new Counts(13_546, 6795, 5720, 2882),
            5040,
            new Sizes(528_002, 183_435, 25.653),
            List.of("cessna", "planetary-gear")),
    FANDISK(
            new Counts(12_946, 6475, 1518, 761),
            6477,
            new Sizes(280_979, 63_345, 25.089),
            List.of("fandisk", "planetary-gear"));

    /** Faces and vertices of the original and of the simplified model, of table 1. */
    record Counts(int faces, int vertices, int baseFaces, int baseVertices) {}

    /** Bytes of the original, of the simplified model and of a patch on average, of table 2. */
    record Sizes(long original, long base, double patch) {}

    final Counts counts;
    final int millis; // of table 1
    final Sizes sizes;

    /** Names of files without their ending: the model itself first, then what is like it. */
    final List<String> files;

    PaperModel(Counts counts, int millis, Sizes sizes, List<String> files) {
        this.counts = counts;
        this.millis = millis;
        this.sizes = sizes;
        this.files = files;
    }

    /** As the paper writes it. */
    String label() {
        return name().toLowerCase(Locale.ROOT);
    }
}
