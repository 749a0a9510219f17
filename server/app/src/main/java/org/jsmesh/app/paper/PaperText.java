package org.jsmesh.app.paper;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.zip.GZIPOutputStream;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;

/** Numbers of a mesh as text: every one with the fewest digits that bring it back. */
final class PaperText {
    private final Mesh mesh;

    PaperText(Mesh mesh) {
        this.mesh = mesh;
    }

    /** Whether vertices have more than a position. */
    boolean hasAttributes() {
        return !mesh.channels().isEmpty();
    }

    void position(StringBuilder text, int vertex) {
        for (int axis = 0; axis < 3; axis++) {
            if (axis > 0) text.append(' ');
            text.append(
                    mesh.isDouble()
                            ? shortest(Double.toString(mesh.coordinate(vertex, axis)))
                            : shortest(Float.toString(mesh.positions()[3 * vertex + axis])));
        }
    }

    /** Each value after a blank; a minus for one that the model does not have. */
    void attributes(StringBuilder text, int wedge) {
        for (Channel channel : mesh.channels()) {
            for (int i = 0; i < channel.components(); i++) {
                text.append(' ');
                if (channel.isAbsent(wedge)) text.append('-');
                else if (!channel.type().isFloat()) text.append((long) channel.exact(wedge, i));
                else if (channel.words() == 1) text.append(shortest(Float.toString(channel.number(wedge, i))));
                else text.append(shortest(Double.toString(channel.exact(wedge, i))));
            }
        }
    }

    private static String shortest(String number) {
        return number.endsWith(".0") ? number.substring(0, number.length() - 2) : number;
    }

    /** Compressed by gzip. */
    static byte[] compressed(String text) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (GZIPOutputStream out = new GZIPOutputStream(bytes)) {
            out.write(text.getBytes(StandardCharsets.US_ASCII));
        } catch (IOException e) {
            throw new UncheckedIOException(e); // memory does not fail so
        }
        return bytes.toByteArray();
    }
}
