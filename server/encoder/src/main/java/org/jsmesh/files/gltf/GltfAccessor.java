package org.jsmesh.files.gltf;

import de.javagl.jgltf.impl.v2.Accessor;
import de.javagl.jgltf.impl.v2.AccessorSparse;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Map;

/**
 * The values of an accessor (glTF 2.0 specification, section 3.6.2), raw: float32 bits or integers; sparse ones are
 * filled in.
 */
final class GltfAccessor {
    private static final Map<String, Integer> COMPONENTS = Map.of("SCALAR", 1, "VEC2", 2, "VEC3", 3, "VEC4", 4);
    private static final int BYTE = 5120;
    private static final int UNSIGNED_BYTE = 5121;
    private static final int SHORT = 5122;
    private static final int UNSIGNED_SHORT = 5123;
    private static final int UNSIGNED_INT = 5125;
    private static final int FLOAT = 5126;

    private final GltfDocument document;
    private final String name;
    private final int components;
    private final int componentType;
    private final boolean normalized;
    private final int count;
    private final int[] raw;

    GltfAccessor(GltfDocument document, Accessor accessor, String name) throws IOException {
        this.document = document;
        this.name = name;
        Integer width = accessor.getType() == null ? null : COMPONENTS.get(accessor.getType());
        if (width == null)
            throw document.error(name + " is of type " + accessor.getType() + ", not a scalar or vector");
        components = width;
        componentType = accessor.getComponentType() == null ? 0 : accessor.getComponentType();
        normalized = Boolean.TRUE.equals(accessor.isNormalized());
        if (accessor.getCount() == null || accessor.getCount() < 0) throw document.error(name + " has no count");
        count = accessor.getCount();
        ByteBuffer view = accessor.getBufferView() == null ? null : document.view(accessor.getBufferView());
        int elementBytes = components * componentBytes(componentType);
        Integer stride = view == null
                ? null
                : document.gltf().getBufferViews().get(accessor.getBufferView()).getByteStride();
        long step = stride == null || stride == 0 ? elementBytes : stride;
        long start = accessor.getByteOffset() == null ? 0 : accessor.getByteOffset();
        if (step < elementBytes || start < 0) throw document.error(name + " has a stride or an offset that cannot be");
        if (view != null) checkSize(start, step, elementBytes, view.capacity());
        // zeros without bytes behind them; no file needs more of them than it has bytes
        if (view == null && count > document.fileBytes())
            throw document.error(name + " has " + count + " elements without bytes");
        raw = new int[Math.multiplyExact(count, components)];
        if (view != null) read(view, (int) start, (int) step);
        if (accessor.getSparse() != null) fillSparse(accessor.getSparse());
    }

    private void checkSize(long start, long step, long elementBytes, long available) throws IOException {
        if (count > 0 && start + step * (count - 1L) + elementBytes > available) {
            throw document.error(
                    name + " needs more bytes than its buffer view has (" + available + ")",
                    "The file is cut off; get it again");
        }
    }

    private void read(ByteBuffer view, int start, int step) throws IOException {
        int size = componentBytes(componentType);
        for (int i = 0; i < count; i++) {
            for (int c = 0; c < components; c++)
                raw[i * components + c] = value(view, start + i * step + c * size, componentType);
        }
    }

    private void fillSparse(AccessorSparse sparse) throws IOException {
        if (sparse.getCount() == null || sparse.getIndices() == null || sparse.getValues() == null)
            throw document.error(name + " has incomplete sparse values");
        ByteBuffer indices = document.view(sparse.getIndices().getBufferView());
        ByteBuffer values = document.view(sparse.getValues().getBufferView());
        int indexType = sparse.getIndices().getComponentType() == null
                ? 0
                : sparse.getIndices().getComponentType();
        int indexBytes = componentBytes(indexType);
        int size = componentBytes(componentType);
        long indexStart = sparse.getIndices().getByteOffset() == null
                ? 0
                : sparse.getIndices().getByteOffset();
        long valueStart = sparse.getValues().getByteOffset() == null
                ? 0
                : sparse.getValues().getByteOffset();
        long n = sparse.getCount();
        boolean fits =
                n >= 0 && indexStart >= 0 && valueStart >= 0 && indexStart + n * indexBytes <= indices.capacity();
        if (!fits || valueStart + n * components * size > values.capacity())
            throw document.error(name + " has sparse values outside of their buffer view");
        for (int i = 0; i < n; i++) {
            int element = value(indices, (int) indexStart + i * indexBytes, indexType);
            if (element < 0 || element >= count)
                throw document.error(name + " has a sparse value for element " + element + " of " + count);
            for (int c = 0; c < components; c++) {
                raw[element * components + c] =
                        value(values, (int) valueStart + (i * components + c) * size, componentType);
            }
        }
    }

    private int componentBytes(int type) throws IOException {
        return switch (type) {
            case BYTE, UNSIGNED_BYTE -> 1;
            case SHORT, UNSIGNED_SHORT -> 2;
            case UNSIGNED_INT, FLOAT -> 4;
            default -> throw document.error(name + " has the component type " + type);
        };
    }

    private static int value(ByteBuffer bytes, int at, int type) {
        return switch (type) {
            case BYTE -> bytes.get(at);
            case UNSIGNED_BYTE -> bytes.get(at) & 0xFF;
            case SHORT -> bytes.getShort(at);
            case UNSIGNED_SHORT -> bytes.getShort(at) & 0xFFFF;
            default -> bytes.getInt(at);
        };
    }

    int count() {
        return count;
    }

    int components() {
        return components;
    }

    /** True for normalized bytes; they are kept as they are. */
    boolean isByteFraction() {
        return normalized && componentType == UNSIGNED_BYTE;
    }

    int raw(int element, int component) {
        return raw[element * components + component];
    }

    /** An unsigned integer, negative when it is above 2³¹. */
    int index(int element) throws IOException {
        if (componentType == FLOAT || components != 1) throw document.error(name + " are no indices");
        return raw[element];
    }

    /** The number: integers as they are, or as a fraction of their largest when normalized. */
    float number(int element, int component) throws IOException {
        int value = raw(element, component);
        if (componentType == FLOAT) {
            float number = Float.intBitsToFloat(value);
            if (Float.isNaN(number) || Float.isInfinite(number)) {
                throw document.error(
                        name + " has " + number + " at element " + element + ", not a finite number",
                        "Repair or remove this vertex");
            }
            return number;
        }
        if (!normalized) return componentType == UNSIGNED_INT ? (float) (value & 0xFFFFFFFFL) : (float) value;
        return switch (componentType) {
            case BYTE -> Math.max((float) (value / 127.0), -1f);
            case UNSIGNED_BYTE -> (float) (value / 255.0);
            case SHORT -> Math.max((float) (value / 32767.0), -1f);
            case UNSIGNED_SHORT -> (float) (value / 65535.0);
            default -> (float) ((value & 0xFFFFFFFFL) / 4294967295.0);
        };
    }
}
