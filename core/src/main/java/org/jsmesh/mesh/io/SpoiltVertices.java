package org.jsmesh.mesh.io;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Supplier;
import org.jsmesh.mesh.Note;

/**
 * Vertices with a coordinate that is no finite number. They cost nothing where no face uses them. A face that uses one
 * is refused, and so is a file of nothing else.
 */
final class SpoiltVertices {
    /** More refusals than these are not kept. */
    private static final int MOST_REFUSALS = 1000;

    private final List<ModelFormatException> refusals = new ArrayList<>();
    private final IntList vertices = new IntList();

    /**
     * Adds one, in their order; a second coordinate of the last one adds nothing.
     *
     * @param refusal makes what is thrown when a face uses the vertex
     */
    void add(int vertex, Supplier<ModelFormatException> refusal) {
        if (!isEmpty() && vertices.get(vertices.size() - 1) == vertex) return;
        if (refusals.size() < MOST_REFUSALS) refusals.add(refusal.get());
        vertices.add(vertex);
    }

    boolean isEmpty() {
        return vertices.size() == 0;
    }

    /**
     * Refuses corners that use one of them, and a file that has no others. Notes that they are left out.
     *
     * @param total number of all vertices of the file
     */
    void check(String file, int total, int[] cornerVertices, List<Note> notes) throws ModelFormatException {
        if (isEmpty()) return;
        if (vertices.size() == total) throw refusals.get(0);
        int[] sorted = vertices.toArray();
        for (int vertex : cornerVertices) {
            int found = Arrays.binarySearch(sorted, 0, vertices.size(), vertex);
            if (found < 0) continue;
            if (found < refusals.size()) throw refusals.get(found);
            throw new ModelFormatException(
                    file,
                    "",
                    "a coordinate of a vertex that a face uses is not a finite number",
                    "Repair or remove this vertex in the program that wrote the file");
        }
        int count = vertices.size();
        String text = Notes.plural(count, "vertex", "vertices") + " that " + (count == 1 ? "is" : "are")
                + " not finite and that no face uses left out.";
        notes.add(Note.dropped(text, count, refusals.get(0).place()));
    }

    /** The coordinates of the other vertices; asked before {@link Coordinates#offsets}. */
    Coordinates without(Coordinates positions) {
        return isEmpty() ? positions : positions.without(Arrays.copyOf(vertices.toArray(), vertices.size()));
    }

    /** The numbers that vertices of corners have among the others. */
    int[] renumbered(int[] cornerVertices) {
        if (isEmpty()) return cornerVertices;
        int[] sorted = Arrays.copyOf(vertices.toArray(), vertices.size());
        int[] numbers = new int[cornerVertices.length];
        for (int i = 0; i < numbers.length; i++)
            numbers[i] = cornerVertices[i] + 1 + Arrays.binarySearch(sorted, cornerVertices[i]);
        return numbers;
    }

    /** An attribute whose rows are those of vertices, as they were numbered before. */
    CornerAttribute kept(CornerAttribute attribute, int[] cornerVertices) {
        if (isEmpty() || attribute.cornerRows() != null) return attribute;
        return new CornerAttribute(
                attribute.semantic(),
                attribute.name(),
                attribute.components(),
                attribute.type(),
                attribute.rows(),
                cornerVertices);
    }
}
