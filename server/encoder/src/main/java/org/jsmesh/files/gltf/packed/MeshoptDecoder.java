package org.jsmesh.files.gltf.packed;

import java.nio.ByteBuffer;

/**
 * Decodes one buffer view of EXT_meshopt_compression or KHR_meshopt_compression, as the latter's specification
 * describes it (appendices A and B; the former is the same without version 1 of ATTRIBUTES and without COLOR). Memory
 * is allocated only after the bytes were found long enough for their count: at most about a thousand bytes for each
 * packed one. Thread-safe.
 */
public final class MeshoptDecoder {
    /** More than any buffer view that can be used; a Java array ends at twice that. */
    private static final long MOST_BYTES = 1L << 30;

    private MeshoptDecoder() {}

    /**
     * Decodes all elements of a view.
     *
     * @param packed the compressed bytes, from position to limit; neither is changed
     * @param count number of elements, of indices in the modes TRIANGLES and INDICES
     * @param stride bytes of an element
     * @param mode ATTRIBUTES, TRIANGLES or INDICES
     * @param filter NONE, OCTAHEDRAL, QUATERNION, EXPONENTIAL or COLOR; null is NONE
     * @return count times stride bytes, little endian
     * @throws PackedException when the bytes do not hold that, or hold more
     */
    public static byte[] decode(ByteBuffer packed, int count, int stride, String mode, String filter)
            throws PackedException {
        String wanted = filter == null ? "NONE" : filter;
        if (mode == null) throw new PackedException("there is no compression mode");
        if (count < 0 || stride < 0 || (long) count * stride > MOST_BYTES) {
            throw new PackedException(count + " elements of " + stride + " bytes are too many");
        }
        return switch (mode) {
            case "ATTRIBUTES" -> attributes(packed, count, stride, wanted);
            case "TRIANGLES" -> {
                requireIndices(stride, mode, wanted);
                yield TriangleStream.decode(new PackedBytes(packed), count, stride);
            }
            case "INDICES" -> {
                requireIndices(stride, mode, wanted);
                yield IndexStream.decode(new PackedBytes(packed), count, stride);
            }
            default -> throw new PackedException("the compression mode " + mode + " is not known");
        };
    }

    private static byte[] attributes(ByteBuffer packed, int count, int stride, String filter) throws PackedException {
        if (stride < 4 || stride > 256 || stride % 4 != 0) throw wrongStride(stride, "ATTRIBUTES");
        MeshoptFilter wanted = MeshoptFilter.named(filter);
        if (!wanted.takes(stride)) throw wrongStride(stride, filter);
        byte[] values = AttributeStream.decode(new PackedBytes(packed), count, stride);
        wanted.apply(values, stride);
        return values;
    }

    private static void requireIndices(int stride, String mode, String filter) throws PackedException {
        if (stride != 2 && stride != 4) throw wrongStride(stride, mode);
        if (!filter.equals("NONE")) throw new PackedException("the mode " + mode + " has the filter " + filter);
    }

    private static PackedException wrongStride(int stride, String what) {
        return new PackedException(what + " has a stride of " + stride + " bytes");
    }
}
