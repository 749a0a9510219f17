package org.jsmesh.memory;

import java.io.IOException;
import java.util.HashSet;
import java.util.Set;

/** Lines of faces as PLY in text and OFF have them: the number of corners, their vertices, and perhaps a colour. */
final class FaceLines {
    /** Faces are behind the vertices, and take more than this part of a file. */
    private static final int PART = 4;

    private static final int LEAST_BYTES = 1 << 16;
    private static final double MOST_TRIANGLES = 4;

    private static final int MOST_COLOURS = 1000; // to remember

    private final int lead;
    private double lines;
    private double triangles;
    private final Set<String> colours = new HashSet<>();

    private FaceLines(int lead) {
        this.lead = lead;
    }

    /** @param lead numbers in front of the number of corners */
    static FaceLines of(Sampled file, int lead) throws IOException {
        FaceLines lines = new FaceLines(lead);
        long from = Math.min(file.length() - file.length() / PART, file.length() - LEAST_BYTES);
        file.eachSample(Math.max(0, from), (text, weight) -> {
            for (String line : text.split("\n"))
                lines.take(line.split("#", 2)[0].strip().split("\\s+"));
        });
        return lines;
    }

    private void take(String[] words) {
        if (words.length < lead + 4 || words[lead].length() > 6 || !isWhole(words[lead])) return;
        int corners = Integer.parseInt(words[lead]);
        int end = lead + 1 + corners;
        if (corners < 3 || words.length < end) return;
        for (int i = lead + 1; i < end; i++) if (!isWhole(words[i])) return;
        lines++;
        triangles += corners - 2;
        if (colours.size() < MOST_COLOURS)
            colours.add(String.join(" ", java.util.Arrays.asList(words).subList(end, words.length)));
    }

    private static boolean isWhole(String word) {
        return !word.isEmpty() && word.chars().allMatch(c -> c >= '0' && c <= '9');
    }

    boolean any() {
        return lines > 0;
    }

    /** Triangles for each face. */
    double sides() {
        return lines == 0 ? 1 : triangles / lines;
    }

    /** What stands behind faces, as many as differ. */
    int colours() {
        return colours.size();
    }

    /**
     * Triangles for each face where no face is at hand, by the bytes that are left for them.
     *
     * @param from where the lines of vertices begin
     * @param valueBytes of a face beside its corners
     */
    static double guess(Sampled file, int from, double vertices, double faces, double valueBytes) throws IOException {
        byte[] start = file.start();
        int ends = 0;
        int last = from;
        for (int at = from; at < start.length && ends < vertices; at++) {
            if (start[at] != '\n' && start[at] != '\r') continue;
            if (at > last) ends++; // of two marks the second ends nothing
            last = at + 1;
        }
        if (ends == 0 || faces < 1) return 1;
        double left = file.length() - from - vertices * (last - from) / ends;
        double corners = (left / faces - valueBytes - 2) / (Math.log10(Math.max(2, vertices)) + 1);
        return Math.max(1, Math.min(MOST_TRIANGLES, corners - 2));
    }
}
