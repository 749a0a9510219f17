package org.jsmesh.mesh.io;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;

/**
 * How a PLY file holds the materials of a mesh: images as {@code comment TextureFile} and {@code texnumber}, as MeshLab
 * writes them, and colours as properties of faces. It holds no other materials.
 */
final class PlyMaterials {
    private static final String[] NAMES = {"red", "green", "blue", "alpha"};

    private final Mesh mesh;
    private final List<String> textures = new ArrayList<>();
    private final boolean held;
    private final int components;
    private final PlyType type;

    PlyMaterials(Mesh mesh, List<String> notes) {
        this.mesh = mesh;
        List<Material> materials = mesh.materials();
        held = !materials.isEmpty() && materials.stream().allMatch(PlyMaterials::isHeld);
        if (!held) {
            if (!materials.isEmpty()) notes.add("PLY does not hold materials.");
            components = 0;
            type = null;
            return;
        }
        boolean coloured = false;
        boolean plain = false;
        boolean alpha = false;
        boolean opaque = false;
        for (Material m : materials) {
            for (Material.TextureReference texture : m.textures())
                if (!textures.contains(texture.path())) textures.add(texture.path());
            coloured |= m.parameter("rgb") != null;
            plain |= m.parameter("rgb") == null;
            alpha |= m.parameter("d") != null;
            opaque |= m.parameter("d") == null;
        }
        for (int id : mesh.faceMaterials()) plain |= id < 0;
        if (coloured && plain)
            notes.add("PLY gives all faces a colour or none: where there is none, white is written.");
        if (alpha && opaque) notes.add("PLY gives all faces an opacity or none: where there is none, 1 is written.");
        components = !coloured ? 0 : alpha ? 4 : 3;
        type = !coloured ? null : fits(255) ? PlyType.UCHAR : fits(65535) ? PlyType.USHORT : PlyType.FLOAT;
    }

    private static boolean isHeld(Material material) {
        boolean coloured = FaceColour.isOnlyColour(material.parameters());
        if (material.textures().isEmpty()) return coloured && FaceColour.is(material);
        return (coloured || material.parameters().isEmpty())
                && material.textures().equals(List.of(new Material.TextureReference("map_Kd", material.name())))
                && FileNames.isSafe(material.name());
    }

    /** Whether all colours are whole numbers up to {@code most}, as parts of it. */
    private boolean fits(int most) {
        for (Material material : mesh.materials()) {
            for (Material.Parameter parameter : material.parameters()) {
                for (float value : parameter.values()) {
                    if (!FaceColour.isPart(value, most)) return false;
                }
            }
        }
        return true;
    }

    /** Paths of images, numbered from 0. */
    List<String> textures() {
        return textures;
    }

    void header(StringBuilder text) {
        if (!textures.isEmpty()) text.append("property int texnumber\n");
        for (int i = 0; i < components; i++)
            text.append("property ")
                    .append(type.typeName())
                    .append(' ')
                    .append(NAMES[i])
                    .append('\n');
    }

    void face(LittleEndianOutput out, int face) throws IOException {
        if (!held) return;
        int id = mesh.faceMaterials()[face];
        Material material = id < 0 ? null : mesh.materials().get(id);
        if (!textures.isEmpty()) {
            boolean textured = material != null && !material.textures().isEmpty();
            out.writeInt(textured ? textures.indexOf(material.textures().get(0).path()) : -1);
        }
        if (components == 0) return;
        float[] rgb = material == null ? null : material.parameter("rgb");
        float[] opacity = material == null ? null : material.parameter("d");
        for (int i = 0; i < components; i++) {
            float value = i == 3 ? (opacity == null ? 1 : opacity[0]) : rgb == null ? 1 : rgb[i];
            switch (type) {
                case UCHAR -> out.writeByte(Math.round(255 * value));
                case USHORT -> out.writeShort(Math.round(65535 * value));
                default -> out.writeFloat(value);
            }
        }
    }
}
