package org.jsmesh.codec.lod;

import org.jsmesh.mesh.CornerTable;

/**
 * New numbers for the vertices and faces of a growing mesh, so that neighbours lie close together in memory. A new
 * vertex comes after the one that was split; faces are sorted by the first of their vertices. Without new numbers,
 * decoding a large mesh spends most of its time waiting for memory.
 */
public final class Renumbering {
    /** Old number of each new fan vertex. */
    public final int[] oldVertex;

    /** New number of each old fan vertex. */
    final int[] newVertex;

    /** New number of each old face. */
    public final int[] newFace;

    /** @param next fan vertex after each fan vertex, from 0 on, −1 after the last */
    public Renumbering(CornerTable table, int[] next) {
        int vertices = table.vertices();
        oldVertex = new int[vertices];
        newVertex = new int[vertices];
        newFace = new int[table.faces()];
        int at = 0;
        for (int v = 0; v >= 0; v = next[v]) {
            newVertex[v] = at;
            oldVertex[at++] = v;
        }
        numberFaces(table.data());
    }

    /** Sorts the faces by the smallest of their vertices' new numbers; those that share it keep their order. */
    private void numberFaces(int[] data) {
        int[] places = new int[oldVertex.length + 1]; // of the first face of each vertex, one further
        for (int f = 0; f < newFace.length; f++) {
            int first = firstVertex(data, CornerTable.STRIDE * f);
            newFace[f] = first;
            places[first + 1]++;
        }
        for (int v = 1; v < places.length; v++) places[v] += places[v - 1];
        for (int f = 0; f < newFace.length; f++) newFace[f] = places[newFace[f]]++;
    }

    private int firstVertex(int[] data, int at) {
        int first = Integer.MAX_VALUE;
        for (int j = 0; j < 3; j++) {
            int v = data[at + j];
            if (v != CornerTable.OUTSIDE) first = Math.min(first, newVertex[v]);
        }
        return first;
    }

    /** Gives a table the new numbers. */
    void apply(CornerTable table) {
        int[] corners = new int[oldVertex.length];
        for (int v = 0; v < corners.length; v++) corners[v] = corner(table.cornerOf(oldVertex[v]));
        for (int v = 0; v < corners.length; v++) table.setCornerOf(v, corners[v]);
        int[] data = table.data();
        int end = CornerTable.STRIDE * newFace.length;
        for (int at = 0; at < end; at += CornerTable.STRIDE) {
            for (int j = at; j < at + 3; j++) {
                int v = data[j];
                if (v >= 0) data[j] = newVertex[v];
                data[j + 4] = corner(data[j + 4]);
            }
        }
        moveFaces(data);
    }

    /** Moves rows in place, cycle by cycle. A second table would need more memory than anything else in a decoder. */
    private void moveFaces(int[] data) {
        int[] carried = new int[CornerTable.STRIDE];
        for (int f = 0; f < newFace.length; f++) {
            if (newFace[f] < 0) { // moved with an earlier one
                newFace[f] = ~newFace[f];
                continue;
            }
            int to = newFace[f];
            if (to == f) continue;
            System.arraycopy(data, CornerTable.STRIDE * f, carried, 0, CornerTable.STRIDE);
            while (to != f) {
                swap(carried, data, CornerTable.STRIDE * to);
                int next = newFace[to];
                newFace[to] = ~next;
                to = next;
            }
            System.arraycopy(carried, 0, data, CornerTable.STRIDE * f, CornerTable.STRIDE);
        }
    }

    private static void swap(int[] carried, int[] data, int at) {
        for (int j = 0; j < CornerTable.STRIDE; j++) {
            int kept = data[at + j];
            data[at + j] = carried[j];
            carried[j] = kept;
        }
    }

    private int corner(int corner) {
        return CornerTable.STRIDE * newFace[CornerTable.face(corner)] + (corner & 3);
    }

    /** Rows of {@code width} values per vertex in their new order, in an array of the same length. */
    public int[] vertexRows(int[] rows, int width) {
        int[] moved = new int[rows.length];
        for (int v = 0; v < oldVertex.length; v++)
            for (int j = 0; j < width; j++) moved[width * v + j] = rows[width * oldVertex[v] + j];
        return moved;
    }

    /** The same for faces; the array keeps what lies behind their rows. */
    public int[] faceRows(int[] rows, int width) {
        int[] moved = rows.clone();
        for (int f = 0; f < newFace.length; f++)
            for (int j = 0; j < width; j++) moved[width * newFace[f] + j] = rows[width * f + j];
        return moved;
    }
}
