package org.jsmesh.files.gltf.write;

import org.jsmesh.display.ColourRange;
import org.jsmesh.display.LinearLight;
import org.jsmesh.mesh.Channel;

/** The values of a channel in the forms that attributes of glTF have. */
final class ChannelValues {
    /** A normal this far from unit length is an error for the validator, almost. */
    private static final double UNIT_ERROR = .005;

    private static final int FULL = 65535;
    private static final int BYTE_TO_SHORT = 257;

    /** Linear light of each level of a screen. */
    private static final int[] LIGHT = new int[256];

    static {
        for (int i = 0; i < LIGHT.length; i++) LIGHT[i] = (int) Math.round(FULL * LinearLight.light(i / 255.0));
    }

    private ChannelValues() {}

    /** Bits as they are; numbers of 32 bits and doubles as float32. What is no finite number is absent. */
    static VertexAttribute.Values exact(Channel channel) {
        boolean narrowed = !isHeld(channel);
        boolean floats = channel.type().isFloat() || narrowed;
        return new VertexAttribute.Values() {
            @Override
            public boolean isAbsent(int wedge) {
                boolean absent = channel.isAbsent(wedge);
                for (int k = 0; k < channel.components() && floats && !absent; k++)
                    absent = !Float.isFinite((float) channel.exact(wedge, k));
                return absent;
            }

            @Override
            public int raw(int wedge, int component) {
                if (narrowed) return Float.floatToRawIntBits((float) channel.exact(wedge, component));
                return channel.values()[wedge * channel.components() + component];
            }
        };
    }

    /** Whether attributes of glTF have numbers of this type. */
    static boolean isHeld(Channel channel) {
        return switch (channel.type()) {
            case INT32, UINT32, FLOAT64 -> false;
            default -> true;
        };
    }

    /** Whether float32 holds all of its numbers. */
    static boolean isFloat32(Channel channel) {
        for (int w = 0; w < channel.wedges(); w++)
            for (int k = 0; k < channel.components() && !channel.isAbsent(w); k++)
                if ((float) channel.exact(w, k) != channel.exact(w, k)) return false;
        return true;
    }

    /** Numbers as viewers take them, in float32. */
    static VertexAttribute.Values numbers(Channel channel) {
        return new VertexAttribute.Values() {
            @Override
            public boolean isAbsent(int wedge) {
                return channel.isAbsent(wedge);
            }

            @Override
            public int raw(int wedge, int component) {
                return Float.floatToRawIntBits(channel.number(wedge, component));
            }
        };
    }

    /** Are all normals of unit length? */
    static boolean areUnit(Channel normals) {
        for (int w = 0; w < normals.wedges(); w++)
            if (!normals.isAbsent(w) && !(Math.abs(length(normals, w) - 1) <= UNIT_ERROR)) return false;
        return true;
    }

    /** Normals of unit length. One that has no direction is absent. */
    static VertexAttribute.Values unit(Channel normals) {
        return new VertexAttribute.Values() {
            @Override
            public boolean isAbsent(int wedge) {
                double length = length(normals, wedge);
                return normals.isAbsent(wedge) || !(length > 0) || Double.isInfinite(length);
            }

            @Override
            public int raw(int wedge, int component) {
                return Float.floatToRawIntBits((float) (normals.exact(wedge, component) / length(normals, wedge)));
            }
        };
    }

    private static double length(Channel normals, int wedge) {
        double squares = 0;
        for (int k = 0; k < normals.components(); k++) squares += normals.exact(wedge, k) * normals.exact(wedge, k);
        return Math.sqrt(squares);
    }

    /** Linear light of colours, as parts of 65,535. Opacity stays in proportion. */
    static VertexAttribute.Values light(Channel colours) {
        double full = ColourRange.full(colours);
        boolean linear = colours.isLinearLight();
        return new VertexAttribute.Values() {
            @Override
            public boolean isAbsent(int wedge) {
                return colours.isAbsent(wedge);
            }

            @Override
            public int raw(int wedge, int component) {
                boolean asItIs = linear || component == 3;
                if (colours.type() == Channel.Type.UINT8) {
                    int level = colours.values()[wedge * colours.components() + component];
                    return asItIs ? level * BYTE_TO_SHORT : LIGHT[level];
                }
                double part = Math.max(0, Math.min(1, colours.number(wedge, component) / full));
                return (int) Math.round(FULL * (asItIs ? part : LinearLight.light(part)));
            }
        };
    }
}
