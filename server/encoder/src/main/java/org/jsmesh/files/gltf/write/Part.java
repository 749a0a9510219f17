package org.jsmesh.files.gltf.write;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.Mesh;

/** Faces that become one primitive: those of one object with the same material and the same attributes. */
final class Part {
    /** What faces of a part have in common: the text of their object, material, one bit per attribute. */
    private record Kind(String object, int material, BitSet attributes) {}

    private final Kind kind;
    private int[] faces = new int[16];
    private int count;

    private Part(Kind kind) {
        this.kind = kind;
    }

    /** All parts by object, in the order of their first faces. */
    static Map<String, List<Part>> of(Mesh mesh, List<VertexAttribute> attributes) {
        FaceChannel objects = mesh.faceChannel(FaceChannel.OBJECT);
        if (objects != null && objects.labels().isEmpty()) objects = null;
        Map<Kind, Part> parts = new LinkedHashMap<>();
        Map<String, List<Part>> byObject = new LinkedHashMap<>();
        for (int f = 0; f < mesh.faces(); f++) {
            String object = objects == null ? "" : objects.label(f);
            Kind kind = new Kind(object, mesh.faceMaterials()[f], attributes(mesh, f, attributes));
            Part part = parts.get(kind);
            if (part == null) {
                part = new Part(kind);
                parts.put(kind, part);
                byObject.computeIfAbsent(object, o -> new ArrayList<>()).add(part);
            }
            part.add(f);
        }
        return byObject;
    }

    /** The attributes that all corners of a face have. */
    private static BitSet attributes(Mesh mesh, int face, List<VertexAttribute> attributes) {
        BitSet present = new BitSet();
        for (int a = 0; a < attributes.size(); a++) if (absent(mesh, face, attributes.get(a)) == 0) present.set(a);
        return present;
    }

    private static int absent(Mesh mesh, int face, VertexAttribute attribute) {
        int absent = 0;
        for (int i = 0; i < 3; i++) absent += attribute.values().isAbsent(mesh.faceWedges()[3 * face + i]) ? 1 : 0;
        return absent;
    }

    /** Faces that have an attribute at some corners only, each counted once for each attribute. */
    static int partlyAbsent(Mesh mesh, List<VertexAttribute> attributes) {
        int partly = 0;
        for (int f = 0; f < mesh.faces(); f++) {
            for (VertexAttribute attribute : attributes) {
                int absent = attribute.isCopy() ? 0 : absent(mesh, f, attribute);
                if (absent == 1 || absent == 2) partly++;
            }
        }
        return partly;
    }

    private void add(int face) {
        if (count == faces.length) faces = Arrays.copyOf(faces, 2 * count);
        faces[count++] = face;
    }

    /** The number of the material, or −1. */
    int material() {
        return kind.material;
    }

    boolean has(int attribute) {
        return kind.attributes.get(attribute);
    }

    /** The wedge of each corner, face by face. */
    int[] corners(Mesh mesh) {
        int[] corners = new int[3 * count];
        for (int i = 0; i < count; i++) System.arraycopy(mesh.faceWedges(), 3 * faces[i], corners, 3 * i, 3);
        return corners;
    }
}
