package org.jsmesh.mesh.io;

import org.jsmesh.mesh.Channel;

/** Vertex colours of an OFF file: bytes when every number is whole, else floats. */
final class OffColours {
    private final IntList bits = new IntList();
    private boolean whole = true;

    void add(float value, boolean integer) {
        bits.add(Float.floatToRawIntBits(value));
        whole &= integer;
    }

    CornerAttribute attribute(String file, int components) throws ModelFormatException {
        if (!whole)
            return new CornerAttribute(
                    Channel.Semantic.COLOUR, "colour", components, Channel.Type.FLOAT32, bits.toArray(), null);
        int[] rows = new int[bits.size()];
        for (int i = 0; i < rows.length; i++) {
            float value = Float.intBitsToFloat(bits.get(i));
            if (value < 0 || value > 255) {
                throw new ModelFormatException(
                        file,
                        "",
                        "a colour of vertex " + i / components + " is " + value + ", not within 0 to 255",
                        "Correct the colours");
            }
            rows[i] = (int) value;
        }
        return new CornerAttribute(Channel.Semantic.COLOUR, "colour", components, Channel.Type.UINT8, rows, null);
    }
}
