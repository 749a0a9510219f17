package org.jsmesh.decode;

import java.util.Arrays;
import org.jsmesh.mesh.MalformedStreamException;

/** Feeds a decoder batch by batch, and knows then in which level each face came. Not thread-safe. */
public final class FaceLevels {
    private final ArchiveDecoder decoder;
    private int[] faceNumbers = new int[64]; // after each batch
    private int noted; // batches

    /**
     * Follows a decoder.
     *
     * @param decoder that nobody else feeds
     */
    public FaceLevels(ArchiveDecoder decoder) {
        this.decoder = decoder;
    }

    /**
     * Takes the next bytes of the file, as {@link ArchiveDecoder#feed} does.
     *
     * @param bytes an array that holds them
     * @param offset of the first of them in the array
     * @param length number of bytes, 0 or more
     * @throws MalformedStreamException when the bytes are not an archive
     */
    public void feed(byte[] bytes, int offset, int length) throws MalformedStreamException {
        for (int at = offset, end = offset + length; at < end; ) {
            int count = portion(end - at);
            decoder.feed(bytes, at, count);
            at += count;
            for (; noted < decoder.batches(); noted++) {
                if (noted == faceNumbers.length) faceNumbers = Arrays.copyOf(faceNumbers, 2 * noted);
                faceNumbers[noted] = decoder.growing().faceNumbers();
            }
        }
    }

    private int portion(int left) {
        if (decoder.opening() == null) return 1; // its length is not known yet
        if (decoder.isComplete()) return left;
        return (int) Math.min(left, decoder.index().end(decoder.batches()) - decoder.received());
    }

    /**
     * The level of a face.
     *
     * @param face its number in {@link ArchiveDecoder#growing}
     * @return the level in which it came, 0 for the base
     */
    public int level(int face) {
        int low = 0;
        int high = noted - 1;
        while (low < high) {
            int middle = low + (high - low) / 2;
            if (face < faceNumbers[middle]) high = middle;
            else low = middle + 1;
        }
        return decoder.index().level(low);
    }

    /**
     * The levels of all faces of a mesh.
     *
     * @return the level in which each face of {@link ArchiveDecoder#mesh} came, before the last batch
     */
    public byte[] ofMesh() {
        int[] faces = decoder.growing().shownFaces();
        byte[] levels = new byte[faces.length];
        for (int f = 0; f < faces.length; f++) levels[f] = (byte) level(faces[f]);
        return levels;
    }
}
