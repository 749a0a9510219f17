package org.jsmesh.web;

import org.jsmesh.display.LiveMesh;

/**
 * What a step changes in the arrays to draw, as JSON: its number, the batches that it shows, sizes, the runs of indices
 * to draw, the slots that have tangents, and the changed ranges, three numbers each: array, first element, elements.
 */
final class ChangesJson {
    private ChangesJson() {}

    /**
     * Writes a step.
     *
     * @param batches that are shown with it
     * @param isJump whether nothing of the picture before stays while ranges are replaced
     */
    static void write(Json json, LiveMesh live, int batches, boolean isJump) {
        json.open('{');
        json.key("step").number(live.step());
        json.key("jump").flag(isJump);
        json.key("batches").number(batches);
        json.key("faces").number(live.faces());
        json.key("vertices").number(live.vertices());
        json.key("places").number(live.places());
        numbers(json.key("groups"), live.groups());
        numbers(json.key("tangents"), live.slotsWithTangents());
        json.key("ranges").open('[');
        for (int r = 0; r < live.ranges(); r++)
            json.number(live.array(r)).number(live.first(r)).number(live.count(r));
        json.close(']').close('}');
    }

    private static void numbers(Json json, int[] numbers) {
        json.open('[');
        for (int number : numbers) json.number(number);
        json.close(']');
    }
}
