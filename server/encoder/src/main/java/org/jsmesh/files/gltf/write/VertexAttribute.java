package org.jsmesh.files.gltf.write;

import com.fasterxml.jackson.databind.node.ObjectNode;
import org.jsmesh.files.gltf.read.ComponentType;

/**
 * An attribute of vertices as the file has it.
 *
 * @param name in glTF
 * @param components 1 to 4
 * @param type of each component
 * @param normalized whether whole numbers are parts of their largest
 * @param values for each wedge
 * @param extras what tells the channel from the attribute; null where its name and type do
 * @param spare the extras for an attribute that goes under another name
 */
record VertexAttribute(
        String name,
        int components,
        ComponentType type,
        boolean normalized,
        Values values,
        ObjectNode extras,
        ObjectNode spare) {

    /** Values by wedge. */
    interface Values {
        /** Whether there is nothing to write. */
        boolean isAbsent(int wedge);

        /** The bits of a component, as a channel of the type holds them. */
        int raw(int wedge, int component);
    }

    /** Bytes of a vertex: a multiple of four. */
    int stride() {
        return components * type.bytes() + 3 & -4;
    }

    /** Is it there for other programs alone? */
    boolean isCopy() {
        return spare == null;
    }

    /** The same under a name of the application, which no rule of glTF binds. */
    VertexAttribute renamed() {
        return new VertexAttribute('_' + name, components, type, normalized, values, spare, spare);
    }
}
