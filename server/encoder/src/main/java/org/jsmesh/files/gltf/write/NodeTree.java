package org.jsmesh.files.gltf.write;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;

/** The nodes of a file: those that turn and move the whole model, each below the one before, then one per object. */
final class NodeTree {
    /** Takes (x, y, z) to (x, z, -y), column by column; a rotation by a quaternion would round. */
    private static final float[] FROM_Z_UP = {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1};

    private final List<ObjectNode> places = new ArrayList<>();
    private final List<ObjectNode> objects = new ArrayList<>();

    void turnUp() {
        Numbers.add(place().putArray("matrix"), FROM_Z_UP);
    }

    /** Translations are float32 for most programs, so each node brings what the ones above it leave. */
    void moveTo(double[] origin) {
        double[] left = origin.clone();
        while (left[0] != 0 || left[1] != 0 || left[2] != 0) {
            ArrayNode step = place().putArray("translation");
            for (int a = 0; a < 3; a++) {
                // All its digits, for programs that read doubles.
                step.add((double) (float) left[a]);
                left[a] -= (float) left[a];
            }
        }
    }

    private ObjectNode place() {
        ObjectNode node = JsonNodeFactory.instance.objectNode();
        places.add(node);
        return node;
    }

    /** An object, without a name where that is empty. */
    void add(String name, int mesh) {
        ObjectNode node = JsonNodeFactory.instance.objectNode();
        if (!name.isEmpty()) node.put("name", name);
        objects.add(node.put("mesh", mesh));
    }

    void describe(ObjectNode gltf) {
        if (objects.size() == 1 && !places.isEmpty())
            places.get(places.size() - 1).setAll(objects.remove(0));
        ArrayNode scene = JsonNodeFactory.instance.arrayNode();
        List<ObjectNode> all = new ArrayList<>(places);
        all.addAll(objects);
        for (int i = 0; i < places.size(); i++) {
            boolean last = i == places.size() - 1;
            if (!last) places.get(i).putArray("children").add(i + 1);
            else if (!objects.isEmpty()) addObjects(places.get(i).putArray("children"));
        }
        if (places.isEmpty()) addObjects(scene);
        else scene.add(0);
        gltf.put("scene", 0);
        ObjectNode shown = gltf.putArray("scenes").addObject();
        if (scene.isEmpty()) return;
        shown.set("nodes", scene);
        gltf.putArray("nodes").addAll(all);
    }

    private void addObjects(ArrayNode list) {
        for (int i = 0; i < objects.size(); i++) list.add(places.size() + i);
    }
}
