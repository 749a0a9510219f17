package org.jsmesh.desktop.dialog;

import java.awt.Component;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.filechooser.FileFilter;
import javax.swing.filechooser.FileNameExtensionFilter;
import org.jsmesh.desktop.panel.PlainLabel;
import org.jsmesh.mesh.io.ModelFormat;

/** Dialogs in front of a window. */
public final class SwingDialogs implements Dialogs {
    private static final int FIELD = 46;

    private final Component window;

    /** @param window in front of which they open */
    public SwingDialogs(Component window) {
        this.window = window;
    }

    @Override
    public List<Path> open(Path folder) {
        JFileChooser chooser = new JFileChooser(folder == null ? null : folder.toFile());
        chooser.setDialogTitle("Open a model");
        chooser.setMultiSelectionEnabled(true);
        chooser.setFileFilter(new FileFilter() {
            @Override
            public boolean accept(File file) {
                String name = file.getName().toLowerCase(Locale.ROOT);
                return file.isDirectory()
                        || name.endsWith(".jsm")
                        || name.endsWith(".zip")
                        || ModelFormat.ofName(name) != null;
            }

            @Override
            public String getDescription() {
                return "Archives and models (jsm, ply, obj, stl, off, m, 3mf, gltf, glb, gz, zip)";
            }
        });
        if (chooser.showOpenDialog(window) != JFileChooser.APPROVE_OPTION) return List.of();
        return Arrays.stream(chooser.getSelectedFiles()).map(File::toPath).toList();
    }

    @Override
    public String address(String suggestion) {
        JTextField field = new JTextField(suggestion, FIELD);
        JPanel panel = new JPanel(new java.awt.BorderLayout(0, 6));
        panel.add(
                new JLabel("Address of an archive, of a manifest, or of the page that shows a model:"),
                java.awt.BorderLayout.NORTH);
        panel.add(field, java.awt.BorderLayout.CENTER);
        JOptionPane pane = new JOptionPane(panel, JOptionPane.PLAIN_MESSAGE, JOptionPane.OK_CANCEL_OPTION) {
            private static final long serialVersionUID = 1L;

            @Override
            public void selectInitialValue() {
                field.requestFocusInWindow();
                field.selectAll();
            }
        };
        pane.createDialog(window, "Open an address").setVisible(true);
        boolean ok = Integer.valueOf(JOptionPane.OK_OPTION).equals(pane.getValue());
        return ok && !field.getText().isBlank() ? field.getText() : null;
    }

    @Override
    public Path save(String title, Path suggestion, boolean isArchive) {
        JFileChooser chooser = chooser(title, suggestion);
        if (isArchive) {
            chooser.addChoosableFileFilter(new FileNameExtensionFilter("Archive (*.jsm)", "jsm"));
        } else {
            for (ModelFormat format : List.of(
                    ModelFormat.GLB,
                    ModelFormat.OBJ,
                    ModelFormat.PLY,
                    ModelFormat.STL,
                    ModelFormat.OFF,
                    ModelFormat.HOPPE_M)) {
                chooser.addChoosableFileFilter(new FileNameExtensionFilter(
                        format.title() + " (*." + format.extension() + ")", format.extension()));
            }
            ModelFormat suggested = ModelFormat.toWrite(suggestion.toString());
            for (FileFilter filter : chooser.getChoosableFileFilters()) {
                if (suggested != null && extension(filter).equals(suggested.extension())) chooser.setFileFilter(filter);
            }
        }
        return chosen(chooser, !isArchive);
    }

    @Override
    public Path savePicture(Path suggestion) {
        JFileChooser chooser = chooser("Save the picture", suggestion);
        chooser.setFileFilter(new FileNameExtensionFilter("PNG (*.png)", "png"));
        return chosen(chooser, false);
    }

    private static JFileChooser chooser(String title, Path suggestion) {
        JFileChooser chooser = new JFileChooser();
        chooser.setDialogTitle(title);
        chooser.setAcceptAllFileFilterUsed(false);
        chooser.setSelectedFile(suggestion.toFile());
        return chooser;
    }

    private static String extension(FileFilter filter) {
        return ((FileNameExtensionFilter) filter).getExtensions()[0];
    }

    /**
     * Brings name and format together.
     *
     * @param extension of the format, with its dot
     * @param isChosen whether the user has chosen that format, or else it was suggested
     * @param isModel whether there are other formats, whose extensions a name may have instead
     */
    static Path named(Path file, String extension, boolean isChosen, boolean isModel) {
        Path last = file.getFileName();
        if (last == null) return file; // the root of a disk, which nothing can be saved as
        String name = last.toString();
        if (name.toLowerCase(Locale.ROOT).endsWith(extension)) return file;
        boolean isOther = isModel && ModelFormat.toWrite(name) != null;
        if (isOther && !isChosen) return file;
        String stem = isOther ? name.substring(0, name.lastIndexOf('.')) : name;
        return file.resolveSibling(stem + extension);
    }

    private Path chosen(JFileChooser chooser, boolean isModel) {
        FileFilter suggested = chooser.getFileFilter();
        if (chooser.showSaveDialog(window) != JFileChooser.APPROVE_OPTION) return null;
        FileFilter filter = chooser.getFileFilter();
        Path file = named(chooser.getSelectedFile().toPath(), "." + extension(filter), filter != suggested, isModel);
        if (Files.exists(file)
                && JOptionPane.showConfirmDialog(
                                window,
                                PlainLabel.lines(file + " is there. Replace it?"),
                                "jSM",
                                JOptionPane.OK_CANCEL_OPTION)
                        != JOptionPane.OK_OPTION) return null;
        return file;
    }

    @Override
    public void tell(String title, String words) {
        JOptionPane.showMessageDialog(window, PlainLabel.lines(words), title, JOptionPane.PLAIN_MESSAGE);
    }
}
