package org.jsmesh.test.results;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** Rows of figures by name, of which some may be missing; a table in Markdown is its text. */
public final class ResultTable {
    private static final MathContext DIGITS = new MathContext(4);
    private static final double WHOLE = 1000;

    private final String head;
    private final List<ResultColumn> columns;
    private final Map<String, double[]> rows = new LinkedHashMap<>();

    /**
     * @param head of the column of names
     * @param columns the others
     */
    public ResultTable(String head, List<ResultColumn> columns) {
        this.head = head;
        this.columns = List.copyOf(columns);
    }

    String head() {
        return head;
    }

    List<ResultColumn> columns() {
        return columns;
    }

    Map<String, double[]> rows() {
        return rows;
    }

    /** The figures of a row, NaN where one is missing; null without such a row. */
    public double[] row(String name) {
        return rows.get(name);
    }

    /**
     * Adds a row or takes the place of one. Figures are rounded as the text has them.
     *
     * @param figures one per column, NaN for none
     */
    public void put(String name, double... figures) {
        if (figures.length != columns.size())
            throw new IllegalArgumentException(figures.length + " figures for " + columns.size() + " columns: " + name);
        rows.put(name, Arrays.stream(figures).map(x -> number(text(x))).toArray());
    }

    /** Reads rows from the lines of a table; its first two are its head. */
    void read(List<String> lines) {
        if (lines.size() < 2 || !lines.get(0).equals(toLines().get(0)))
            throw new IllegalArgumentException(
                    "the head of the table is not " + toLines().get(0));
        for (String line : lines.subList(2, lines.size())) {
            String[] cells = line.split("\\|", -1);
            if (cells.length != columns.size() + 3)
                throw new IllegalArgumentException("not a row of the table: " + line);
            double[] figures = new double[columns.size()];
            for (int i = 0; i < figures.length; i++) figures[i] = number(cells[i + 2].strip());
            rows.put(cells[1].strip(), figures);
        }
    }

    /** The table, a line each. */
    List<String> toLines() {
        List<String> lines = new ArrayList<>();
        lines.add("| " + head + " | " + columns.stream().map(ResultColumn::name).collect(Collectors.joining(" | "))
                + " |");
        lines.add("|---|" + "---:|".repeat(columns.size()));
        rows.forEach((name, figures) -> lines.add("| " + name + " | "
                + Arrays.stream(figures).mapToObj(ResultTable::text).collect(Collectors.joining(" | ")) + " |"));
        return lines;
    }

    private static double number(String cell) {
        return cell.isEmpty() ? Double.NaN : Double.parseDouble(cell);
    }

    /** Large figures are whole, others have four digits. */
    static String text(double figure) {
        if (Double.isNaN(figure)) return "";
        if (Math.abs(figure) >= WHOLE || figure == Math.rint(figure)) return Long.toString(Math.round(figure));
        return new BigDecimal(figure).round(DIGITS).stripTrailingZeros().toPlainString();
    }
}
