package org.jsmesh.desktop.panel;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.LinearGradientPaint;
import java.util.Locale;
import javax.swing.JPanel;
import javax.swing.UIManager;
import org.jsmesh.desktop.draw.DrawStyle;
import org.jsmesh.desktop.draw.Palette;
import org.jsmesh.desktop.draw.Shading;

/** The scale of the colours of levels and errors: a larger number is brighter. */
final class Legend extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final int BAR = 12;
    private static final int HEIGHT = 34;
    private static final int STOPS = 10;

    private String from = "";
    private String to = "";

    Legend() {
        setOpaque(false);
        setPreferredSize(new Dimension(10, HEIGHT));
        setMinimumSize(getPreferredSize());
        setVisible(false);
    }

    /**
     * Shows the ends of the scale, or nothing where colours are those of the model.
     *
     * @param level the last one of the model
     * @param largest distance at the bright end, in units of the model; NaN while it is not known
     */
    void show(DrawStyle style, int level, double largest) {
        setVisible(style.shading().isPainted());
        boolean isLevels = style.shading() == Shading.LEVELS;
        from = isLevels ? "base mesh" : "0";
        if (isLevels) to = "level " + level;
        else if (largest == 0) to = "this is the newest";
        else to = Double.isNaN(largest) ? "measuring …" : String.format(Locale.ROOT, "%.3g", largest);
        String what = isLevels ? "Level of arrival" : "Distance to the newest mesh";
        getAccessibleContext().setAccessibleName(what + ": dark is " + from + ", bright is " + to);
        setToolTipText(what);
        repaint();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        float[] at = new float[STOPS];
        Color[] colours = new Color[STOPS];
        for (int i = 0; i < STOPS; i++) {
            at[i] = (float) i / (STOPS - 1);
            colours[i] = Palette.of((double) i / (STOPS - 1));
        }
        g.setPaint(new LinearGradientPaint(0, 0, Math.max(1, getWidth()), 0, at, colours));
        g.fillRect(0, 0, getWidth(), BAR);
        g.dispose();
        // Text of Swing's own settings.
        graphics.setFont(UIManager.getFont("Label.font"));
        graphics.setColor(UIManager.getColor("Label.foreground"));
        int base = BAR + graphics.getFontMetrics().getAscent() + 2;
        graphics.drawString(from, 0, base);
        graphics.drawString(to, getWidth() - graphics.getFontMetrics().stringWidth(to), base);
    }
}
