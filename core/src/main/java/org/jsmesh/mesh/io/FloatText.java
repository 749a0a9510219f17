package org.jsmesh.mesh.io;

/** Text of floats that reads back to the same bits. */
final class FloatText {
    private FloatText() {}

    /** As {@link Float#toString(float)}, whole numbers without {@code .0}; −0.0 keeps its sign. */
    static String plain(float value) {
        String text = Float.toString(value);
        return text.endsWith(".0") ? text.substring(0, text.length() - 2) : text;
    }
}
