package org.jsmesh.memory;

import java.io.IOException;

/** Counts by samples of the formats that are text: OBJ, OFF, Hoppe's, and STL. */
final class TextCount {
    /** Lines of faces are shorter than those of vertices. */
    private static final double CAUTION = 1.3;

    private double faces;
    private double vertices;
    private double normals;
    private double coordinates;
    private boolean hasMaterials;

    private TextCount() {}

    static ModelCount of(Sampled file) throws IOException {
        TextCount count = new TextCount();
        boolean whole = file.eachSample(0, count::take);
        int channels = (count.normals > 0 ? 3 : 0) + (count.coordinates > 0 ? 2 : 0);
        boolean isOff = count.faces == 0 && count.off(file);
        if (!whole && !isOff) {
            // vertices come first: half as many of them as faces, in lines of about the same length
            double lines = count.vertices + count.normals + count.coordinates + count.faces;
            double likely = lines / (count.normals + count.coordinates > 0 ? 4 : 3) * 2 * CAUTION;
            return new ModelCount(
                    Math.max(count.faces, likely),
                    0,
                    Math.max(count.vertices, likely / 2),
                    channels,
                    file.length(),
                    0,
                    true,
                    count.hasMaterials);
        }
        boolean isStl = channels == 0 && StlCount.isText(file);
        return new ModelCount(
                count.faces, .8 * count.faces, count.vertices, channels, file.length(), 0, !isStl, count.hasMaterials);
    }

    /** Takes the counts in front of an OFF file. */
    private boolean off(Sampled file) throws IOException {
        String[] words = new String(file.start(), java.nio.charset.StandardCharsets.ISO_8859_1)
                .replaceAll("#.*", " ")
                .strip()
                .split("\\s+", 5);
        int at = words[0].matches("[0-9]+") ? 0 : 1;
        if (at > 0 && !words[0].matches("[A-Za-z0-9]*OFF")) return false;
        if (words.length < at + 2 || !words[at].matches("[0-9]{1,10}") || !words[at + 1].matches("[0-9]{1,10}"))
            return false;
        double most = file.length() / 4.0;
        vertices = Math.min(most, Double.parseDouble(words[at]));
        faces = Math.min(most, Double.parseDouble(words[at + 1]));
        return true;
    }

    private void take(String text, double weight) {
        for (int at = 0; at < text.length(); ) {
            int end = text.indexOf('\n', at);
            if (end < 0) end = text.length();
            line(text.substring(at, end).strip(), weight);
            at = end + 1;
        }
    }

    private void line(String line, double weight) {
        int end = 0;
        while (end < line.length() && line.charAt(end) > ' ') end++;
        switch (line.substring(0, end)) {
            case "v", "Vertex" -> vertices += weight;
            case "vn" -> normals += weight;
            case "vt" -> coordinates += weight;
            case "f", "fo" -> faces += weight * Math.max(1, words(line) - 3);
            case "usemtl" -> hasMaterials = true;
            case "Face" -> faces += weight;
            default -> stl(line.substring(0, end), weight);
        }
    }

    private void stl(String word, double weight) {
        if (word.equalsIgnoreCase("facet")) faces += weight;
        else if (word.equalsIgnoreCase("vertex")) vertices += weight;
    }

    /** Without those of a comment behind them, and a mark that the line goes on. */
    private static int words(String line) {
        int words = 0;
        boolean before = false;
        for (int i = 0; i < line.length(); i++) {
            char c = line.charAt(i);
            if (c == '#') break;
            boolean in = c > ' ' && c != '\\';
            if (in && !before) words++;
            before = in;
        }
        return words;
    }
}
