package org.jsmesh.desktop.panel;

import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JToolTip;
import org.jsmesh.archive.PlainText;

/**
 * A label for words that somebody else wrote: a model, a server, a link. Swing takes a text that begins with
 * {@code <html>} for a page and would fetch its images; this one shows the letters, also in its tool tip.
 */
public final class PlainLabel extends JLabel {
    private static final long serialVersionUID = 1L;
    private static final String HTML_DISABLED = "html.disable";

    /** @param words to be shown; control characters are replaced */
    public PlainLabel(String words) {
        plain(this).setText(PlainText.of(words));
    }

    /**
     * Makes a component show its text letter by letter.
     *
     * @param <T> what it is
     * @param component a label, a button or an item of a menu, before it has its text
     * @return the component
     */
    public static <T extends JComponent> T plain(T component) {
        component.putClientProperty(HTML_DISABLED, Boolean.TRUE);
        return component;
    }

    /**
     * The message of a dialog.
     *
     * @param words of one line or several
     * @return a label for each line
     */
    public static Object[] lines(String words) {
        // An empty label would be no line at all.
        return words.lines()
                .map(line -> new PlainLabel(line.isEmpty() ? " " : line))
                .toArray();
    }

    @Override
    public JToolTip createToolTip() {
        return plain(super.createToolTip());
    }
}
