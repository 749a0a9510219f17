package org.jsmesh.files.gltf;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jsmesh.mesh.io.ModelFile;

/** Puts GLB files together by hand, so that tests do not lean on the writer that they test. */
final class GlbBuilder {
    private final ByteArrayOutputStream binary = new ByteArrayOutputStream();
    private final List<String> views = new ArrayList<>();
    private final List<String> accessors = new ArrayList<>();
    private String nodes = "{\"mesh\":0}";
    private String primitives = "";
    private String mesh = "";
    private String rest = "";

    int floats(String type, float... values) {
        ByteBuffer data = ByteBuffer.allocate(4 * values.length).order(ByteOrder.LITTLE_ENDIAN);
        for (float value : values) data.putFloat(value);
        int width = type.equals("VEC2") ? 2 : type.equals("VEC3") ? 3 : 4;
        return accessor(data.array(), 5126, type, values.length / width, "");
    }

    int bytes(int componentType, String type, int count, String more, int... values) {
        byte[] data = new byte[values.length];
        for (int i = 0; i < data.length; i++) data[i] = (byte) values[i];
        return accessor(data, componentType, type, count, more);
    }

    int shorts(int componentType, String type, int count, String more, int... values) {
        ByteBuffer data = ByteBuffer.allocate(2 * values.length).order(ByteOrder.LITTLE_ENDIAN);
        for (int value : values) data.putShort((short) value);
        return accessor(data.array(), componentType, type, count, more);
    }

    int accessor(byte[] data, int componentType, String type, int count, String more) {
        accessors.add("{\"bufferView\":" + view(data) + ",\"componentType\":" + componentType + ",\"type\":\"" + type
                + "\",\"count\":" + count + more + "}");
        return accessors.size() - 1;
    }

    int view(byte[] data) {
        views.add("{" + place(data) + "}");
        return views.size() - 1;
    }

    /** A buffer view of count × stride bytes that an extension has in packed form. */
    int packedView(byte[] packed, String extension, String mode, int count, int stride) {
        views.add("{\"buffer\":1,\"byteLength\":" + count * stride + ",\"extensions\":{\"" + extension + "\":{"
                + place(packed) + ",\"count\":" + count + ",\"byteStride\":" + stride + ",\"mode\":\"" + mode
                + "\"}}}");
        return views.size() - 1;
    }

    private String place(byte[] data) {
        String place = "\"buffer\":0,\"byteOffset\":" + binary.size() + ",\"byteLength\":" + data.length;
        binary.writeBytes(data);
        while (binary.size() % 4 != 0) binary.write(0);
        return place;
    }

    /** The number that the next accessor will have. */
    int nextAccessor() {
        return accessors.size();
    }

    GlbBuilder accessorText(String json) {
        accessors.add(json);
        return this;
    }

    GlbBuilder nodes(String json) {
        nodes = json;
        return this;
    }

    GlbBuilder primitive(String json) {
        primitives += (primitives.isEmpty() ? "" : ",") + json;
        return this;
    }

    /** More properties of the mesh, each with a comma in front. */
    GlbBuilder mesh(String json) {
        mesh = json;
        return this;
    }

    /** More properties of the root, each with a comma in front. */
    GlbBuilder rest(String json) {
        rest = json;
        return this;
    }

    /** A triangle in the plane z = 0 with its normal. */
    static GlbBuilder triangle() {
        GlbBuilder builder = new GlbBuilder();
        builder.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0);
        builder.floats("VEC3", 0, 0, 1, 0, 0, 1, 0, 0, 1);
        return builder.primitive("{\"attributes\":{\"POSITION\":0,\"NORMAL\":1}}");
    }

    private String json(String buffer) {
        return "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[" + nodes
                + "],\"meshes\":[{\"primitives\":[" + primitives + "]" + mesh + "}]," + "\"buffers\":[" + buffer
                + "],\"bufferViews\":[" + String.join(",", views) + "],\"accessors\":[" + String.join(",", accessors)
                + "]" + rest + "}";
    }

    byte[] glb() {
        byte[] json = json("{\"byteLength\":" + binary.size() + "}").getBytes(StandardCharsets.UTF_8);
        int padded = (json.length + 3) / 4 * 4;
        ByteBuffer out = ByteBuffer.allocate(28 + padded + binary.size()).order(ByteOrder.LITTLE_ENDIAN);
        out.putInt(0x46546C67)
                .putInt(2)
                .putInt(out.capacity())
                .putInt(padded)
                .putInt(0x4E4F534A)
                .put(json);
        while (out.position() < 20 + padded) out.put((byte) ' ');
        return out.putInt(binary.size())
                .putInt(0x004E4942)
                .put(binary.toByteArray())
                .array();
    }

    /** The JSON form with its buffer in a file or a data URI. */
    String gltf(String uri) {
        return json("{\"byteLength\":" + binary.size() + ",\"uri\":\"" + uri + "\"}");
    }

    byte[] binary() {
        return binary.toByteArray();
    }

    ModelFile read() throws IOException {
        return GltfReader.read("a.glb", glb(), path -> Optional.empty());
    }
}
