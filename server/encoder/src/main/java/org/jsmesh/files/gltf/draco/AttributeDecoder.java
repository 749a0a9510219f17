package org.jsmesh.files.gltf.draco;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import org.jsmesh.files.gltf.packed.PackedBytes;
import org.jsmesh.files.gltf.packed.PackedException;

/**
 * Decodes one attribute (Draco specification, "Sequential attribute decoder" and those for integers, quantized numbers
 * and normals): first integers, then what turns them into the values.
 */
final class AttributeDecoder {
    private static final int RAW = 0;
    private static final int INTEGERS = 1;
    private static final int QUANTIZED = 2;
    private static final int NORMALS = 3;
    private static final int MOST_BITS = 30;
    private static final int MOST_BYTES = 1 << 30;

    final AttributeKind kind;
    private final int method;
    /** Components of the integers: normals have two. */
    private final int components;

    private byte[] raw;
    private int[] integers;
    private float[] least;
    private float range;
    private int bits;

    AttributeDecoder(AttributeKind kind, int method) throws PackedException {
        this.kind = kind;
        this.method = method;
        boolean right = switch (method) {
            case RAW -> true;
            case INTEGERS -> kind.type() != AttributeKind.FLOAT;
            case QUANTIZED -> kind.type() == AttributeKind.FLOAT;
            case NORMALS -> kind.type() == AttributeKind.FLOAT && kind.components() == 3;
            default -> false;
        };
        if (!right) throw new PackedException("an attribute of the Draco mesh has the unknown method " + method);
        components = method == NORMALS ? 2 : kind.components();
    }

    void readIntegers(PackedBytes in, int entries, ValueOrder order, Positions positions) throws PackedException {
        int size = requireSize(entries);
        if (method == RAW) {
            int from = in.take(size);
            raw = Arrays.copyOfRange(in.bytes, from, from + size);
            return;
        }
        Prediction prediction = Prediction.read(in, method == NORMALS, components, order, positions);
        int count = entries * components;
        integers = in.next() == 0 ? plain(in, count) : RansSymbols.decode(in, count, components);
        if (prediction == null || !prediction.hasPositiveCorrections()) {
            for (int i = 0; i < count; i++) integers[i] = integers[i] >>> 1 ^ -(integers[i] & 1);
        }
        if (prediction == null) return;
        prediction.readData(in);
        if (count > 0) prediction.restore(integers);
    }

    /** The bytes of so many values. */
    int requireSize(int values) throws PackedException {
        long size = (long) values * kind.components() * kind.size();
        if (size > MOST_BYTES) throw new PackedException("an attribute of the Draco mesh is too large");
        return (int) size;
    }

    private static int[] plain(PackedBytes in, int count) throws PackedException {
        int bytes = in.next();
        if (bytes > 4) throw new PackedException("integers of the Draco mesh have " + bytes + " bytes");
        if ((long) count * bytes > in.remaining()) throw new PackedException("the packed data ends too early");
        int[] values = new int[count];
        for (int i = 0; i < count; i++) {
            for (int b = 0; b < bytes; b++) values[i] |= in.next() << 8 * b;
        }
        return values;
    }

    /** The integers if these are positions, else null. */
    Positions positions(ValueOrder order) {
        boolean known = kind.isPosition() && integers != null && components == 3 && order != null;
        return known ? new Positions(order, integers) : null;
    }

    void readTransform(PackedBytes in) throws PackedException {
        if (method == RAW || method == INTEGERS) return;
        if (method == QUANTIZED) {
            least = new float[components];
            for (int c = 0; c < components; c++) least[c] = in.nextFloat();
            range = in.nextFloat();
        }
        bits = in.next();
        if (bits < 1 || bits > MOST_BITS) throw new PackedException(bits + " bits of the Draco mesh are out of range");
    }

    /** All values in the order of the stream. */
    byte[] values(int entries) throws PackedException {
        if (method == RAW) return raw;
        ByteBuffer values = ByteBuffer.allocate(entries * kind.components() * kind.size());
        values.order(ByteOrder.LITTLE_ENDIAN);
        switch (method) {
            case QUANTIZED -> putQuantized(values);
            case NORMALS -> putNormals(values);
            default -> putIntegers(values);
        }
        return values.array();
    }

    private void putQuantized(ByteBuffer values) {
        float step = range / (float) ((1 << bits) - 1);
        for (int i = 0; i < integers.length; i++) values.putFloat(integers[i] * step + least[i % components]);
    }

    private void putNormals(ByteBuffer values) throws PackedException {
        Octahedron octahedron = new Octahedron(bits);
        for (int i = 0; i < integers.length; i += 2) octahedron.putVector(integers[i], integers[i + 1], values);
    }

    private void putIntegers(ByteBuffer values) {
        int size = kind.size();
        for (int value : integers) {
            if (size == 1) values.put((byte) value);
            else if (size == 2) values.putShort((short) value);
            else values.putInt(value);
        }
    }
}
