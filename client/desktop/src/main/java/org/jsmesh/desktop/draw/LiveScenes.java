package org.jsmesh.desktop.draw;

import java.util.Map;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.ChannelInfo;
import org.jsmesh.display.LiveMesh;
import org.jsmesh.display.LiveStep;
import org.jsmesh.mesh.Channel;
import org.jsmesh.session.MeshStep;
import org.jsmesh.studio.ContactShadow;

/** Makes the steps of a session ready to be drawn. Used by one thread at a time. */
public final class LiveScenes {
    /** Room for render vertices that creases add to the wedges. */
    private static final double CREASE_ROOM = 1.3;

    /** Room for faces whose slot may still get others. */
    private static final double SLOT_ROOM = 1.5;

    /** Of more, an array has no room. */
    private static final int MOST_PLACES = Integer.MAX_VALUE / 4;

    /**
     * Rows of an array that there is room for from the beginning. The header of a few bytes may claim hundreds of
     * millions; room for more is made when so many have come.
     */
    private static final int FREE_ROWS = 1 << 21;

    /** Times as many faces with which a model may have another shadow. */
    private static final int MUCH_MORE = 4;

    private final ArchiveHeader header;
    private final Framing framing;
    private final TextureImages images;
    private final MeshArrays arrays = new MeshArrays(); // positions and indices alone
    private Map<String, TextureImage> known = Map.of();
    private Map<String, TextureImage> masks = Map.of();
    private int shadedFaces;

    /** @param images decodes the textures of the same model */
    public LiveScenes(ArchiveHeader header, Framing framing, TextureImages images) {
        this.header = header;
        this.framing = framing;
        this.images = images;
    }

    /** The next step. Its arrays are changed: they go to the unit space. */
    public SceneStep next(MeshStep step) {
        LiveStep live = step.live();
        place(live);
        if (step.images() != null) {
            known = images.of(step.images());
            masks = images.masks(live.slots());
        }
        return new SceneStep(
                live.number() == 1 ? first(live) : null,
                live,
                step.newPlaces(),
                step.newLevels(),
                known,
                masks,
                header.isClosed(),
                shadow(live, step.isLast()),
                step.taken());
    }

    /** Room for the whole model, unless it is very large, so that nothing is copied while it is drawn. */
    private ShownScene first(LiveStep live) {
        ShownScene first = new ShownScene();
        // The first slot is that of faces without a material; most models use one.
        int places = (int) Math.min(MOST_PLACES, (live.slots().size() > 2 ? SLOT_ROOM : 1) * header.faces());
        int vertices = (int) Math.min(MOST_PLACES, (hasNormals() ? 1 : CREASE_ROOM) * header.wedges());
        for (int a = 0; a <= LiveMesh.STARTS; a++)
            first.arrays.expect(a, LiveStep.width(a) * (a == LiveStep.INDICES ? places : vertices));
        for (int r = 0; r < live.ranges().length; r += 3) {
            int array = live.ranges()[r];
            int rows = Math.min(FREE_ROWS, array == LiveStep.INDICES ? places : vertices);
            first.arrays.reserve(
                    array, Math.max(LiveStep.width(array) * rows, live.ranges()[r + 1] + live.ranges()[r + 2]));
        }
        first.expect(Math.min(FREE_ROWS, places), header.levels().size());
        return first;
    }

    private boolean hasNormals() {
        for (ChannelInfo channel : header.channels()) if (channel.semantic() == Channel.Semantic.NORMAL) return true;
        return false;
    }

    private void place(LiveStep live) {
        int[] data = live.data();
        int at = 0;
        for (int r = 0; r < live.ranges().length; r += 3) {
            int array = live.ranges()[r];
            int count = live.ranges()[r + 2];
            switch (array) {
                case LiveStep.POSITIONS, LiveMesh.STARTS -> framing.toUnit(data, at, at + count, LiveStep.width(array));
                case LiveStep.NORMALS, LiveStep.TANGENTS -> framing.turn(data, at, at + count, LiveStep.width(array));
                default -> {
                    // Not of space.
                }
            }
            if (array == LiveStep.POSITIONS || array == LiveStep.INDICES)
                arrays.write(array, live.ranges()[r + 1], data, at, count);
            at += count;
        }
    }

    /** The first shadow, that of much more of the model, and that of all of it. */
    private ContactShadow shadow(LiveStep live, boolean isLast) {
        if (shadedFaces > 0 && !isLast && live.faces() < (long) MUCH_MORE * shadedFaces) return null;
        shadedFaces = live.faces();
        return ContactShadow.of(
                arrays.positions(), arrays.indices(live.groups()), framing.halfX(), framing.halfY(), framing.halfZ());
    }
}
