package org.jsmesh.app.paper;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/**
 * A table with what the paper has and what we have.
 *
 * @param name of its files
 * @param title above it
 * @param how it was measured
 * @param why our figures differ from the paper's, in one sentence
 * @param header of the columns
 * @param rows of texts
 */
record PaperTable(String name, String title, String how, String why, List<String> header, List<List<String>> rows) {
    private static final int WIDTH = 120;
    private static final String NUMBER = "-?[0-9,]+(\\.[0-9]+)?";

    PaperTable(String name, String title, String how, String why, List<String> header) {
        this(name, title, how, why, header, new ArrayList<>());
    }

    void row(String... cells) {
        if (cells.length != header.size()) throw new IllegalArgumentException(cells.length + " cells in " + name);
        rows.add(List.of(cells));
    }

    String markdown() {
        StringBuilder text = new StringBuilder("# " + title + "\n\n" + wrapped(how) + "\n\n");
        return text.append(grid())
                .append("\n")
                .append(wrapped(why))
                .append("\n")
                .toString();
    }

    /** Header and rows alone. */
    String grid() {
        StringBuilder text = new StringBuilder(line(header));
        List<String> rule = new ArrayList<>();
        for (int i = 0; i < header.size(); i++) rule.add(isOfNumbers(i) ? "---:" : "---");
        text.append(line(rule));
        for (List<String> row : rows) text.append(line(row));
        return text.toString();
    }

    private boolean isOfNumbers(int column) {
        return rows.stream().map(row -> row.get(column)).allMatch(c -> c.equals(Figures.NONE) || c.matches(NUMBER));
    }

    private static String line(List<String> cells) {
        return "| " + String.join(" | ", cells) + " |\n";
    }

    /** Numbers without the commas between thousands. */
    String csv() {
        StringBuilder text = new StringBuilder(csvLine(header));
        for (List<String> row : rows) text.append(csvLine(row));
        return text.toString();
    }

    private static String csvLine(List<String> cells) {
        return cells.stream()
                        .map(c -> c.equals(Figures.NONE) ? "" : c.matches(NUMBER) ? c.replace(",", "") : c)
                        .map(c -> c.matches(".*[\",].*") ? '"' + c.replace("\"", "\"\"") + '"' : c)
                        .collect(Collectors.joining(","))
                + "\n";
    }

    /** Lines of text, none too long. */
    static String wrapped(String text) {
        StringBuilder lines = new StringBuilder();
        int length = 0;
        for (String word : text.split(" ")) {
            boolean breaks = length > 0 && length + 1 + word.length() > WIDTH;
            if (length > 0) lines.append(breaks ? '\n' : ' ');
            length = breaks || length == 0 ? word.length() : length + 1 + word.length();
            lines.append(word);
        }
        return lines.toString();
    }
}
