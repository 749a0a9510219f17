package org.jsmesh.files.gltf;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;

/** Looks into meshes that were read. */
final class GltfChannels {
    private GltfChannels() {}

    static Channel named(Mesh mesh, String name) {
        return mesh.channels().stream()
                .filter(channel -> channel.name().equals(name))
                .findFirst()
                .orElseThrow(() -> new AssertionError("no channel " + name));
    }

    static List<String> names(Mesh mesh) {
        return mesh.channels().stream().map(Channel::name).toList();
    }

    /** The stored numbers at a corner, or null where it has none. */
    static List<Double> at(Mesh mesh, String name, int face, int corner) {
        Channel channel = named(mesh, name);
        int wedge = mesh.faceWedges()[3 * face + corner];
        if (channel.isAbsent(wedge)) return null;
        List<Double> values = new ArrayList<>();
        for (int c = 0; c < channel.components(); c++) values.add(channel.exact(wedge, c));
        return values;
    }

    static List<Double> position(Mesh mesh, int face, int corner) {
        List<Double> values = new ArrayList<>();
        for (int k = 0; k < 3; k++) values.add(mesh.coordinate(mesh.vertex(face, corner), k));
        return values;
    }
}
