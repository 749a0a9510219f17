package org.jsmesh.mesh;

import java.util.BitSet;
import java.util.List;

/**
 * A mesh that is refined, under numbers that stay: a vertex, a wedge and a face keep theirs for good, and new ones come
 * after the others. Some numbers of faces stand for none. Tells what has changed since somebody looked, so that a
 * viewer need not look at the whole mesh again.
 */
public interface GrowingMesh {
    /** Numbers of a corner in what {@link #corners} gives. */
    int CORNER = 6;

    /** {@return vertices shown now} */
    int vertices();

    /** {@return wedges shown now} */
    int wedges();

    /** {@return one more than the largest number of a face} */
    int faceNumbers();

    /** {@return faces shown now} */
    int faces();

    /** {@return the numbers of the faces shown now, in the order in which a copy of the mesh has them} */
    int[] shownFaces();

    /** {@return the attributes without values: what {@link #values} gives is of these kinds} */
    List<Channel> channels();

    /**
     * The vertices that are new, have moved, or have other faces, wedges or attributes around them than before; then
     * begins to collect anew.
     *
     * @return their numbers; the next call overwrites them
     */
    BitSet takeChanges();

    /**
     * Tells whether a vertex may have other faces or wedges around it, or other attributes, than before the last
     * {@link #takeChanges}. Around others of the changed vertices only positions differ.
     *
     * @param vertex its number
     * @return false when faces, wedges and attributes are the same
     */
    boolean isReshaped(int vertex);

    /**
     * Lists the vertices in an order in which neighbours are close to each other: whoever looks at many of them waits
     * less for memory in this order than in that of their numbers.
     *
     * @param place 0 to {@link #vertices} − 1
     * @return the number of the vertex at this place
     */
    int vertexAt(int place);

    /**
     * Where a new vertex comes from.
     *
     * @param vertex one that has come since the last {@link #takeChanges} but one
     * @return the vertex that it was split from, which has a smaller number; negative for none
     */
    int parent(int vertex);

    /**
     * A coordinate as it is shown now.
     *
     * @param vertex its number
     * @param axis 0 to 2
     * @return the coordinate in units of the model
     */
    float coordinate(int vertex, int axis);

    /**
     * Lists the corners around a vertex, in the order of their faces.
     *
     * @param vertex its number
     * @param corners takes {@value #CORNER} numbers each: the face; the corner's place in it, 0 to 2; its wedge; the
     *     vertices of the next corner and of the one before in the face; the material's place in the list of the model,
     *     negative for none
     * @return how many there are; when they are more than fit, the array has nothing of use
     */
    int corners(int vertex, int[] corners);

    /**
     * Tells whether a wedge lacks an attribute.
     *
     * @param channel its place in {@link #channels}
     * @param wedge its number
     * @return true when there are no values
     */
    boolean isAbsent(int channel, int wedge);

    /**
     * The values of a wedge as they are shown now.
     *
     * @param channel its place in {@link #channels}
     * @param wedge one that has the attribute
     * @return a channel of this one wedge, whose number there is 0; the next call overwrites it
     */
    Channel values(int channel, int wedge);
}
