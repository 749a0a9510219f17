package org.jsmesh.mesh;

/**
 * SHA-256 (FIPS 180-4), for platforms without MessageDigest. The constants are the first 32 bits of the fractions of
 * cube and square roots of primes. Not thread-safe.
 */
public final class Sha256 implements MeshIdentity.Hash {
    private static final int[] K = new int[64];
    private static final int[] INITIAL = new int[8];

    static {
        int n = 0;
        for (int p = 2; n < 64; p++) {
            boolean prime = true;
            for (int d = 2; d * d <= p; d++) prime &= p % d != 0;
            if (!prime) continue;
            if (n < 8) INITIAL[n] = fractionOfRoot(p, 2);
            K[n++] = fractionOfRoot(p, 3);
        }
    }

    private final int[] state = INITIAL.clone();
    private final int[] w = new int[64];
    private final byte[] block = new byte[64];
    private int filled;
    private long length;

    /**
     * First 32 bits of the fraction of the square or cube root of p, by Newton's method. All of these roots are far
     * enough from a change of the last bit for any rounding.
     */
    private static int fractionOfRoot(int p, int degree) {
        double root = p;
        for (int i = 0; i < 64; i++) root -= (root - p / (degree == 2 ? root : root * root)) / degree;
        return (int) (long) ((root - Math.floor(root)) * 0x1p32);
    }

    /**
     * Hashes one byte more.
     *
     * @param b the byte
     */
    public void update(byte b) {
        block[filled++] = b;
        length++;
        if (filled == 64) {
            compress(block, 0);
            filled = 0;
        }
    }

    @Override
    public void update(byte[] bytes, int offset, int count) {
        int end = offset + count;
        while (offset < end && filled != 0) update(bytes[offset++]);
        for (; end - offset >= 64; offset += 64) {
            compress(bytes, offset);
            length += 64;
        }
        while (offset < end) update(bytes[offset++]);
    }

    /** The digest; the object is used up. */
    @Override
    public byte[] digest() {
        long bits = length * 8;
        update((byte) 0x80);
        while (filled != 56) update((byte) 0);
        for (int s = 56; s >= 0; s -= 8) update((byte) (bits >>> s));
        byte[] out = new byte[32];
        for (int i = 0; i < 32; i++) out[i] = (byte) (state[i >> 2] >> 24 - 8 * (i & 3));
        return out;
    }

    /**
     * Hashes some bytes.
     *
     * @param bytes the bytes
     * @return their digest as 64 lower-case hexadecimal digits
     */
    public static String hex(byte[] bytes) {
        Sha256 sha = new Sha256();
        sha.update(bytes, 0, bytes.length);
        return toHex(sha.digest());
    }

    /**
     * Writes a digest as text.
     *
     * @param digest any bytes
     * @return two lower-case hexadecimal digits for each byte
     */
    public static String toHex(byte[] digest) {
        StringBuilder s = new StringBuilder();
        for (byte b : digest) s.append(Character.forDigit(b >> 4 & 15, 16)).append(Character.forDigit(b & 15, 16));
        return s.toString();
    }

    private void compress(byte[] b, int at) {
        for (int i = 0; i < 16; i++, at += 4) {
            w[i] = b[at] << 24 | (b[at + 1] & 0xff) << 16 | (b[at + 2] & 0xff) << 8 | b[at + 3] & 0xff;
        }
        for (int i = 16; i < 64; i++) {
            int x = w[i - 15];
            int y = w[i - 2];
            int s0 = Integer.rotateRight(x, 7) ^ Integer.rotateRight(x, 18) ^ x >>> 3;
            int s1 = Integer.rotateRight(y, 17) ^ Integer.rotateRight(y, 19) ^ y >>> 10;
            w[i] = w[i - 16] + s0 + w[i - 7] + s1;
        }
        int a = state[0];
        int bb = state[1];
        int c = state[2];
        int d = state[3];
        int e = state[4];
        int f = state[5];
        int g = state[6];
        int h = state[7];
        for (int i = 0; i < 64; i++) {
            int s1 = Integer.rotateRight(e, 6) ^ Integer.rotateRight(e, 11) ^ Integer.rotateRight(e, 25);
            int t1 = h + s1 + (e & f ^ ~e & g) + K[i] + w[i];
            int s0 = Integer.rotateRight(a, 2) ^ Integer.rotateRight(a, 13) ^ Integer.rotateRight(a, 22);
            int t2 = s0 + (a & bb ^ a & c ^ bb & c);
            h = g;
            g = f;
            f = e;
            e = d + t1;
            d = c;
            c = bb;
            bb = a;
            a = t1 + t2;
        }
        state[0] += a;
        state[1] += bb;
        state[2] += c;
        state[3] += d;
        state[4] += e;
        state[5] += f;
        state[6] += g;
        state[7] += h;
    }
}
