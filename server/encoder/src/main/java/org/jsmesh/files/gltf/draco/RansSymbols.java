package org.jsmesh.files.gltf.draco;

import org.jsmesh.files.gltf.packed.PackedBytes;
import org.jsmesh.files.gltf.packed.PackedException;

/**
 * Symbols with a table of probabilities, coded by an asymmetric numeral system (Draco specification, "rANS decoding"
 * and "Symbol decoding").
 */
final class RansSymbols {
    private static final int TAGGED = 0;
    private static final int RAW = 1;
    private static final int TAG_BITS = 5;
    private static final int MOST_RAW_BITS = 18;
    /** Encoders go up to 2^18. */
    private static final int MOST_SYMBOLS = 1 << 20;

    private final int precisionBits;
    private final int[] probabilities;
    private final int[] starts;
    /** The symbol of each remainder. */
    private final int[] symbols;

    private final byte[] bytes;
    private final int from;
    private int at;
    private int state;

    private RansSymbols(PackedBytes in, int symbolBits) throws PackedException {
        precisionBits = Math.max(12, Math.min(20, 3 * symbolBits / 2));
        probabilities = probabilities(in);
        starts = new int[probabilities.length];
        symbols = new int[1 << precisionBits];
        int filled = 0;
        for (int i = 0; i < starts.length; i++) {
            starts[i] = filled;
            int to = filled + probabilities[i];
            if (to < filled || to > symbols.length) throw damaged();
            while (filled < to) symbols[filled++] = i;
        }
        if (filled != symbols.length) throw damaged();
        PackedBytes coded = in.takePart(in.count());
        bytes = coded.bytes;
        from = coded.position();
        int tail = tailBytes(coded);
        at = coded.end() - tail;
        state = (4 << precisionBits) + tail(bytes, at, tail);
        if (state >= 4 << precisionBits + 8) throw damaged();
    }

    private static int[] probabilities(PackedBytes in) throws PackedException {
        int count = in.count();
        if (count / 64 > in.remaining() || count > MOST_SYMBOLS) throw damaged();
        int[] probabilities = new int[count];
        for (int i = 0; i < count; i++) {
            int first = in.next();
            int more = first & 3;
            if (more == 3) {
                // So many more symbols do not occur.
                i += first >> 2;
                if (i >= count) throw damaged();
                continue;
            }
            int probability = first >> 2;
            for (int b = 0; b < more; b++) probability |= in.next() << 8 * b + 6;
            probabilities[i] = probability;
        }
        return probabilities;
    }

    private int next() {
        while (state < 4 << precisionBits && at > from) state = state << 8 | bytes[--at] & 0xFF;
        int rest = state & symbols.length - 1;
        int symbol = symbols[rest];
        state = (state >>> precisionBits) * probabilities[symbol] + rest - starts[symbol];
        return symbol;
    }

    /** Decodes numbers, of which groups of {@code components} share their length in bits. */
    static int[] decode(PackedBytes in, int count, int components) throws PackedException {
        int[] values = new int[count];
        if (count == 0) return values;
        int scheme = in.next();
        if (scheme == RAW) {
            int bits = in.next();
            if (bits < 1 || bits > MOST_RAW_BITS) throw damaged();
            RansSymbols symbols = new RansSymbols(in, bits);
            for (int i = 0; i < count; i++) values[i] = symbols.next();
        } else if (scheme == TAGGED) {
            RansSymbols lengths = new RansSymbols(in, TAG_BITS);
            BitReader bits = new BitReader(in);
            for (int i = 0; i < count; i += components) {
                int length = lengths.next();
                if (length > 32) throw damaged();
                for (int c = 0; c < components; c++) values[i + c] = bits.next(length);
            }
            in.take(bits.bytesRead());
        } else {
            throw new PackedException("the entropy coder " + scheme + " of the Draco data is not known");
        }
        return values;
    }

    /** How many bytes at the end hold the last state of the encoder: its upper two bits tell. */
    static int tailBytes(PackedBytes coded) throws PackedException {
        if (coded.remaining() == 0) throw damaged();
        int tail = (coded.bytes[coded.end() - 1] >> 6 & 3) + 1;
        if (tail > coded.remaining()) throw damaged();
        return tail;
    }

    static int tail(byte[] bytes, int at, int count) {
        int value = 0;
        for (int i = 0; i < count; i++) value |= (bytes[at + i] & 0xFF) << 8 * i;
        return value & (1 << 8 * count - 2) - 1;
    }

    private static PackedException damaged() {
        return new PackedException("the table of an entropy coder is damaged");
    }
}
