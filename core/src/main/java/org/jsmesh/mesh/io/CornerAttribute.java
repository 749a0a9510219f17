package org.jsmesh.mesh.io;

import org.jsmesh.mesh.Channel;

/**
 * An attribute as a file has it: a table of values and, for each corner, the row that it uses.
 *
 * @param name of the channel that it becomes
 * @param components values per row
 * @param rows raw values as in {@link Channel#values()}, {@link #words} per row
 * @param cornerRows row of each corner, −1 for a corner without the attribute; or null when row and vertex of a corner
 *     are the same number
 */
public record CornerAttribute(
        Channel.Semantic semantic, String name, int components, Channel.Type type, int[] rows, int[] cornerRows) {
    /** {@return ints per row} */
    public int words() {
        return components * type.words();
    }
}
