package org.jsmesh.desktop.draw;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.jsmesh.display.DisplaySlots;
import org.jsmesh.display.LiveStep;
import org.jsmesh.studio.ContactShadow;

/** What a graphics card is told of a scene, kept so that another one can be told the same. */
final class ShownScene {
    final MeshArrays arrays;
    int[] groups = {};
    DisplaySlots slots;
    Map<String, TextureImage> images = Map.of();
    Map<String, TextureImage> masks = Map.of();
    boolean isClosed;
    ContactShadow shadow;
    private byte[] levels = new byte[0]; // by place
    private int lastLevel; // of the whole model

    /** Nothing yet. */
    ShownScene() {
        arrays = new MeshArrays();
    }

    ShownScene(Scene scene) {
        arrays = MeshArrays.of(scene.mesh());
        groups = scene.mesh().groups();
        slots = scene.mesh().slots();
        images = scene.images();
        masks = scene.masks();
        isClosed = scene.isClosed();
        shadow = scene.shadow();
        levels = scene.levels();
        lastLevel = scene.lastLevel();
    }

    ShownScene(ErrorMap map) {
        arrays = MeshArrays.of(map);
        groups = new int[] {0, 0, map.distances().length};
        slots = DisplaySlots.of(List.of(), false);
    }

    /** Takes over what is no array, when all of a step's arrays are there. */
    void finish(SceneStep step) {
        groups = step.live().groups();
        slots = step.live().slots();
        images = step.images();
        masks = step.masks();
        isClosed = step.isClosed();
        if (step.shadow() != null) shadow = step.shadow();
        if (levels.length < step.live().places()) reserve(3 * step.live().places() / 2);
        for (int i = 0; i < step.newPlaces().length; i++) {
            levels[step.newPlaces()[i]] = step.newLevels()[i];
            lastLevel = Math.max(lastLevel, step.newLevels()[i]);
        }
    }

    /** Makes room for the levels of so many triangles. */
    void reserve(int places) {
        levels = Arrays.copyOf(levels, places);
    }

    void expect(int places, int last) {
        reserve(places);
        lastLevel = last;
    }

    boolean isEmpty() {
        return slots == null || !arrays.has(LiveStep.INDICES);
    }

    /** The level in which each triangle came, by its place; empty where nobody knows. */
    byte[] levels() {
        return levels;
    }

    /** The last level that there will be, or that has come. */
    int lastLevel() {
        return lastLevel;
    }
}
