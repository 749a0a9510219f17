package org.jsmesh.files.gltf;

import de.javagl.jgltf.impl.v2.Accessor;
import de.javagl.jgltf.impl.v2.BufferView;
import de.javagl.jgltf.impl.v2.GlTF;
import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;

/**
 * Collects the one binary buffer of a GLB file with its views and accessors; every view starts at a multiple of four.
 */
final class GltfBuffer {
    private static final int UNSIGNED_BYTE = 5121;
    private static final int UNSIGNED_INT = 5125;
    private static final int FLOAT = 5126;
    private static final int ARRAY_BUFFER = 34962;
    private static final int ELEMENT_ARRAY_BUFFER = 34963;

    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private final List<BufferView> views = new ArrayList<>();
    private final List<Accessor> accessors = new ArrayList<>();

    /** The position of each wedge. */
    int positions(Mesh mesh) {
        int wedges = mesh.wedges();
        ByteBuffer data = allocate(12L * wedges);
        Float[] min = {0f, 0f, 0f};
        Float[] max = {0f, 0f, 0f};
        for (int w = 0; w < wedges; w++) {
            for (int i = 0; i < 3; i++) {
                float value = mesh.positions()[3 * mesh.wedgeVertices()[w] + i];
                data.putFloat(value);
                if (w == 0 || value < min[i]) min[i] = value;
                if (w == 0 || value > max[i]) max[i] = value;
            }
        }
        Accessor accessor = accessor(view(data.array(), 12, ARRAY_BUFFER), FLOAT, wedges, 3);
        accessor.setMin(min);
        accessor.setMax(max);
        return accessors.size() - 1;
    }

    /** The values of each wedge; bytes are normalized and padded to four. */
    int channel(Channel channel) {
        int n = channel.components();
        boolean floats = channel.type() == Channel.Type.FLOAT32;
        int stride = floats ? 4 * n : 4;
        ByteBuffer data = allocate((long) stride * channel.wedges());
        for (int w = 0; w < channel.wedges(); w++) {
            data.position(w * stride);
            for (int i = 0; i < n; i++) {
                int value = channel.values()[w * n + i];
                if (floats) {
                    data.putInt(value);
                } else {
                    data.put((byte) value);
                }
            }
        }
        Accessor accessor =
                accessor(view(data.array(), stride, ARRAY_BUFFER), floats ? FLOAT : UNSIGNED_BYTE, channel.wedges(), n);
        if (!floats) accessor.setNormalized(true);
        return accessors.size() - 1;
    }

    int indices(int[] indices) {
        ByteBuffer data = allocate(4L * indices.length);
        data.asIntBuffer().put(indices);
        accessor(view(data.array(), 0, ELEMENT_ARRAY_BUFFER), UNSIGNED_INT, indices.length, 1);
        return accessors.size() - 1;
    }

    int image(byte[] image) {
        return view(image, 0, 0);
    }

    private static ByteBuffer allocate(long size) {
        if (size > Integer.MAX_VALUE - 8)
            throw new IllegalArgumentException("a mesh of this size does not fit a GLB file");
        return ByteBuffer.allocate((int) size).order(ByteOrder.LITTLE_ENDIAN);
    }

    private int view(byte[] content, int stride, int target) {
        BufferView view = new BufferView();
        view.setBuffer(0);
        view.setByteOffset(bytes.size());
        view.setByteLength(content.length);
        if (stride > 0) view.setByteStride(stride);
        if (target > 0) view.setTarget(target);
        bytes.writeBytes(content);
        while (bytes.size() % 4 != 0) bytes.write(0);
        views.add(view);
        return views.size() - 1;
    }

    private Accessor accessor(int view, int componentType, int count, int components) {
        Accessor accessor = new Accessor();
        accessor.setBufferView(view);
        accessor.setByteOffset(0);
        accessor.setComponentType(componentType);
        accessor.setCount(count);
        accessor.setType(components == 1 ? "SCALAR" : "VEC" + components);
        accessors.add(accessor);
        return accessor;
    }

    void describe(GlTF gltf) {
        views.forEach(gltf::addBufferViews);
        accessors.forEach(gltf::addAccessors);
    }

    ByteBuffer bytes() {
        return ByteBuffer.wrap(bytes.toByteArray());
    }
}
