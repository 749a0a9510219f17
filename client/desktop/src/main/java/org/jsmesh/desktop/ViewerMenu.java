package org.jsmesh.desktop;

import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.ButtonGroup;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.event.MenuEvent;
import javax.swing.event.MenuListener;
import org.jsmesh.desktop.draw.Shading;
import org.jsmesh.desktop.panel.PlainLabel;

/** The menus of a window. */
final class ViewerMenu {
    private static final int MOST_LETTERS = 80;

    private ViewerMenu() {}

    /**
     * Makes the menu bar.
     *
     * @param recent locations that were opened last
     * @param open opens one of them
     * @param forget forgets them all
     */
    static JMenuBar of(ViewerActions a, Supplier<List<String>> recent, Consumer<String> open, Runnable forget) {
        JMenu file = menu("File", 'F');
        file.add(a.newWindow);
        file.addSeparator();
        file.add(a.openFile);
        file.add(a.openAddress);
        file.add(a.paste);
        file.add(recent(recent, open, forget));
        file.addSeparator();
        file.add(a.saveShown);
        file.add(a.saveOriginal);
        file.add(a.saveArchive);
        file.add(a.savePicture);
        file.addSeparator();
        file.add(a.close);
        file.add(a.quit);

        JMenu view = menu("View", 'V');
        view.add(a.showAll);
        view.addSeparator();
        ButtonGroup group = new ButtonGroup();
        for (Shading shading : Shading.values()) {
            JMenuItem item = new JRadioButtonMenuItem(a.shadings.get(shading));
            group.add(item);
            view.add(item);
        }
        view.addSeparator();
        view.add(new JCheckBoxMenuItem(a.wireframe));
        view.addSeparator();
        view.add(new JCheckBoxMenuItem(a.sidePanel));
        view.add(new JCheckBoxMenuItem(a.dark));

        JMenu model = menu("Model", 'M');
        model.add(a.moreDetail);
        model.add(a.original);
        model.add(a.stop);
        model.add(a.tryNow);
        model.addSeparator();
        model.add(a.coarser);
        model.add(a.finer);
        model.addSeparator();
        model.add(a.reload);

        JMenu help = menu("Help", 'H');
        help.add(a.help);
        help.add(a.about);

        JMenuBar bar = new JMenuBar();
        bar.add(file);
        bar.add(view);
        bar.add(model);
        bar.add(help);
        return bar;
    }

    private static JMenu menu(String name, char mnemonic) {
        JMenu menu = new JMenu(name);
        menu.setMnemonic(mnemonic);
        return menu;
    }

    /** Filled when it is opened, because other windows open models, too. */
    private static JMenu recent(Supplier<List<String>> recent, Consumer<String> open, Runnable forget) {
        JMenu menu = new JMenu("Open again");
        menu.addMenuListener(new MenuListener() {
            @Override
            public void menuSelected(MenuEvent e) {
                menu.removeAll();
                List<String> locations = recent.get();
                for (String location : locations) menu.add(item(shortened(location), () -> open.accept(location)));
                if (locations.isEmpty()) {
                    JMenuItem none = new JMenuItem("Nothing was opened yet");
                    none.setEnabled(false);
                    menu.add(none);
                    return;
                }
                menu.addSeparator();
                menu.add(item("Forget these", forget));
            }

            @Override
            public void menuDeselected(MenuEvent e) {
                // Filled anew when it is opened.
            }

            @Override
            public void menuCanceled(MenuEvent e) {
                // Likewise.
            }
        });
        return menu;
    }

    private static JMenuItem item(String name, Runnable work) {
        JMenuItem item = PlainLabel.plain(new JMenuItem());
        item.setText(name);
        item.addActionListener(e -> work.run());
        return item;
    }

    /** The end of a long location, which tells it from others. */
    static String shortened(String location) {
        int excess = location.length() - MOST_LETTERS;
        return excess <= 0 ? location : "…" + location.substring(excess + 1);
    }
}
