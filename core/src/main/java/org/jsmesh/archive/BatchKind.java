package org.jsmesh.archive;

/** What a batch of an archive holds. */
public enum BatchKind {
    /** The opening of the file, with the index of the first batches, and the base mesh: always batch 0. */
    BASE,
    /** The rest of header and index. */
    HEADER,
    /** Vertex splits of one pass or of several, and components that come at the start of a pass. */
    SPLITS,
    /** More bits of the positions of a range of vertices. */
    PRECISION,
    /** A range of the bytes of the original order. */
    ORDER,
    /** A range of the bytes of a texture. */
    TEXTURE,
    /** A stage of a small picture that stands for a texture until that has arrived. */
    PREVIEW,
    /**
     * Exact attributes of a range of wedges, after all splits: 8-bit values at any precision of the positions, other
     * values once positions are exact.
     */
    ATTRIBUTES,
    /**
     * A range of the bytes that lead from float32 to the original: last bits of doubles and of large whole numbers,
     * attributes of faces.
     */
    REMAINDER,
    /** A small picture of the model, a JPEG file; it is no part of the original. */
    POSTER
}
