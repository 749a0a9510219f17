package org.jsmesh.desktop.draw;

import java.util.Map;
import org.jsmesh.display.LiveStep;
import org.jsmesh.studio.ContactShadow;

/**
 * What a step of refinement changes of a scene; {@link LiveScenes} makes them. Immutable, so that one thread can make
 * it and another can draw it.
 *
 * @param first what a step of number 1 begins with: nothing but room for the whole model; else null
 * @param live changes of the arrays, in the unit space of {@link Framing}
 * @param newPlaces triangles that are new
 * @param newLevels of each of them the level in which it came
 * @param images those that can be shown now, as in {@link Scene}
 * @param masks those of them that are opacities
 * @param isClosed whether the original bounds a solid
 * @param shadow on the ground; null where it is that of the step before
 * @param taken to be called when the next step may come
 */
public record SceneStep(
        ShownScene first,
        LiveStep live,
        int[] newPlaces,
        byte[] newLevels,
        Map<String, TextureImage> images,
        Map<String, TextureImage> masks,
        boolean isClosed,
        ContactShadow shadow,
        Runnable taken) {}
