package org.jsmesh.test.material;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A GLB file of parts with materials. Each part is a node and a mesh of its own. */
final class GlbScene {
    private static final Pattern EXTENSION = Pattern.compile("\"((?:KHR|EXT)_\\w+)\"");
    private static final int FLOAT = 5126;
    private static final int UNSIGNED_SHORT = 5123;

    private final ByteArrayOutputStream binary = new ByteArrayOutputStream();
    private final List<String> views = new ArrayList<>();
    private final List<String> accessors = new ArrayList<>();
    private final List<String> images = new ArrayList<>();
    private final List<String> textures = new ArrayList<>();
    private final List<String> materials = new ArrayList<>();
    private final List<String> meshes = new ArrayList<>();
    private final List<String> nodes = new ArrayList<>();
    private String sampler = "{}";

    /**
     * Adds a material; its textures are numbered as the images are added. Quotes may be written as {@code '}, and
     * numbers may begin with their point.
     */
    GlbScene material(String json) {
        materials.add(json(json));
        return this;
    }

    private static String json(String loose) {
        return loose.replace('\'', '"').replaceAll("(?<![0-9])[.](?=[0-9])", "0.");
    }

    /** Adds images in PNG, each of which is a texture with the one sampler. */
    GlbScene images(byte[]... pngs) {
        for (byte[] png : pngs) {
            images.add("{\"mimeType\":\"image/png\",\"bufferView\":" + view(png) + "}");
            textures.add("{\"sampler\":0,\"source\":" + (images.size() - 1) + "}");
        }
        return this;
    }

    GlbScene sampler(String json) {
        sampler = json(json);
        return this;
    }

    GlbScene part(Shape shape, int material) {
        StringBuilder attributes = new StringBuilder();
        for (Shape.Attribute attribute : shape.attributes()) {
            attributes.append(attributes.isEmpty() ? "" : ",").append('"').append(attribute.name());
            attributes.append("\":").append(accessor(attribute));
        }
        int[] indices = shape.indices();
        ByteBuffer data = ByteBuffer.allocate(2 * indices.length).order(ByteOrder.LITTLE_ENDIAN);
        for (int index : indices) data.putShort((short) index);
        int index = accessor(data.array(), UNSIGNED_SHORT, "SCALAR", indices.length, "");
        meshes.add("{\"primitives\":[{\"attributes\":{" + attributes + "},\"indices\":" + index + ",\"material\":"
                + material + "}]}");
        nodes.add("{\"mesh\":" + (meshes.size() - 1) + "}");
        return this;
    }

    private int accessor(Shape.Attribute attribute) {
        float[] values = attribute.values();
        int width = attribute.width();
        int count = values.length / width;
        ByteBuffer data = ByteBuffer.allocate(4 * values.length).order(ByteOrder.LITTLE_ENDIAN);
        if (!attribute.isShort()) {
            for (float value : values) data.putFloat(value);
            String more = attribute.name().equals("POSITION") ? bounds(values) : "";
            return accessor(data.array(), FLOAT, "VEC" + width, count, more);
        }
        // Elements begin at multiples of four bytes: room is left behind three shorts.
        int stride = (2 * width + 3) / 4 * 4;
        for (int i = 0; i < values.length; i++)
            data.putShort(i / width * stride + i % width * 2, (short) Math.round(65535 * values[i]));
        byte[] bytes = new byte[count * stride];
        data.get(0, bytes);
        String more = ",\"normalized\":true";
        accessor(bytes, UNSIGNED_SHORT, "VEC" + width, count, more);
        views.set(views.size() - 1, views.get(views.size() - 1).replace("}", ",\"byteStride\":" + stride + "}"));
        return accessors.size() - 1;
    }

    private int accessor(byte[] data, int componentType, String type, int count, String more) {
        accessors.add("{\"bufferView\":" + view(data) + ",\"componentType\":" + componentType + ",\"type\":\"" + type
                + "\",\"count\":" + count + more + "}");
        return accessors.size() - 1;
    }

    private int view(byte[] data) {
        views.add("{\"buffer\":0,\"byteOffset\":" + binary.size() + ",\"byteLength\":" + data.length + "}");
        binary.writeBytes(data);
        while (binary.size() % 4 != 0) binary.write(0);
        return views.size() - 1;
    }

    private static String bounds(float[] positions) {
        float[] min = {positions[0], positions[1], positions[2]};
        float[] max = min.clone();
        for (int i = 0; i < positions.length; i++) {
            min[i % 3] = Math.min(min[i % 3], positions[i]);
            max[i % 3] = Math.max(max[i % 3], positions[i]);
        }
        return ",\"min\":" + List.of(min[0], min[1], min[2]) + ",\"max\":" + List.of(max[0], max[1], max[2]);
    }

    private String json() {
        TreeSet<String> extensions = new TreeSet<>();
        Matcher found = EXTENSION.matcher(String.join("", materials));
        while (found.find()) extensions.add('"' + found.group(1) + '"');
        List<Integer> roots = new ArrayList<>();
        for (int i = 0; i < nodes.size(); i++) roots.add(i);
        String json = "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":" + roots + "}]";
        if (!extensions.isEmpty()) json += ",\"extensionsUsed\":" + extensions;
        if (!images.isEmpty()) json += ",\"images\":" + images + ",\"textures\":" + textures;
        if (!images.isEmpty()) json += ",\"samplers\":[" + sampler + "]";
        return json + ",\"nodes\":" + nodes + ",\"meshes\":" + meshes + ",\"materials\":" + materials
                + ",\"accessors\":" + accessors + ",\"bufferViews\":" + views + ",\"buffers\":[{\"byteLength\":"
                + binary.size() + "}]}";
    }

    byte[] bytes() {
        byte[] json = json().getBytes(StandardCharsets.UTF_8);
        int padded = (json.length + 3) / 4 * 4;
        ByteBuffer out = ByteBuffer.allocate(28 + padded + binary.size()).order(ByteOrder.LITTLE_ENDIAN);
        out.putInt(0x46546C67).putInt(2).putInt(out.capacity());
        out.putInt(padded).putInt(0x4E4F534A).put(json);
        while (out.position() < 20 + padded) out.put((byte) ' ');
        return out.putInt(binary.size())
                .putInt(0x004E4942)
                .put(binary.toByteArray())
                .array();
    }
}
