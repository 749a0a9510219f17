package org.jsmesh.memory;

import java.util.BitSet;

/**
 * Corners of faces that follow each other in a text: how many differ, and how many differ in their place. They are told
 * apart by hashes, which takes little memory.
 */
final class CornerSample {
    private static final int BITS = 20;
    private static final int SPREAD = 0x9E3779B9;

    /** Corners by place in a sample from which on faces have attributes of their own. */
    private static final double SEPARATE = 1.5;

    private final BitSet wedges = new BitSet(1 << BITS);
    private final BitSet places = new BitSet(1 << BITS);
    private double corners;
    private double differentWedges;
    private double differentPlaces;
    private boolean hasCoordinates;
    private boolean hasNormals;

    /** Begins with others, which may have the same corners. */
    void next() {
        wedges.clear();
        places.clear();
    }

    /** @param corner as OBJ names them: the vertex, and perhaps others behind a slash */
    void take(String corner) {
        corners++;
        boolean isRelative = corner.startsWith("-"); // to the line, so that the same word is another corner
        int slash = corner.indexOf('/');
        int last = corner.lastIndexOf('/');
        hasCoordinates |= slash > 0 && slash + 1 != last && slash + 1 < corner.length();
        hasNormals |= last > slash && last + 1 < corner.length();
        if (isRelative || isNew(wedges, corner)) differentWedges++;
        if (isRelative || isNew(places, slash < 0 ? corner : corner.substring(0, slash))) differentPlaces++;
    }

    private static boolean isNew(BitSet seen, String word) {
        int bit = word.hashCode() * SPREAD >>> Integer.SIZE - BITS;
        if (seen.get(bit)) return false;
        seen.set(bit);
        return true;
    }

    /** Values of their attributes: few normals may be where no sample of a text is. */
    int channels() {
        return (hasNormals ? 3 : 0) + (hasCoordinates ? 2 : 0);
    }

    /** The part of the corners that differ from all others. */
    double part() {
        return corners == 0 ? 0 : differentWedges / corners;
    }

    /**
     * The wedges of a model.
     *
     * @param faces that it has
     * @param vertices of which no two have one place
     * @param attributes the most that it has of one kind, such as normals
     */
    double wedges(double faces, double vertices, double attributes) {
        boolean areOfFaces = differentWedges > SEPARATE * differentPlaces || attributes > SEPARATE * vertices;
        return areOfFaces ? 3 * faces * part() : attributes;
    }
}
