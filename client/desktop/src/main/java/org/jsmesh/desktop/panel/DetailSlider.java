package org.jsmesh.desktop.panel;

import java.awt.BorderLayout;
import java.util.function.IntConsumer;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import org.jsmesh.archive.BatchIndex;

/**
 * Chooses a resolution: any batch from the base to the newest that has arrived. At its right end it follows the newest.
 * Nothing is asked for. Used on the event dispatch thread.
 */
public final class DetailSlider {
    /** As a choice: whatever has come last. */
    public static final int NEWEST = -1;

    private final JPanel panel = new JPanel(new BorderLayout(0, 2));
    private final JSlider slider = new JSlider(0, 0, 0);
    private final JLabel words = new JLabel(" ");
    private final IntConsumer onChoice;
    private ModelFacts facts = ModelFacts.NONE;
    private int chosen = NEWEST;
    private boolean setting;

    /** @param onChoice hears a batch, or {@link #NEWEST} */
    public DetailSlider(IntConsumer onChoice) {
        this.onChoice = onChoice;
        slider.setToolTipText("Shows an earlier resolution of what has arrived ([ and ])");
        slider.getAccessibleContext().setAccessibleName("Level of detail");
        slider.addChangeListener(e -> {
            if (!setting) choose(slider.getValue());
        });
        panel.add(slider, BorderLayout.NORTH);
        panel.add(words, BorderLayout.CENTER);
        show(ModelFacts.NONE);
    }

    JPanel component() {
        return panel;
    }

    /** {@return whether the newest resolution is wanted} */
    public boolean isNewest() {
        return chosen == NEWEST;
    }

    /** @param now what has arrived by now */
    public void show(ModelFacts now) {
        boolean other = facts.header() != now.header();
        facts = now;
        if (other || chosen >= last()) chosen = NEWEST;
        setting = true;
        slider.setMaximum(Math.max(0, last()));
        slider.setValue(chosen == NEWEST ? Math.max(0, last()) : chosen);
        slider.setEnabled(last() > 0);
        setting = false;
        say();
    }

    /**
     * Goes to a finer or coarser resolution than the one that is shown: to the next one with other faces.
     *
     * @param finer which way
     */
    public void step(boolean finer) {
        if (last() < 1) return;
        BatchIndex index = facts.header().batches();
        int at = shown();
        int faces = index.faces(at);
        int next = at;
        while (finer ? next < last() : next > 0) {
            next += finer ? 1 : -1;
            if (index.faces(next) != faces) break;
        }
        // The last batches bring no faces, but what they bring belongs to these.
        if (finer && index.faces(next) == index.faces(last())) next = last();
        choose(next);
        setting = true;
        slider.setValue(next);
        setting = false;
    }

    private void choose(int batch) {
        int next = batch >= last() ? NEWEST : batch;
        if (next == chosen) return;
        chosen = next;
        say();
        onChoice.accept(next);
    }

    private int last() {
        return facts.batches() - 1;
    }

    /** {@return the batch after which the resolution is that is wanted; −1 when nothing has arrived} */
    public int shown() {
        return chosen == NEWEST ? last() : chosen;
    }

    private void say() {
        if (last() < 0) {
            words.setText(" ");
            return;
        }
        BatchIndex index = facts.header().batches();
        int at = shown();
        String level = index.level(at) == 0 ? "base mesh" : "level " + index.level(at);
        words.setText(Figures.count(index.faces(at)) + " faces, " + level + ", error "
                + Figures.percent(index.errorMean(at)));
    }
}
