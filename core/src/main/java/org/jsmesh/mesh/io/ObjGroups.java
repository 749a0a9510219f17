package org.jsmesh.mesh.io;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.Note;

/**
 * Objects, groups and smoothing groups of the faces of an OBJ file: lines {@code o}, {@code g} and {@code s}, each of
 * which counts until the next one. Several names of a group are one label.
 */
final class ObjGroups {
    private static final long MOST = 0xffffffffL;

    private final Names objects = new Names();
    private final Names groups = new Names();
    private final Runs smoothing = new Runs();
    private final Set<String> unknown = new LinkedHashSet<>();
    private boolean smooths;
    private boolean large;

    void object(String name, int polygon) {
        objects.set(name, polygon);
    }

    void group(String names, int polygon) {
        groups.set(names, polygon);
    }

    /** Off, on or a number; each but off smooths the edges between faces that have the same one. */
    void smoothing(String group, int polygon) {
        long number = group.matches("[0-9]{1,10}") ? Long.parseLong(group) : -1;
        if (group.equals("on")) number = 1;
        if (group.equals("off") || group.isEmpty()) number = 0;
        if (number < 0 || number > MOST) {
            unknown.add(group);
            number = 0;
        }
        smooths = true;
        large |= number > Integer.MAX_VALUE;
        smoothing.set((int) number, polygon);
    }

    void addTo(MeshAssembler assembler, PolygonList.Triangles triangles, int polygons, List<Note> notes) {
        if (!unknown.isEmpty())
            notes.add(Notes.unread(
                    "Smoothing groups that are no number, read as off: " + Notes.names(unknown) + ".", unknown));
        objects.addTo(assembler, FaceChannel.OBJECT, triangles, polygons);
        groups.addTo(assembler, FaceChannel.GROUP, triangles, polygons);
        if (!smooths) return;
        Channel.Type type = large ? Channel.Type.UINT32 : Channel.Type.INT32;
        int[] values = triangles.ofPolygons(smoothing.values(polygons));
        assembler.faceChannel(new FaceChannel(FaceChannel.SMOOTHING, 1, type, values, List.of()));
    }

    /** A number per polygon, as runs of equal ones; 0 before the first. */
    private static final class Runs {
        private final IntList starts = new IntList();
        private final IntList numbers = new IntList();

        void set(int number, int polygon) {
            int last = starts.size() - 1;
            if (last >= 0 && starts.get(last) == polygon) {
                numbers.set(last, number);
                return;
            }
            starts.add(polygon);
            numbers.add(number);
        }

        int[] values(int polygons) {
            int[] values = new int[polygons];
            for (int run = 0; run < starts.size(); run++) {
                int end = run + 1 < starts.size() ? starts.get(run + 1) : polygons;
                for (int polygon = starts.get(run); polygon < end; polygon++) values[polygon] = numbers.get(run);
            }
            return values;
        }
    }

    /** A name per polygon, the empty one before the first. */
    private static final class Names {
        private final Runs runs = new Runs();
        private final List<String> names = new ArrayList<>(List.of(""));
        private final Map<String, Integer> numbers = new HashMap<>(Map.of("", 0));

        void set(String name, int polygon) {
            runs.set(
                    numbers.computeIfAbsent(name, n -> {
                        names.add(n);
                        return names.size() - 1;
                    }),
                    polygon);
        }

        /** Names that no face has are left out. */
        void addTo(MeshAssembler assembler, String channel, PolygonList.Triangles triangles, int polygons) {
            if (names.size() == 1) return;
            int[] values = triangles.ofPolygons(runs.values(polygons));
            int[] labels = new int[names.size()];
            List<String> used = new ArrayList<>();
            for (int i = 0; i < values.length; i++) {
                if (labels[values[i]] == 0) {
                    used.add(names.get(values[i]));
                    labels[values[i]] = used.size();
                }
                values[i] = labels[values[i]] - 1;
            }
            if (used.isEmpty() || used.equals(List.of(""))) return;
            assembler.faceChannel(new FaceChannel(channel, 1, Channel.Type.INT32, values, used));
        }
    }
}
