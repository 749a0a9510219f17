package org.jsmesh.mesh.io;

import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;
import org.jsmesh.mesh.Sizes;

/** Files of formats that are read whole. */
public final class WholeFile {
    private WholeFile() {}

    /**
     * Reads all bytes; shares those that are in memory.
     *
     * @param file its name, for messages
     * @param content of the file
     * @return the bytes
     * @throws ModelFormatException when an array does not hold them
     * @throws IOException when they cannot be read
     */
    public static byte[] of(String file, ByteSource content) throws IOException {
        if (content instanceof ByteSource.Held held) return held.content();
        if (content.length() > Sizes.MOST)
            throw new ModelFormatException(
                    file,
                    "",
                    "the file is larger than 2 GiB (" + content.length() + " bytes), and of such files only PLY, OBJ"
                            + " and STL are read",
                    "Convert it to PLY, or cut the model into parts");
        byte[] all = new byte[(int) content.length()];
        int size = 0;
        try (InputStream in = content.from(0)) {
            for (int count; size < all.length && (count = in.read(all, size, all.length - size)) >= 0; ) size += count;
        }
        return size == all.length ? all : Arrays.copyOf(all, size);
    }
}
