package org.jsmesh.desktop;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.GridBagLayout;
import java.awt.GridLayout;
import javax.swing.Action;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.JTextArea;
import javax.swing.UIManager;
import org.jsmesh.desktop.panel.Figures;

/** Progress, figures, messages and buttons below the picture. Used on the event dispatch thread. */
final class StatusBar {
    private static final int STEPS = 10_000;

    private final JPanel panel = new JPanel(new BorderLayout(0, 8));
    private final JProgressBar progress = new JProgressBar(0, STEPS);
    private final JLabel phase = new JLabel();
    private final JLabel figures = new JLabel();
    private final JTextArea message = new JTextArea();
    private final JButton tryNow;
    private final JButton stop;
    private ViewState state = ViewState.EMPTY;
    private String note;
    private String problem; // why nothing can be drawn; null where it can
    private boolean isFailure;
    private boolean pictured;

    StatusBar(ViewerActions actions) {
        phase.putClientProperty(FlatClientProperties.STYLE, "font: bold");
        figures.putClientProperty(FlatClientProperties.STYLE, "font: -1");
        message.setEditable(false);
        message.setFocusable(false);
        message.setLineWrap(true);
        message.setWrapStyleWord(true);
        message.setOpaque(false);
        message.setBorder(null);
        message.putClientProperty(FlatClientProperties.STYLE, "font: $Label.font");
        progress.setPreferredSize(new Dimension(10, 6));
        tryNow = button(actions.tryNow);
        stop = button(actions.stop);

        JPanel words = new JPanel(new GridLayout(2, 1, 0, 2));
        words.add(phase);
        words.add(figures);
        JPanel buttons = new JPanel(new FlowLayout(FlowLayout.TRAILING, 8, 0));
        buttons.add(tryNow);
        buttons.add(stop);
        buttons.add(button(actions.moreDetail));
        buttons.add(button(actions.original));
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
        show(state, false);
    }

    JPanel component() {
        return panel;
    }

    /** @param isPictured whether there is a picture; without one, its place has the message */
    void show(ViewState next, boolean isPictured) {
        state = next;
        pictured = isPictured;
        boolean begun = state.progress() != null && state.progress().bytes() > 0;
        boolean prepared = state.phase() == ViewState.Phase.PREPARING;
        double share = prepared ? state.prepared() : begun ? state.progress().fraction() : 0;
        progress.setValue((int) (STEPS * share));
        progress.setIndeterminate(!begun && state.phase() == ViewState.Phase.LOADING);
        figures.setText(begun ? Figures.line(state.progress(), state.levels()) : " ");
        phase.setText(words(state.phase()));
        phase.setForeground(
                switch (state.phase()) {
                    case IDENTICAL -> good();
                    case DIFFERENT, ERROR, RETRYING -> bad();
                    default -> plain();
                });
        tryNow.setVisible(state.phase() == ViewState.Phase.RETRYING);
        stop.setVisible(state.isBusy());
        say();
    }

    /** Says what became of a wish, until {@link #clearNote}. */
    void note(String words, boolean failure) {
        note = words;
        isFailure = failure;
        say();
    }

    void clearNote() {
        note(problem, problem != null);
    }

    /** Says why nothing can be drawn instead of no note, until null takes it back. */
    void problem(String words) {
        problem = words;
        clearNote();
    }

    private void say() {
        // Without a picture, its place has the message.
        String words = note == null && pictured ? state.message() : note;
        boolean isBoth = note != null && pictured && isTrouble() && state.message() != null;
        if (isBoth) words = note + "\n" + state.message();
        boolean failure = note == null || isBoth ? isTrouble() : isFailure;
        message.setText(words == null ? "" : words);
        message.setForeground(failure ? bad() : plain());
        message.setVisible(words != null);
        panel.revalidate();
    }

    private boolean isTrouble() {
        return switch (state.phase()) {
            case ERROR, DIFFERENT, INCOMPLETE, RETRYING -> true;
            default -> false;
        };
    }

    private static Color plain() {
        return UIManager.getColor("Label.foreground");
    }

    private static Color good() {
        return UIManager.getColor("Actions.Green");
    }

    private static Color bad() {
        return UIManager.getColor("Actions.Red");
    }

    private static String words(ViewState.Phase phase) {
        return switch (phase) {
            case EMPTY -> "No model";
            case PREPARING -> "Preparing …";
            case LOADING -> "Loading …";
            case REFINING -> "Refining …";
            case RETRYING -> "Connection lost";
            case CHECKING -> "Checking …";
            case IDLE -> "Ready";
            case IDENTICAL -> "✓ identical to the original";
            case INCOMPLETE -> "⚠ not the whole original";
            case DIFFERENT -> "✗ not the original";
            case ERROR -> "Stopped";
        };
    }

    private static JButton button(Action action) {
        JButton button = new JButton(action);
        // The picture keeps the keyboard focus; each action has a key of its own.
        button.setFocusable(false);
        return button;
    }
}
