package org.jsmesh.archive.coding;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Material;

/** Codes the materials of a header in both directions. */
final class MaterialCoder {
    private static final int MOST = 1 << 20;
    private static final int MOST_PARTS = 1 << 12;
    private static final int MOST_VALUES = 256;

    private final HeaderFields fields;
    private final boolean write;

    MaterialCoder(HeaderFields fields, boolean write) {
        this.fields = fields;
        this.write = write;
    }

    /** @param list of no meaning to a decoder */
    List<Material> code(List<Material> list) throws MalformedStreamException {
        int n = fields.count(write ? list.size() : 0, MOST);
        List<Material> materials = new ArrayList<>();
        for (int i = 0; i < n; i++) {
            fields.checkEnd();
            materials.add(material(write ? list.get(i) : null));
        }
        return materials;
    }

    private Material material(Material m) throws MalformedStreamException {
        String name = fields.text(write ? m.name() : null);
        List<Material.Parameter> parameters = new ArrayList<>();
        int parameterCount = fields.count(write ? m.parameters().size() : 0, MOST_PARTS);
        for (int p = 0; p < parameterCount; p++)
            parameters.add(parameter(write ? m.parameters().get(p) : null));
        List<Material.TextureReference> references = new ArrayList<>();
        int referenceCount = fields.count(write ? m.textures().size() : 0, MOST_PARTS);
        for (int t = 0; t < referenceCount; t++) {
            String key = fields.text(write ? m.textures().get(t).key() : null);
            references.add(new Material.TextureReference(
                    key, fields.text(write ? m.textures().get(t).path() : null)));
        }
        boolean gltf = fields.flag(write && m.isGltf());
        String definition = gltf ? fields.text(write ? m.gltf() : null) : "";
        if (gltf && definition.isEmpty()) throw new MalformedStreamException(-1, "a material without definition");
        return new Material(name, parameters, references, definition);
    }

    private Material.Parameter parameter(Material.Parameter p) throws MalformedStreamException {
        String key = fields.text(write ? p.key() : null);
        float[] values = new float[fields.count(write ? p.values().length : 0, MOST_VALUES)];
        for (int v = 0; v < values.length; v++) values[v] = fields.number(write ? p.values()[v] : 0);
        return new Material.Parameter(key, values);
    }
}
