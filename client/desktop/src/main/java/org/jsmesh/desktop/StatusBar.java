package org.jsmesh.desktop;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.GridBagLayout;
import java.awt.GridLayout;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.JTextArea;

/** Progress, figures, messages and the two buttons below the picture. Used on the event dispatch thread. */
final class StatusBar {
    private static final int STEPS = 10_000;
    private static final Color GOOD = new Color(0x1a7f37);
    private static final Color BAD = new Color(0xb3261e);

    private final JPanel panel = new JPanel(new BorderLayout(0, 8));
    private final JProgressBar progress = new JProgressBar(0, STEPS);
    private final JLabel phase = new JLabel();
    private final JLabel figures = new JLabel();
    private final JTextArea message = new JTextArea();
    private final JButton moreDetail = new JButton("More detail");
    private final JButton original = new JButton("Original");
    private final Color plain = figures.getForeground();

    /** @param waitWords the wait of a round, for the tool tip */
    StatusBar(String waitWords, Runnable onMoreDetail, Runnable onOriginal) {
        phase.setFont(phase.getFont().deriveFont(Font.BOLD));
        figures.setFont(figures.getFont().deriveFont(figures.getFont().getSize2D() - 1));
        message.setEditable(false);
        message.setFocusable(false);
        message.setLineWrap(true);
        message.setWrapStyleWord(true);
        message.setOpaque(false);
        message.setBorder(null);
        message.setFont(figures.getFont());
        progress.setPreferredSize(new Dimension(10, 6));
        button(moreDetail, "Refine for another " + waitWords + " (Space)", onMoreDetail);
        button(original, "Load the rest: the original, bit for bit (O)", onOriginal);

        JPanel words = new JPanel(new GridLayout(2, 1, 0, 2));
        words.add(phase);
        words.add(figures);
        JPanel buttons = new JPanel(new GridLayout(1, 2, 8, 0));
        buttons.add(moreDetail);
        buttons.add(original);
        JPanel line = new JPanel(new BorderLayout(14, 0));
        line.add(words, BorderLayout.CENTER);
        // A grid bag keeps the buttons at their height in the middle.
        JPanel middle = new JPanel(new GridBagLayout());
        middle.add(buttons);
        line.add(middle, BorderLayout.LINE_END);
        panel.setBorder(BorderFactory.createEmptyBorder(10, 14, 12, 14));
        panel.add(progress, BorderLayout.NORTH);
        panel.add(line, BorderLayout.CENTER);
        panel.add(message, BorderLayout.SOUTH);
        show(ViewState.START);
    }

    JPanel component() {
        return panel;
    }

    void show(ViewState state) {
        boolean begun = state.progress() != null && state.progress().bytes() > 0;
        progress.setValue(begun ? (int) (STEPS * state.progress().fraction()) : 0);
        progress.setIndeterminate(!begun && state.phase() == ViewState.Phase.LOADING);
        figures.setText(begun ? Figures.line(state.progress(), state.levels()) : "");
        phase.setText(words(state.phase()));
        phase.setForeground(
                switch (state.phase()) {
                    case IDENTICAL -> GOOD;
                    case DIFFERENT, ERROR -> BAD;
                    default -> plain;
                });
        message.setText(state.message() == null ? "" : state.message());
        message.setForeground(state.phase() == ViewState.Phase.IDENTICAL ? plain : BAD);
        message.setVisible(state.message() != null);
        moreDetail.setEnabled(state.canRefine());
        original.setEnabled(state.canRefine());
    }

    private static String words(ViewState.Phase phase) {
        return switch (phase) {
            case LOADING -> "Loading …";
            case REFINING -> "Refining …";
            case CHECKING -> "Checking …";
            case IDLE -> "Ready";
            case IDENTICAL -> "✓ identical to the original";
            case INCOMPLETE -> "⚠ not the whole original";
            case DIFFERENT -> "✗ not the original";
            case ERROR -> "Stopped";
        };
    }

    private static void button(JButton button, String toolTip, Runnable action) {
        button.setToolTipText(toolTip);
        // The picture keeps the keyboard focus; both actions have a key of their own.
        button.setFocusable(false);
        button.addActionListener(e -> action.run());
    }
}
