package org.jsmesh.display;

import java.nio.ByteBuffer;
import java.util.BitSet;
import java.util.List;
import org.jsmesh.mesh.GrowingMesh;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;

/**
 * The arrays of a {@link RenderMesh} for a mesh that is refined, with a note of what each step changes: a graphics card
 * gets that alone. The triangles and the data of their corners are those of {@link RenderMesh#of} for the same mesh
 * with its faces in the order of their arrival. Render vertices and faces have other numbers, which stay.
 *
 * <p>A step changes arrays in ranges. While only some have reached the graphics card, vertices before faces, the
 * picture has no gaps if vertices are drawn where they {@link #STARTS start} from. Not thread-safe.
 */
public final class LiveMesh {
    static final int POSITIONS = 0;
    static final int NORMALS = 1;
    static final int COLOURS = 2;
    static final int INDICES = 3;
    static final int TANGENTS = 5;
    static final int FIRST_SET = TANGENTS + 1;

    /**
     * Number of an array that {@link RenderMesh} lacks: x, y, z from which a render vertex glides to its position, and
     * the {@link #step} in which it does; in other steps it stays at its position.
     */
    public static final int STARTS = RenderMesh.ARRAYS;

    static final int ARRAYS = STARTS + 1;

    /** Starts before positions, so that none is drawn where it goes too early; faces after their vertices. */
    private static final int[] ORDER = {STARTS, 0, 1, 2, 5, 6, 7, 8, 9, INDICES};

    private static final int CORNER = GrowingMesh.CORNER;

    private final GrowingMesh mesh;
    private final LiveArray[] arrays = new LiveArray[ARRAYS]; // null for those that the mesh lacks
    private final LiveAttributes attributes;
    private final DisplaySlots slots;
    private final FacePlaces places;
    private final WedgeVertices wedgeVertices = new WedgeVertices();
    private final LivePositions positions;
    private final LiveNormals normals;
    private final ChangedRanges ranges = new ChangedRanges();
    private int[] star = new int[64 * CORNER];
    private final float[] normal = new float[3];
    private int step;
    private int[] groups = {};

    /**
     * Prepares the arrays.
     *
     * @param mesh the one to follow
     * @param materials of the model, in the order of their ids
     */
    public LiveMesh(GrowingMesh mesh, List<Material> materials) {
        this.mesh = mesh;
        arrays[POSITIONS] = new LiveArray(3);
        arrays[NORMALS] = new LiveArray(3);
        arrays[INDICES] = new LiveArray(3);
        arrays[STARTS] = new LiveArray(4);
        attributes = new LiveAttributes(mesh, arrays);
        slots = DisplaySlots.of(materials, attributes.hasColours());
        places = new FacePlaces(slots.size());
        positions = new LivePositions(mesh);
        normals = new LiveNormals(mesh);
    }

    /**
     * Brings the arrays to what the mesh shows now.
     *
     * @param cosine as for {@link RenderMesh#of}
     */
    public void update(double cosine) {
        for (LiveArray array : arrays) if (array != null) array.settle();
        wedgeVertices.beginStep();
        step++;
        BitSet changed = mesh.takeChanges();
        normals.begin(cosine, changed);
        if (attributes.isLightOther()) changed.set(0, mesh.vertices());
        wedgeVertices.reserve(mesh.wedges());
        places.reserve(mesh.faceNumbers());
        positions.update(changed);
        for (int i = 0; i < mesh.vertices(); i++) {
            int v = mesh.vertexAt(i);
            if (changed.get(v)) renew(v);
        }
        groups = places.groups();
        ranges.find(arrays, ORDER);
    }

    /** Writes all that belongs to the corners around a vertex. */
    private void renew(int v) {
        int size = CORNER * mesh.corners(v, star);
        if (size > star.length) {
            star = new int[size + size / 2];
            mesh.corners(v, star);
        }
        normals.compute(v, star, size, positions.now());
        boolean areKept = !mesh.isReshaped(v) && wedgeVertices.areSingle(star, size);
        for (int i = 0; i < size; i += CORNER) {
            normals.copy(i / CORNER, star[i + 2], normal);
            star[i + 3] = vertexFor(star[i + 2], v);
        }
        if (areKept && wedgeVertices.areSingle(star, size)) return; // the indices of its faces stay
        for (int i = 0; i < size; i += CORNER) {
            int place = places.place(star[i], slots.slot(star[i + 5]));
            arrays[INDICES].reserve(places.end());
            arrays[INDICES].set(place, star[i + 1], star[i + 3]);
        }
        for (int i = 0; i < size; i += CORNER) wedgeVertices.giveUpOthers(star[i + 2]);
    }

    /** The render vertex of a wedge that has the {@link #normal}. */
    private int vertexFor(int wedge, int v) {
        int free = WedgeVertices.NONE;
        for (int r = wedgeVertices.first(wedge); r != WedgeVertices.NONE; r = wedgeVertices.next(r)) {
            boolean isTaken = wedgeVertices.isTaken(r);
            boolean hasNormal = hasNormal(r);
            if (isTaken && hasNormal) return r;
            if (!isTaken && (hasNormal || free == WedgeVertices.NONE)) free = r;
        }
        if (free == WedgeVertices.NONE) free = addVertex(wedge);
        wedgeVertices.take(free);
        write(free, wedge, v);
        return free;
    }

    private boolean hasNormal(int vertex) {
        LiveArray array = arrays[NORMALS];
        return array.number(vertex, 0) == normal[0]
                && array.number(vertex, 1) == normal[1]
                && array.number(vertex, 2) == normal[2];
    }

    private int addVertex(int wedge) {
        int vertex = wedgeVertices.add(wedge);
        for (int a = 0; a < ARRAYS; a++) if (a != INDICES && arrays[a] != null) arrays[a].reserve(wedgeVertices.size());
        return vertex;
    }

    private void write(int vertex, int wedge, int v) {
        arrays[POSITIONS].set(vertex, positions.now(), 3 * v);
        arrays[NORMALS].set(vertex, normal, 0);
        if (positions.isMoved(v)) {
            arrays[STARTS].set(vertex, positions.before(), 3 * v);
            arrays[STARTS].set(vertex, 3, (float) step);
        }
        attributes.write(wedge, vertex);
    }

    /**
     * Takes over another mesh, the last one: what its faces have is not in the one that was followed.
     *
     * @param last the mesh to show from now on
     * @param cosine as for {@link RenderMesh#of}
     */
    public void replace(Mesh last, double cosine) {
        RenderMesh whole = RenderMesh.of(last, cosine);
        step++;
        for (int a = 0; a < RenderMesh.ARRAYS; a++) {
            if (arrays[a] == null) continue;
            arrays[a].settle();
            arrays[a].replace(whole, a);
        }
        arrays[STARTS].settle();
        arrays[STARTS].reserve(whole.vertices());
        groups = whole.groups();
        ranges.find(arrays, ORDER);
    }

    /** {@return the number of the step that the last {@link #update} made} */
    public int step() {
        return step;
    }

    /** {@return render vertices that there is room for now, used or not} */
    public int vertices() {
        return arrays[POSITIONS].count() / 3;
    }

    /** {@return triangles that there is room for now, used or not} */
    public int places() {
        return arrays[INDICES].count() / 3;
    }

    /** {@return the number of triangles shown} */
    public int faces() {
        return mesh.faces();
    }

    /**
     * The indices to draw.
     *
     * @return three numbers per run of triangles: its slot, its first element of the indices, its number of elements. A
     *     slot may have several runs
     */
    public int[] groups() {
        return groups.clone();
    }

    /** {@return the display materials of the groups} */
    public DisplaySlots slots() {
        return slots;
    }

    /**
     * Where a face lies; it stays there until the mesh is replaced.
     *
     * @param face its number in the mesh that is followed
     * @return the triangle that it is, or a negative number where it is not shown
     */
    public int place(int face) {
        return places.of(face);
    }

    /** Rows of an array; null where the mesh lacks it. */
    LiveArray row(int array) {
        return arrays[array];
    }

    /** {@return ranges of elements that the last step has changed} */
    public int ranges() {
        return ranges.size();
    }

    /**
     * Where a range lies.
     *
     * @param range 0 to {@link #ranges} − 1
     * @return the number of its array, as {@link RenderMesh#count} has them, or {@link #STARTS}
     */
    public int array(int range) {
        return ranges.array(range);
    }

    /**
     * Where a range begins.
     *
     * @param range 0 to {@link #ranges} − 1
     * @return the first element
     */
    public int first(int range) {
        return ranges.first(range);
    }

    /**
     * How long a range is.
     *
     * @param range 0 to {@link #ranges} − 1
     * @return the number of elements
     */
    public int count(int range) {
        return ranges.count(range);
    }

    /**
     * Copies elements of all ranges, one after the other, into a buffer, as many as fit.
     *
     * @param from the first element, counted over all ranges
     * @param buffer takes four bytes per element in its own byte order, from its position on, which moves
     * @return elements copied
     */
    public int copy(int from, ByteBuffer buffer) {
        int copied = 0;
        int skipped = 0;
        for (int r = 0; r < ranges.size(); r++) {
            int at = from + copied - skipped;
            if (at < ranges.count(r)) {
                int count = Math.min(buffer.remaining() / 4, ranges.count(r) - at);
                if (count == 0) break;
                arrays[ranges.array(r)].copy(ranges.first(r) + at, count, buffer);
                copied += count;
            }
            skipped += ranges.count(r);
        }
        return copied;
    }

    /**
     * The slots all of whose corners have a tangent. A model may have them for some of its parts alone.
     *
     * @return their numbers, ascending
     */
    public int[] slotsWithTangents() {
        return attributes.slotsWithTangents(slots.size(), groups);
    }
}
