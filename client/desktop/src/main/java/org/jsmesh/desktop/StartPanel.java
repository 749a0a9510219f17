package org.jsmesh.desktop;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.GridBagLayout;
import java.awt.Insets;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.Action;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.SwingConstants;
import javax.swing.UIManager;
import org.jsmesh.desktop.panel.PlainLabel;

/** What a window without a picture shows: what to do, what was opened last, and why there is no picture. */
final class StartPanel {
    private static final int WIDTH = 520;
    private static final int MOST_RECENT = 6;

    private final JPanel panel = new JPanel(new GridBagLayout());
    private final JPanel column = new JPanel();
    private final JLabel title = new JLabel();
    private final JTextArea words = new JTextArea();
    private final JPanel buttons = new JPanel();
    private final JPanel recent = new JPanel();
    private final Consumer<String> open;

    /** @param open opens a location */
    StartPanel(ViewerActions actions, Consumer<String> open) {
        this.open = open;
        column.setLayout(new BoxLayout(column, BoxLayout.PAGE_AXIS));
        title.putClientProperty(FlatClientProperties.STYLE, "font: bold +6");
        words.setEditable(false);
        words.setFocusable(false);
        words.setLineWrap(true);
        words.setWrapStyleWord(true);
        words.setOpaque(false);
        words.setMargin(new Insets(0, 0, 0, 0));
        words.putClientProperty(FlatClientProperties.STYLE, "font: $Label.font");
        buttons.setLayout(new BoxLayout(buttons, BoxLayout.LINE_AXIS));
        for (Action action : List.of(actions.openFile, actions.openAddress)) {
            JButton button = new JButton(action);
            button.setFocusable(false);
            buttons.add(button);
            buttons.add(Box.createHorizontalStrut(8));
        }
        recent.setLayout(new BoxLayout(recent, BoxLayout.PAGE_AXIS));
        add(title, 0);
        add(words, 10);
        add(buttons, 16);
        add(recent, 20);
        panel.add(column);
        show(ViewState.EMPTY, List.of());
    }

    private void add(JComponent part, int gap) {
        column.add(Box.createVerticalStrut(gap));
        part.setAlignmentX(Component.LEFT_ALIGNMENT);
        column.add(part);
    }

    JComponent component() {
        return panel;
    }

    /**
     * Says what is going on.
     *
     * @param locations that were opened last
     */
    void show(ViewState state, List<String> locations) {
        boolean failed = state.phase() == ViewState.Phase.ERROR;
        boolean free = failed || state.phase() == ViewState.Phase.EMPTY;
        title.setText(
                switch (state.phase()) {
                    case ERROR -> "The model cannot be shown";
                    case EMPTY -> "Open a model";
                    case RETRYING -> "Connection lost";
                    case IDLE -> "Nothing has arrived yet";
                    default -> "Opening …";
                });
        words.setForeground(UIManager.getColor(failed ? "Actions.Red" : "Label.foreground"));
        words.setText(
                state.message() != null
                        ? state.message()
                        : free
                                ? "Drop a file on this window, or paste the address of a model. An archive (.jsm), a"
                                        + " manifest, the page that shows a model, or a file of another format: PLY, OBJ"
                                        + " with its materials and images, STL, OFF, Hoppe .m, 3MF, glTF."
                                : "");
        words.setPreferredSize(null);
        words.setSize(new Dimension(WIDTH, Short.MAX_VALUE));
        Dimension size = new Dimension(WIDTH, words.getPreferredSize().height);
        words.setPreferredSize(size);
        words.setMaximumSize(size);
        buttons.setVisible(free);
        recent.removeAll();
        if (free && !locations.isEmpty()) {
            JLabel heading = new JLabel("Opened last");
            heading.putClientProperty(FlatClientProperties.STYLE, "foreground: $Label.disabledForeground");
            recent.add(heading);
            for (String location : locations.subList(0, Math.min(MOST_RECENT, locations.size()))) {
                recent.add(link(location));
            }
        }
        panel.revalidate();
        panel.repaint();
    }

    private JButton link(String location) {
        JButton link = PlainLabel.plain(new JButton());
        link.setText(ViewerMenu.shortened(location));
        link.setHorizontalAlignment(SwingConstants.LEADING);
        link.setFocusable(false);
        link.putClientProperty(FlatClientProperties.BUTTON_TYPE, FlatClientProperties.BUTTON_TYPE_BORDERLESS);
        link.putClientProperty(FlatClientProperties.STYLE, "margin: 2,0,2,0");
        link.addActionListener(e -> open.accept(location));
        return link;
    }
}
