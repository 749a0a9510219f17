package org.jsmesh.mesh.io;

import java.io.BufferedWriter;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import org.jsmesh.mesh.Mesh;

/** Writes lines of UTF-8 text that end with LF. */
final class TextOutput implements Closeable {
    private final Writer writer;

    TextOutput(OutputStream out) {
        writer = new BufferedWriter(new OutputStreamWriter(out, StandardCharsets.UTF_8), 1 << 16);
    }

    TextOutput text(String text) throws IOException {
        writer.write(text);
        return this;
    }

    TextOutput number(int value) throws IOException {
        return text(Integer.toString(value));
    }

    TextOutput number(float value) throws IOException {
        return text(FloatText.plain(value));
    }

    /** A number that no reader takes for a whole one. */
    TextOutput decimal(float value) throws IOException {
        return text(Float.toString(value));
    }

    /** Each number behind a blank. */
    TextOutput numbers(float[] values, int from, int count) throws IOException {
        for (int i = from; i < from + count; i++) text(" ").number(values[i]);
        return this;
    }

    /** The coordinates of a vertex, each behind a blank; in double precision those of the file, not the offsets. */
    TextOutput coordinates(Mesh mesh, int vertex) throws IOException {
        if (!mesh.isDouble()) return numbers(mesh.positions(), 3 * vertex, 3);
        for (int axis = 0; axis < 3; axis++) text(" ").text(FloatText.plain(mesh.coordinate(vertex, axis)));
        return this;
    }

    /** Each number, given by its bits, behind a blank. */
    TextOutput floats(int[] bits, int from, int count) throws IOException {
        for (int i = from; i < from + count; i++) text(" ").number(Float.intBitsToFloat(bits[i]));
        return this;
    }

    TextOutput line() throws IOException {
        return text("\n");
    }

    @Override
    public void close() throws IOException {
        writer.close();
    }
}
