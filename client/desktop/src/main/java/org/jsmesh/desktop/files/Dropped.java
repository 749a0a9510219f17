package org.jsmesh.desktop.files;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.awt.dnd.DnDConstants;
import java.awt.dnd.DropTargetAdapter;
import java.awt.dnd.DropTargetDragEvent;
import java.awt.dnd.DropTargetDropEvent;
import java.io.File;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import org.jsmesh.mesh.io.ModelFormat;

/** What is dropped on a window, or pasted: files, or addresses as text. */
public final class Dropped extends DropTargetAdapter {
    private final Consumer<List<String>> onDrop;

    /** @param onDrop hears the locations, at least one */
    public Dropped(Consumer<List<String>> onDrop) {
        this.onDrop = onDrop;
    }

    /**
     * Finds what can be opened.
     *
     * @param data files, or text with an address in each line
     * @return locations; of several files the archives and models alone, because materials and images come with them
     */
    public static List<String> locations(Transferable data) {
        try {
            if (data == null) return List.of();
            if (data.isDataFlavorSupported(DataFlavor.javaFileListFlavor))
                return ofFiles((List<?>) data.getTransferData(DataFlavor.javaFileListFlavor));
            if (data.isDataFlavorSupported(DataFlavor.stringFlavor))
                return ofText((String) data.getTransferData(DataFlavor.stringFlavor));
        } catch (UnsupportedFlavorException | IOException e) {
            // Whoever had it has withdrawn it.
        }
        return List.of();
    }

    private static List<String> ofFiles(List<?> files) {
        List<String> all = new ArrayList<>();
        List<String> models = new ArrayList<>();
        for (Object file : files) {
            if (!(file instanceof File dropped)) continue;
            all.add(dropped.getPath());
            String name = dropped.getName().toLowerCase(Locale.ROOT);
            if (name.endsWith(".jsm") || ModelFormat.ofName(name) != null) models.add(dropped.getPath());
        }
        return models.isEmpty() ? all : models;
    }

    private static List<String> ofText(String text) {
        // Lists of addresses have comments that begin with #.
        return text.lines()
                .map(String::strip)
                .filter(line -> !line.isEmpty() && !line.startsWith("#"))
                .limit(UserSettings.MOST_RECENT)
                .toList();
    }

    @Override
    public void dragEnter(DropTargetDragEvent event) {
        if (isWelcome(event.isDataFlavorSupported(DataFlavor.javaFileListFlavor), event))
            event.acceptDrag(DnDConstants.ACTION_COPY);
        else event.rejectDrag();
    }

    private static boolean isWelcome(boolean files, DropTargetDragEvent event) {
        return files || event.isDataFlavorSupported(DataFlavor.stringFlavor);
    }

    @Override
    public void drop(DropTargetDropEvent event) {
        event.acceptDrop(DnDConstants.ACTION_COPY);
        List<String> found = locations(event.getTransferable());
        event.dropComplete(!found.isEmpty());
        if (!found.isEmpty()) onDrop.accept(found);
    }
}
