package org.jsmesh.codec.entropy;

/** The coders of a batch's three parts. */
public record BatchStreams(BinaryCoder connectivity, BinaryCoder geometry, BinaryCoder attributes) {
    /** True when a decoder has read beyond the end of one of the parts. Its values are worthless from then on. */
    public boolean isExhausted() {
        return connectivity.isExhausted() || geometry.isExhausted() || attributes.isExhausted();
    }
}
