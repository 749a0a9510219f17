package org.jsmesh.memory;

import java.io.IOException;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Counts by samples of the formats that are text: OBJ, OFF, Hoppe's, and STL. */
final class TextCount {
    /** Lines of faces are shorter than those of vertices. */
    private static final double CAUTION = 1.3;

    private static final Pattern OFF =
            Pattern.compile("\\s*(?i:((?:ST|C|N|4)*)OFF)?\\s*([0-9]{1,10})\\s+([0-9]{1,10})(?=\\s|$)");

    private double faces;
    private double leastFaces;
    private double vertices;
    private double wedges;
    private double normals;
    private double coordinates;
    private int channels;
    private boolean hasMaterials;
    private final CornerSample corners = new CornerSample();

    private TextCount() {}

    static ModelCount of(Sampled file) throws IOException {
        TextCount count = new TextCount();
        boolean isWhole = file.eachSample(0, count::take);
        int found = (count.normals > 0 ? 3 : 0) + (count.coordinates > 0 ? 2 : 0);
        count.channels = Math.max(found, count.corners.channels());
        count.leastFaces = isWhole ? .8 * count.faces : 0;
        if (count.faces == 0 && count.off(file)) return count.model(file);
        if (count.channels == 0 && StlCount.isText(file)) {
            count.vertices = count.faces * StlCount.places(3 * count.corners.part());
        } else if (isWhole) {
            count.wedges =
                    count.corners.wedges(count.faces, count.vertices, Math.max(count.normals, count.coordinates));
        } else {
            // vertices come first: half as many of them as faces, in lines of about the same length
            double lines = count.vertices + count.normals + count.coordinates + count.faces;
            double likely = lines / (count.normals + count.coordinates > 0 ? 4 : 3) * 2 * CAUTION;
            count.faces = Math.max(count.faces, likely);
            count.vertices = Math.max(count.vertices, likely / 2);
        }
        return count.model(file);
    }

    private ModelCount model(Sampled file) {
        return new ModelCount(faces, leastFaces, vertices, wedges, channels, file.length(), 0, true, hasMaterials);
    }

    /** Takes the counts in front of an OFF file. */
    private boolean off(Sampled file) throws IOException {
        String text = new String(file.start(), java.nio.charset.StandardCharsets.ISO_8859_1);
        if (text.startsWith(Sampled.BYTE_ORDER_MARK)) text = text.substring(Sampled.BYTE_ORDER_MARK.length());
        Matcher head = OFF.matcher(text.replaceAll("#.*", " "));
        if (!head.lookingAt()) return false;
        double most = file.length() / 4.0;
        vertices = Math.min(most, Double.parseDouble(head.group(2)));
        double polygons = Math.min(most, Double.parseDouble(head.group(3)));
        leastFaces = .8 * polygons;
        String flags = head.group(1) == null ? "" : head.group(1).toUpperCase(Locale.ROOT);
        channels = (flags.contains("N") ? 3 : 0) + (flags.contains("C") ? 4 : 0) + (flags.contains("ST") ? 2 : 0);
        FaceLines lines = FaceLines.of(file, 0);
        faces = polygons * (lines.any() ? lines.sides() : FaceLines.guess(file, head.end(), vertices, polygons, 0));
        hasMaterials = lines.colours() > 1;
        if (lines.colours() > ModelCount.PARTS) {
            channels += 4;
            wedges = 3 * faces;
        }
        return true;
    }

    private void take(String text, double weight) {
        corners.next();
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
            case "f", "fo" -> faces += weight * Math.max(1, corners(line) - 2);
            case "usemtl" -> hasMaterials = true;
            case "Face" -> faces += weight;
            default -> stl(line, line.substring(0, end), weight);
        }
    }

    private void stl(String line, String word, double weight) {
        if (word.equalsIgnoreCase("facet")) faces += weight;
        else if (word.equalsIgnoreCase("vertex")) corners.take(line);
    }

    /** Without the words of a comment behind them, and a mark that the line goes on. */
    private int corners(String line) {
        int words = 0;
        for (int at = 0; at < line.length() && line.charAt(at) != '#'; at++) {
            int from = at;
            while (at < line.length() && line.charAt(at) > ' ' && "#\\".indexOf(line.charAt(at)) < 0) at++;
            if (at == from) continue;
            if (words++ > 0) corners.take(line.substring(from, at));
            if (at < line.length() && line.charAt(at) == '#') break;
        }
        return words - 1;
    }
}
