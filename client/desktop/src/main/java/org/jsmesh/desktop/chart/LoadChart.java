package org.jsmesh.desktop.chart;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import java.util.function.DoubleFunction;
import javax.swing.JPanel;
import javax.swing.UIManager;

/**
 * Throughput (filled), faces (a line) and error (a dashed line) over the time of loading. The error's axis is
 * logarithmic: from a hundred-thousandth to all of its largest value. Used on the event dispatch thread.
 */
public final class LoadChart extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final int PARTS = 48;
    private static final int HEIGHT = 96;
    private static final double DECADES = 5;
    private static final Color RATE = new Color(0x4a90d9);
    private static final Color FACES = new Color(0x2a9d4b);
    private static final Color ERROR = new Color(0xd9772a);

    private final transient DoubleFunction<String> rateWords;
    private transient LoadRecord load = new LoadRecord();
    private int totalFaces;

    /** @param rateWords bytes per second in words */
    public LoadChart(DoubleFunction<String> rateWords) {
        this.rateWords = rateWords;
        setPreferredSize(new Dimension(PARTS * 5, HEIGHT));
        setMinimumSize(new Dimension(PARTS, HEIGHT));
        getAccessibleContext().setAccessibleName("Throughput, faces and error over the time of loading");
    }

    /**
     * Draws a record.
     *
     * @param record may change until the next call
     * @param total faces of the original
     */
    public void show(LoadRecord record, int total) {
        load = record;
        totalFaces = total;
        getAccessibleContext().setAccessibleDescription(words());
        repaint();
    }

    /** {@return what the chart shows, in words} */
    public String words() {
        double most = 0;
        for (double rate : load.rates(PARTS)) most = Math.max(most, rate);
        return String.format(
                java.util.Locale.ROOT,
                "Blue: throughput, up to %s. Green: faces. Orange: error. Over %.1f s of loading.",
                rateWords.apply(most),
                load.seconds());
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setColor(UIManager.getColor("TextField.background"));
        g.fillRect(0, 0, getWidth(), getHeight());
        double[] rates = load.rates(PARTS);
        double most = 0;
        for (double rate : rates) most = Math.max(most, rate);
        double[] shares = new double[PARTS];
        for (int i = 0; i < PARTS; i++) shares[i] = most > 0 ? rates[i] / most : 0;
        g.setColor(new Color(RATE.getRed(), RATE.getGreen(), RATE.getBlue(), 110));
        g.fill(steps(shares, true));
        int[] faces = load.faces(PARTS);
        for (int i = 0; i < PARTS; i++) shares[i] = totalFaces > 0 ? (double) faces[i] / totalFaces : 0;
        g.setColor(FACES);
        g.setStroke(new BasicStroke(1.6f));
        g.draw(steps(shares, false));
        g.setColor(ERROR);
        g.setStroke(new BasicStroke(1.4f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 10, new float[] {4, 3}, 0));
        g.draw(steps(logarithms(load.errors(PARTS)), false));
        g.setColor(UIManager.getColor("Component.borderColor"));
        g.setStroke(new BasicStroke(1));
        g.drawRect(0, 0, getWidth() - 1, getHeight() - 1);
        g.dispose();
    }

    /** Heights from 0 to 1; NaN where there is no mesh. */
    static double[] logarithms(double[] errors) {
        double most = 0;
        for (double error : errors) if (error > most) most = error;
        double[] heights = new double[errors.length];
        for (int i = 0; i < errors.length; i++) {
            if (Double.isNaN(errors[i])) heights[i] = Double.NaN;
            else if (errors[i] <= 0 || most <= 0) heights[i] = 0;
            else heights[i] = Math.max(0, 1 + Math.log10(errors[i] / most) / DECADES);
        }
        return heights;
    }

    private Path2D steps(double[] shares, boolean closed) {
        Path2D path = new Path2D.Double();
        double width = (double) getWidth() / shares.length;
        double height = getHeight() - 3.0;
        boolean begun = false;
        for (int i = 0; i < shares.length; i++) {
            if (Double.isNaN(shares[i])) continue;
            double y = 1 + height * (1 - shares[i]);
            if (begun) path.lineTo(i * width, y);
            else path.moveTo(i * width, closed ? getHeight() : y);
            if (!begun && closed) path.lineTo(i * width, y);
            begun = true;
            path.lineTo((i + 1) * width, y);
        }
        if (closed && begun) {
            path.lineTo(getWidth(), getHeight());
            path.closePath();
        }
        return path;
    }
}
