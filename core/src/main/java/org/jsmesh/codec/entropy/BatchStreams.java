package org.jsmesh.codec.entropy;

/** The coders of a batch's three parts. */
public record BatchStreams(BinaryCoder connectivity, BinaryCoder geometry, BinaryCoder attributes) {
    /** True when a decoder has come to the end of one of the parts, and what it gives from then on is of no worth. */
    public boolean isExhausted() {
        return connectivity.isExhausted() || geometry.isExhausted() || attributes.isExhausted();
    }
}
