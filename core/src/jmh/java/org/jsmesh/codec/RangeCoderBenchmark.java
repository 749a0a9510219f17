package org.jsmesh.codec;

import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.RangeDecoder;
import org.jsmesh.codec.entropy.RangeEncoder;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/** Nanoseconds per adaptive bit, under one context and under the mean of two, and per symbol of 11 raw bits. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
public class RangeCoderBenchmark {
    private static final int SYMBOLS = 1 << 18;
    private static final int CONTEXTS = 64;
    private static final int RAW_BITS = 11;

    private final int[] first = new int[SYMBOLS];
    private final int[] second = new int[SYMBOLS];
    private final int[] values = new int[SYMBOLS];
    private byte[] bits;
    private byte[] mixedBits;
    private byte[] raw;

    /** Bits of contexts from the surest to the most doubtful, in no order. */
    @Setup
    public void code() {
        Random random = new Random(1);
        for (int i = 0; i < SYMBOLS; i++) {
            first[i] = random.nextInt(CONTEXTS);
            second[i] = (first[i] + random.nextInt(CONTEXTS / 4)) % CONTEXTS;
            int bit = random.nextInt(2 * CONTEXTS) < first[i] ? 1 : 0;
            values[i] = random.nextInt(1 << RAW_BITS - 1) << 1 | bit;
        }
        bits = encodeBits();
        mixedBits = encodeMixedBits();
        raw = encodeRaw();
    }

    @Benchmark
    @OperationsPerInvocation(SYMBOLS)
    public byte[] encodeBits() {
        RangeEncoder encoder = new RangeEncoder();
        int[] contexts = BinaryCoder.newContexts(CONTEXTS);
        for (int i = 0; i < SYMBOLS; i++) encoder.bit(contexts, first[i], values[i] & 1);
        return encoder.finish();
    }

    @Benchmark
    @OperationsPerInvocation(SYMBOLS)
    public int decodeBits() {
        RangeDecoder decoder = new RangeDecoder(bits, 0, bits.length);
        int[] contexts = BinaryCoder.newContexts(CONTEXTS);
        int ones = 0;
        for (int i = 0; i < SYMBOLS; i++) ones += decoder.bit(contexts, first[i], 0);
        return ones;
    }

    @Benchmark
    @OperationsPerInvocation(SYMBOLS)
    public byte[] encodeMixedBits() {
        RangeEncoder encoder = new RangeEncoder();
        int[] contexts = BinaryCoder.newContexts(CONTEXTS);
        int[] others = BinaryCoder.newContexts(CONTEXTS);
        for (int i = 0; i < SYMBOLS; i++) encoder.bit(contexts, first[i], others, second[i], values[i] & 1);
        return encoder.finish();
    }

    @Benchmark
    @OperationsPerInvocation(SYMBOLS)
    public int decodeMixedBits() {
        RangeDecoder decoder = new RangeDecoder(mixedBits, 0, mixedBits.length);
        int[] contexts = BinaryCoder.newContexts(CONTEXTS);
        int[] others = BinaryCoder.newContexts(CONTEXTS);
        int ones = 0;
        for (int i = 0; i < SYMBOLS; i++) ones += decoder.bit(contexts, first[i], others, second[i], 0);
        return ones;
    }

    @Benchmark
    @OperationsPerInvocation(SYMBOLS)
    public byte[] encodeRaw() {
        RangeEncoder encoder = new RangeEncoder();
        for (int i = 0; i < SYMBOLS; i++) encoder.raw(values[i], RAW_BITS);
        return encoder.finish();
    }

    @Benchmark
    @OperationsPerInvocation(SYMBOLS)
    public int decodeRaw() {
        RangeDecoder decoder = new RangeDecoder(raw, 0, raw.length);
        int sum = 0;
        for (int i = 0; i < SYMBOLS; i++) sum += decoder.raw(0, RAW_BITS);
        return sum;
    }
}
