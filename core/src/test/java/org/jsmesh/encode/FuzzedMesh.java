package org.jsmesh.encode;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;

/** Small meshes made of any bytes. */
final class FuzzedMesh {
    private static final int MOST_VERTICES = 40;
    private static final int MOST_FACES = 80;

    /** Numbers at the limits of something, and some that people write. */
    private static final float[] NUMBERS = {
        0,
        -0f,
        1,
        .5f,
        -.85f,
        .1f,
        1e-3f,
        .3048f,
        1 << 24,
        1e10f,
        1e32f,
        -3e38f,
        Float.MAX_VALUE,
        Float.MIN_VALUE,
        1e-41f
    };

    private FuzzedMesh() {}

    /** A mesh with shared edges, repeated and degenerate faces, unused vertices, attributes and materials. */
    static Mesh of(FuzzedBytes data) {
        int vertices = data.from(1, MOST_VERTICES);
        int faces = data.from(1, MOST_FACES);
        int wedges = data.isTrue() ? vertices : data.from(vertices, 2 * MOST_VERTICES);
        boolean hasChannels = data.isTrue();
        if (!hasChannels) wedges = vertices;
        int[] wedgeVertices = new int[wedges];
        for (int w = 0; w < wedges; w++) wedgeVertices[w] = w < vertices ? w : data.from(0, vertices - 1);
        int spread = data.from(1, 8);
        int[] corners = new int[3 * faces];
        for (int i = 0; i < corners.length; i++)
            corners[i] = data.isTrue()
                    ? data.from(0, wedges - 1)
                    : Math.min(wedges - 1, (i / 3 + i % 3) % (wedges / spread + 1));
        int numbers = data.from(0, 3);
        MeshBuilder builder = new MeshBuilder().wedgeVertices(wedgeVertices).faceWedges(corners);
        if (data.from(0, 7) == 0) {
            double[] exact = new double[3 * vertices];
            for (int i = 0; i < exact.length; i++) exact[i] = exact(data, numbers);
            builder.positions(exact);
        } else {
            float[] positions = new float[3 * vertices];
            for (int i = 0; i < positions.length; i++) positions[i] = number(data, numbers);
            builder.positions(positions);
        }
        List<Channel> channels = new ArrayList<>();
        for (int i = hasChannels ? data.from(1, 3) : 0; i > 0; i--) channels.add(channel(data, wedges, i));
        builder.channels(channels);
        int materials = data.from(0, 3);
        if (materials > 0) {
            List<Material> list = new ArrayList<>();
            for (int i = 0; i < materials; i++) list.add(Material.named("m" + i));
            int[] of = new int[faces];
            for (int f = 0; f < faces; f++) of[f] = data.from(-1, materials - 1);
            builder.materials(list).faceMaterials(of);
        }
        if (data.from(0, 3) == 0) builder.faceChannels(List.of(faceChannel(data, faces)));
        return builder.build();
    }

    private static FaceChannel faceChannel(FuzzedBytes data, int faces) {
        int[] values = new int[faces];
        if (data.isTrue()) {
            for (int f = 0; f < faces; f++) values[f] = data.from(0, 2);
            return new FaceChannel(FaceChannel.GROUP, 1, Channel.Type.INT32, values, List.of("", "a", "b"));
        }
        for (int f = 0; f < faces; f++) values[f] = data.bits();
        return new FaceChannel("scalar", 1, Channel.Type.UINT32, values, List.of());
    }

    private static Channel channel(FuzzedBytes data, int wedges, int number) {
        Channel.Semantic semantic = data.of(Channel.Semantic.values());
        Channel.Type type = data.of(Channel.Type.values());
        int components = data.from(1, 4);
        int numbers = data.from(0, 3);
        int[] values = new int[components * type.words() * wedges];
        BitSet absent = new BitSet();
        boolean hasAbsent = data.isTrue();
        for (int w = 0; w < wedges; w++) {
            if (hasAbsent && data.isTrue()) {
                absent.set(w);
                continue;
            }
            for (int k = 0; k < components; k++) {
                int at = (components * w + k) * type.words();
                if (type == Channel.Type.UINT8) values[at] = data.from(0, 255);
                else if (type == Channel.Type.INT8) values[at] = data.next();
                else if (type == Channel.Type.INT16) values[at] = (short) data.bits();
                else if (type == Channel.Type.UINT16) values[at] = data.from(0, 65535);
                else if (!type.isFloat()) values[at] = data.bits();
                else if (type == Channel.Type.FLOAT32) values[at] = Float.floatToRawIntBits(number(data, numbers));
                else put(values, at, Double.doubleToRawLongBits(exact(data, numbers)));
            }
        }
        return new Channel(semantic, "c" + number, components, type, values, absent.isEmpty() ? null : absent);
    }

    private static void put(int[] values, int at, long bits) {
        values[at] = (int) bits;
        values[at + 1] = (int) (bits >>> 32);
    }

    /** A finite number: of a kind that all numbers of a column have, or of any kind. */
    private static float number(FuzzedBytes data, int kind) {
        switch (kind == 3 ? data.from(0, 2) : kind) {
            case 0:
                return data.next();
            case 1:
                return data.from(-9999, 9999) / 1000f;
            default:
                int choice = data.from(0, NUMBERS.length);
                if (choice < NUMBERS.length) return NUMBERS[choice];
                float any = Float.intBitsToFloat(data.bits());
                return Float.isFinite(any) ? any : 0;
        }
    }

    /** A finite number that float32 may not hold. */
    private static double exact(FuzzedBytes data, int kind) {
        double x = number(data, kind);
        switch (data.from(0, 3)) {
            case 0:
                return x;
            case 1:
                return x / 3;
            case 2:
                return data.bits() / 1000.0 + 450_000;
            default:
                double any = Double.longBitsToDouble(data.manyBits());
                return Math.abs(any) <= Float.MAX_VALUE ? any : x; // neither infinite nor no number
        }
    }
}
