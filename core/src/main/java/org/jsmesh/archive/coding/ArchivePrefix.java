package org.jsmesh.archive.coding;

import org.jsmesh.mesh.MalformedStreamException;

/** The first bytes of an archive: magic, version, features, and how long the opening is; see {@link ArchiveLayout}. */
public final class ArchivePrefix {
    private ArchivePrefix() {}

    /**
     * Reads as much of the prefix as there is.
     *
     * @param buffer begins with the first byte of the file
     * @param buffered bytes in it, at least one more than {@link ArchiveLayout#OPENING_BYTES_AT}
     * @return bytes in front of the base payload; 0 when another byte is needed to tell
     * @throws MalformedStreamException when this is no archive, or one that this version cannot read
     */
    public static int headBytes(byte[] buffer, int buffered) throws MalformedStreamException {
        for (int i = 0; i < 3; i++) {
            if (buffer[i] != ArchiveLayout.MAGIC[i]) throw new MalformedStreamException(i, "this is not a jSM archive");
        }
        checkVersion(buffer[3] & 0xff);
        checkFeatures(buffer[ArchiveLayout.FEATURES_AT] & 0xff & ~ArchiveLayout.KNOWN_FEATURES, 0);
        if (buffer[buffered - 1] < 0) {
            if (buffered - ArchiveLayout.OPENING_BYTES_AT < ArchiveLayout.MOST_LENGTH_BYTES) return 0;
            throw new MalformedStreamException(
                    ArchiveLayout.OPENING_BYTES_AT, "the first part of the header is too long");
        }
        int length = 0;
        for (int i = buffered - 1; i >= ArchiveLayout.OPENING_BYTES_AT; i--) length = length << 7 | buffer[i] & 0x7f;
        return buffered + length + ArchiveLayout.CRC_BYTES;
    }

    private static void checkVersion(int version) throws MalformedStreamException {
        if (version == ArchiveLayout.VERSION) return;
        String what = "this archive has version " + version + " of the format, this jSM reads version "
                + ArchiveLayout.VERSION;
        String remedy = version < ArchiveLayout.VERSION ? "; encode the model again" : "; a newer jSM may read it";
        throw new MalformedStreamException(3, what + remedy);
    }

    /**
     * Refuses features that this version does not know.
     *
     * @param unknown a bit for each of them
     * @param first number of the feature of the lowest bit
     */
    static void checkFeatures(int unknown, int first) throws MalformedStreamException {
        if (unknown == 0) return;
        int feature = first + Integer.numberOfTrailingZeros(unknown);
        throw new MalformedStreamException(
                ArchiveLayout.FEATURES_AT,
                "this archive needs feature " + feature
                        + " of the format, which this version does not know; a newer jSM may read it");
    }
}
