package org.jsmesh.files.gltf;

import de.javagl.jgltf.impl.v2.Asset;
import de.javagl.jgltf.impl.v2.Buffer;
import de.javagl.jgltf.impl.v2.GlTF;
import de.javagl.jgltf.impl.v2.MeshPrimitive;
import de.javagl.jgltf.impl.v2.Node;
import de.javagl.jgltf.impl.v2.Scene;
import de.javagl.jgltf.model.io.v2.GltfAssetV2;
import de.javagl.jgltf.model.io.v2.GltfAssetWriterV2;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.io.ResourceSink;

/**
 * Writes a mesh as GLB: one node without a transform, a vertex per wedge, a primitive for the faces of each material.
 * In glTF an attribute that is absent at some corner is absent in the whole primitive, so faces are also grouped by the
 * attributes that all their corners have.
 */
public final class GltfWriter {
    static final String GENERATOR = "jSM";
    /** Name within the extras of a material for a definition that glTF cannot express. */
    static final String EXTRAS = "jsm";

    static final String TEXTURE_TRANSFORM = "KHR_texture_transform";

    /** Faces of one primitive: their material, and one bit per channel that they have. */
    private record Part(int material, int channels) {}

    private final Mesh mesh;
    private final List<String> notes = new ArrayList<>();
    private final List<String> remarks;
    private final GltfBuffer buffer = new GltfBuffer();
    private final Map<String, Channel> channels = new LinkedHashMap<>();
    private int partlyAbsent;

    private GltfWriter(Mesh mesh, List<String> remarks) {
        this.mesh = mesh;
        this.remarks = remarks;
    }

    /**
     * @param fileName of the file, ending in {@code .glb}
     * @param sink takes the one file
     * @param remarks gets what other programs may miss though it is in the file, one sentence each
     * @return what glTF cannot hold or holds in another way, one sentence each
     * @throws IOException from the sink
     */
    public static List<String> write(Mesh mesh, String fileName, ResourceSink sink, List<String> remarks)
            throws IOException {
        GltfWriter writer = new GltfWriter(mesh, remarks);
        GlTF gltf = writer.gltf();
        ByteBuffer binary = writer.buffer.bytes();
        Buffer description = new Buffer();
        description.setByteLength(Math.max(1, binary.remaining()));
        gltf.addBuffers(description);
        try (OutputStream out = sink.create(fileName)) {
            new GltfAssetWriterV2().writeBinary(new GltfAssetV2(gltf, binary), out);
        }
        return List.copyOf(writer.notes);
    }

    private GlTF gltf() {
        GlTF gltf = new GlTF();
        Asset asset = new Asset();
        asset.setVersion("2.0");
        asset.setGenerator(GENERATOR);
        gltf.setAsset(asset);
        Node node = new Node();
        Scene scene = new Scene();
        gltf.setScene(0);
        gltf.addScenes(scene);
        if (mesh.faces() > 0) {
            gltf.addMeshes(meshes());
            node.setMesh(0);
            gltf.addNodes(node);
            scene.addNodes(0);
        }
        new GltfMaterialWriter(mesh, gltf, buffer, remarks).write();
        buffer.describe(gltf);
        return gltf;
    }

    private de.javagl.jgltf.impl.v2.Mesh meshes() {
        chooseChannels();
        Map<String, Integer> accessors = new LinkedHashMap<>();
        accessors.put("POSITION", buffer.positions(mesh));
        channels.forEach((name, channel) -> accessors.put(name, buffer.channel(channel)));
        Map<Part, List<Integer>> parts = new LinkedHashMap<>();
        for (int f = 0; f < mesh.faces(); f++)
            parts.computeIfAbsent(part(f), p -> new ArrayList<>()).add(f);
        de.javagl.jgltf.impl.v2.Mesh all = new de.javagl.jgltf.impl.v2.Mesh();
        parts.forEach((part, faces) -> all.addPrimitives(primitive(part, faces, accessors)));
        if (partlyAbsent > 0)
            notes.add("glTF has no mark for absent attributes: on " + partlyAbsent
                    + " faces that have one at some corners only it is left out.");
        return all;
    }

    private void chooseChannels() {
        int texcoords = 0;
        int colours = 0;
        List<String> left = new ArrayList<>();
        for (Channel channel : mesh.channels()) {
            boolean floats = channel.type() == Channel.Type.FLOAT32;
            int components = channel.components();
            switch (channel.semantic()) {
                case NORMAL ->
                    choose("NORMAL", channel, floats && components == 3 && !channels.containsKey("NORMAL"), left);
                case TEXCOORD -> choose("TEXCOORD_" + texcoords++, channel, floats && components == 2, left);
                case COLOUR -> choose("COLOR_" + colours++, channel, components >= 3, left);
                case CUSTOM -> left.add(channel.name());
            }
        }
        if (!left.isEmpty()) notes.add("glTF does not hold these channels: " + GltfNames.shown(left) + ".");
    }

    private void choose(String name, Channel channel, boolean fits, List<String> left) {
        if (fits) {
            channels.put(name, channel);
        } else {
            left.add(channel.name());
        }
    }

    private Part part(int face) {
        int present = 0;
        int bit = 1;
        for (Channel channel : channels.values()) {
            int absent = 0;
            for (int i = 0; i < 3; i++) absent += channel.isAbsent(mesh.faceWedges()[3 * face + i]) ? 1 : 0;
            if (absent == 0) present |= bit;
            if (absent == 1 || absent == 2) partlyAbsent++;
            bit <<= 1;
        }
        return new Part(mesh.faceMaterials()[face], present);
    }

    private MeshPrimitive primitive(Part part, List<Integer> faces, Map<String, Integer> accessors) {
        int[] indices = new int[3 * faces.size()];
        int at = 0;
        for (int face : faces) {
            for (int i = 0; i < 3; i++) indices[at++] = mesh.faceWedges()[3 * face + i];
        }
        MeshPrimitive primitive = new MeshPrimitive();
        primitive.addAttributes("POSITION", accessors.get("POSITION"));
        int bit = 1;
        for (String name : channels.keySet()) {
            if ((part.channels & bit) != 0) primitive.addAttributes(name, accessors.get(name));
            bit <<= 1;
        }
        primitive.setIndices(buffer.indices(indices));
        if (part.material >= 0) primitive.setMaterial(part.material);
        return primitive;
    }
}
