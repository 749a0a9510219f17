package org.jsmesh.desktop.panel;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.Insets;
import java.awt.Rectangle;
import java.util.List;
import java.util.function.DoubleSupplier;
import java.util.function.IntConsumer;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.ScrollPaneConstants;
import javax.swing.Scrollable;
import javax.swing.Timer;
import javax.swing.text.DefaultCaret;
import org.jsmesh.desktop.chart.LoadChart;
import org.jsmesh.desktop.chart.LoadRecord;
import org.jsmesh.desktop.draw.DrawStyle;

/** The column beside the picture. Used on the event dispatch thread. */
public final class SidePanel {
    private static final int WIDTH = 320;

    /** Time between two looks at what changes without being told: the eye, and the memory. */
    private static final int LOOK_MILLIS = 500;

    private final Column column = new Column(new Timer(LOOK_MILLIS, e -> fill()));
    private final JScrollPane scroll = new JScrollPane(
            column, ScrollPaneConstants.VERTICAL_SCROLLBAR_AS_NEEDED, ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
    private final JLabel detailTitle = title("Level of detail");
    private final DetailSlider detail;
    private final DoubleSupplier pixels;
    private final Legend legend = new Legend();
    private final JLabel legendTitle = title("Colours");
    private final JLabel chartTitle = title("Loading");
    private final LoadChart chart = new LoadChart(rate -> Figures.bytes(Math.round(rate)) + "/s");
    private final JTextArea chartWords = text();
    private final JPanel table = new JPanel(new GridBagLayout());
    private final JLabel proofTitle = title("Proof");
    private final JTextArea proof = text();
    private final JLabel notesTitle = title("Notes on the file");
    private final JTextArea notes = text();
    private List<Statistics.Row> rows = List.of();
    private ModelFacts facts = ModelFacts.NONE;
    private DrawStyle style = DrawStyle.defaults();
    private double largestError = Double.NaN;

    /**
     * @param onDetail hears the resolution that is chosen, see {@link DetailSlider}
     * @param pixels that the model's diagonal is long in the picture, where it is nearest to the eye; NaN when there is
     *     none
     */
    public SidePanel(IntConsumer onDetail, DoubleSupplier pixels) {
        this.pixels = pixels;
        detail = new DetailSlider(onDetail);
        column.add(detailTitle);
        column.add(detail.component());
        column.add(legendTitle);
        column.add(legend);
        column.add(chartTitle);
        column.add(chart);
        column.add(chartWords);
        column.add(title("Figures"));
        column.add(table);
        column.add(proofTitle);
        column.add(proof);
        column.add(notesTitle);
        column.add(notes);
        column.addFiller();
        scroll.setBorder(BorderFactory.createEmptyBorder());
        scroll.setPreferredSize(new Dimension(WIDTH, 10));
        scroll.getVerticalScrollBar().setUnitIncrement(16);
        show(ModelFacts.NONE, new LoadRecord());
        show(style);
    }

    /** {@return the panel} */
    public JComponent component() {
        return scroll;
    }

    /** {@return the control for resolutions} */
    public DetailSlider detail() {
        return detail;
    }

    /**
     * Shows what is known by now.
     *
     * @param now of the model
     * @param load of its loading
     */
    public void show(ModelFacts now, LoadRecord load) {
        facts = now;
        boolean begun = now.progress() != null && now.progress().bytes() > 0;
        for (JComponent part : List.of(detailTitle, detail.component(), chartTitle, chart)) part.setVisible(begun);
        detail.show(now);
        chart.show(load, now.header() == null ? 0 : now.header().faces());
        set(chartWords, load.seconds() > 0 ? chart.words() : "");
        fill();
        set(proof, Statistics.proof(now));
        proofTitle.setVisible(proof.isVisible());
        set(notes, Statistics.notes(now));
        notesTitle.setVisible(notes.isVisible());
        showLegend();
    }

    /** @param next how the picture is drawn from now on */
    public void show(DrawStyle next) {
        style = next;
        showLegend();
    }

    /** @param distance at the bright end of the scale of errors, in units of the model; NaN when it is not known */
    public void largestError(double distance) {
        largestError = distance;
        showLegend();
    }

    private void showLegend() {
        legend.show(style, facts.header() == null ? 0 : facts.header().levels().size(), largestError);
        legendTitle.setVisible(legend.isVisible());
    }

    private void fill() {
        Runtime runtime = Runtime.getRuntime();
        List<Statistics.Row> next = Statistics.rows(
                facts,
                detail.shown(),
                pixels.getAsDouble(),
                runtime.totalMemory() - runtime.freeMemory(),
                runtime.maxMemory());
        if (next.size() == rows.size() && table.getComponentCount() == 2 * next.size()) {
            for (int i = 0; i < next.size(); i++) {
                ((JLabel) table.getComponent(2 * i)).setText(next.get(i).name());
                JLabel value = (JLabel) table.getComponent(2 * i + 1);
                value.setText(next.get(i).value());
                value.setToolTipText(next.get(i).value());
            }
        } else {
            table.removeAll();
            for (int i = 0; i < next.size(); i++) addRow(i, next.get(i));
            table.revalidate();
        }
        rows = next;
    }

    private void addRow(int row, Statistics.Row fact) {
        GridBagConstraints at = new GridBagConstraints();
        at.gridy = row;
        at.anchor = GridBagConstraints.LINE_START;
        at.insets = new Insets(1, 0, 1, 10);
        JLabel name = new JLabel(fact.name());
        name.putClientProperty(FlatClientProperties.STYLE, "foreground: $Label.disabledForeground");
        table.add(name, at);
        at.gridx = 1;
        at.weightx = 1;
        at.fill = GridBagConstraints.HORIZONTAL;
        at.insets = new Insets(1, 0, 1, 0);
        JLabel value = new PlainLabel(fact.value());
        // A long one is cut off at its end instead of making the column wider.
        value.setMinimumSize(new Dimension(10, value.getPreferredSize().height));
        value.setToolTipText(fact.value());
        table.add(value, at);
    }

    private static void set(JTextArea area, String words) {
        if (!area.getText().equals(words)) area.setText(words);
        area.setVisible(!words.isEmpty());
    }

    private static JLabel title(String words) {
        JLabel label = new JLabel(words);
        label.putClientProperty(FlatClientProperties.STYLE, "font: bold");
        label.setBorder(BorderFactory.createEmptyBorder(12, 0, 4, 0));
        return label;
    }

    /** Words that can be selected and copied, such as hashes. */
    private static JTextArea text() {
        JTextArea area = new JTextArea();
        area.setEditable(false);
        // New words must not scroll the column to themselves.
        ((DefaultCaret) area.getCaret()).setUpdatePolicy(DefaultCaret.NEVER_UPDATE);
        area.setLineWrap(true);
        area.setWrapStyleWord(true);
        area.setOpaque(false);
        area.setMargin(new Insets(0, 0, 0, 0));
        area.setBorder(BorderFactory.createEmptyBorder(2, 0, 2, 0));
        area.putClientProperty(FlatClientProperties.STYLE, "font: $Label.font");
        return area;
    }

    /** As wide as there is room, as high as it needs. */
    private static final class Column extends JPanel implements Scrollable {
        private static final long serialVersionUID = 1L;
        private final transient Timer looks;
        private int row;

        /** @param looks run while the column is part of a window */
        Column(Timer looks) {
            super(new GridBagLayout());
            this.looks = looks;
            setBorder(BorderFactory.createEmptyBorder(0, 14, 12, 14));
        }

        @Override
        public Component add(Component part) {
            GridBagConstraints at = new GridBagConstraints();
            at.gridy = row++;
            at.weightx = 1;
            at.fill = GridBagConstraints.HORIZONTAL;
            at.anchor = GridBagConstraints.FIRST_LINE_START;
            super.add(part, at);
            return part;
        }

        @Override
        public void addNotify() {
            super.addNotify();
            looks.start();
        }

        @Override
        public void removeNotify() {
            looks.stop();
            super.removeNotify();
        }

        void addFiller() {
            GridBagConstraints at = new GridBagConstraints();
            at.gridy = row++;
            at.weighty = 1;
            super.add(Box.createGlue(), at);
        }

        @Override
        public Dimension getPreferredScrollableViewportSize() {
            return getPreferredSize();
        }

        @Override
        public int getScrollableUnitIncrement(Rectangle visible, int orientation, int direction) {
            return 16;
        }

        @Override
        public int getScrollableBlockIncrement(Rectangle visible, int orientation, int direction) {
            return visible.height;
        }

        @Override
        public boolean getScrollableTracksViewportWidth() {
            return true;
        }

        @Override
        public boolean getScrollableTracksViewportHeight() {
            return getParent() != null && getParent().getHeight() > getPreferredSize().height;
        }
    }
}
