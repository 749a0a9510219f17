package org.jsmesh.mesh.io.zip;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.zip.CRC32;
import java.util.zip.Inflater;
import java.util.zip.InflaterInputStream;

/**
 * A ZIP archive in memory (PKWARE, APPNOTE 6.3): its central directory tells what there is, so that only what is asked
 * for is unpacked. It reads stored and deflated files, also of ZIP64. Names are looked up and lead to no file of the
 * system. Not thread-safe.
 */
public final class ZipArchive {
    private static final int LOCAL = 0x04034B50;
    private static final int CENTRAL = 0x02014B50;
    private static final int END = 0x06054B50;
    private static final int END_64 = 0x06064B50;
    private static final int LOCATOR_64 = 0x07064B50;
    private static final int END_BYTES = 22;
    private static final int CENTRAL_BYTES = 46;
    private static final int LOCAL_BYTES = 30;
    private static final int LONGEST_COMMENT = 0xFFFF;
    private static final int MOST_FILES = 10_000;
    private static final long UNSET = 0xFFFFFFFFL;

    private final ByteBuffer data;
    private final Unpacker unpacker;
    private final Map<String, Entry> entries = new LinkedHashMap<>();

    private record Entry(String name, int flags, int method, long crc, long packed, long unpacked, long local) {}

    /**
     * Reads the directory.
     *
     * @param content a file for which {@link #isZip} holds
     * @param unpacker limits what is unpacked
     * @throws PackedException when the archive is damaged, or has more files than allowed
     */
    public ZipArchive(byte[] content, Unpacker unpacker) throws PackedException {
        data = ByteBuffer.wrap(content).order(ByteOrder.LITTLE_ENDIAN);
        this.unpacker = unpacker;
        try {
            readDirectory();
        } catch (IndexOutOfBoundsException | IllegalArgumentException e) {
            throw damaged();
        }
    }

    /**
     * Tells whether bytes are a ZIP archive.
     *
     * @param content any bytes
     * @return true when they begin as an archive does
     */
    public static boolean isZip(byte[] content) {
        if (content.length < END_BYTES) return false;
        int first = ByteBuffer.wrap(content).order(ByteOrder.LITTLE_ENDIAN).getInt(0);
        return first == LOCAL || first == END;
    }

    /** {@return names of the files with {@code /} between their parts, in the order of the directory; no folders} */
    public Collection<String> names() {
        return entries.keySet();
    }

    private static PackedException damaged() {
        return new PackedException("the ZIP archive is damaged or cut off", "Get it again, or pack it again");
    }

    private void readDirectory() throws PackedException {
        int end = data.capacity() - END_BYTES;
        int last = Math.max(0, end - LONGEST_COMMENT);
        while (end >= last && data.getInt(end) != END) end--;
        if (end < last) throw damaged();
        long count = data.getShort(end + 10) & 0xFFFF;
        long bytes = data.getInt(end + 12) & UNSET;
        long start = data.getInt(end + 16) & UNSET;
        long behind = end;
        if (end >= 20 && data.getInt(end - 20) == LOCATOR_64) {
            int end64 = index(data.getLong(end - 12));
            if (data.getInt(end64) != END_64) throw damaged();
            count = data.getLong(end64 + 32);
            bytes = data.getLong(end64 + 40);
            start = data.getLong(end64 + 48);
            behind = end64;
        }
        if (count > MOST_FILES)
            throw new PackedException("the ZIP archive holds more than " + MOST_FILES + " files", "Pack fewer");
        // Offsets count from the first byte of the archive, which may have other bytes in front
        long shift = Math.max(0, behind - bytes - start);
        int at = index(start + shift);
        for (long i = 0; i < count; i++) at = readEntry(at, shift);
    }

    private int readEntry(int at, long shift) throws PackedException {
        if (data.getInt(at) != CENTRAL) throw damaged();
        int nameBytes = data.getShort(at + 28) & 0xFFFF;
        int extraBytes = data.getShort(at + 30) & 0xFFFF;
        int commentBytes = data.getShort(at + 32) & 0xFFFF;
        byte[] name = new byte[nameBytes];
        data.get(at + CENTRAL_BYTES, name);
        long[] sizes = {data.getInt(at + 24) & UNSET, data.getInt(at + 20) & UNSET, data.getInt(at + 42) & UNSET};
        readExtra(at + CENTRAL_BYTES + nameBytes, extraBytes, sizes);
        String path = new String(name, StandardCharsets.UTF_8).replace('\\', '/');
        Entry entry = new Entry(
                path,
                data.getShort(at + 8) & 0xFFFF,
                data.getShort(at + 10) & 0xFFFF,
                data.getInt(at + 16) & UNSET,
                sizes[1],
                sizes[0],
                sizes[2] + shift);
        if (!path.endsWith("/")) entries.putIfAbsent(path, entry);
        return at + CENTRAL_BYTES + nameBytes + extraBytes + commentBytes;
    }

    /** ZIP64 has those numbers here that do not fit their field. */
    private void readExtra(int from, int bytes, long[] sizes) {
        for (int at = from; at + 4 <= from + bytes; ) {
            int length = data.getShort(at + 2) & 0xFFFF;
            if (data.getShort(at) == 1) {
                int value = at + 4;
                for (int i = 0; i < sizes.length && value + 8 <= at + 4 + length; i++) {
                    if (sizes[i] != UNSET) continue;
                    sizes[i] = data.getLong(value);
                    value += 8;
                }
            }
            at += 4 + length;
        }
    }

    private static int index(long offset) {
        if (offset < 0 || offset > Integer.MAX_VALUE) throw new IndexOutOfBoundsException("offset: " + offset);
        return (int) offset;
    }

    /**
     * Unpacks a file.
     *
     * @param name as in {@link #names}
     * @return its bytes, or null when there is no such file
     * @throws PackedException when it is damaged, encrypted, packed by another method, or larger than allowed
     */
    public byte[] find(String name) throws PackedException {
        Entry entry = entries.get(name);
        if (entry == null) return null;
        if ((entry.flags & 1) != 0)
            throw new PackedException("the ZIP archive is encrypted", "Pack it without a password");
        if (entry.method != 0 && entry.method != 8)
            throw new PackedException(
                    "the ZIP archive is packed by method " + entry.method + ", and jSM knows deflate alone",
                    "Pack it again with an ordinary program");
        try {
            return unpack(entry);
        } catch (PackedException e) {
            throw e;
        } catch (IOException | IndexOutOfBoundsException | IllegalArgumentException e) {
            throw damaged();
        }
    }

    private byte[] unpack(Entry entry) throws IOException {
        int local = index(entry.local);
        if (data.getInt(local) != LOCAL) throw damaged();
        int start = local + LOCAL_BYTES + (data.getShort(local + 26) & 0xFFFF) + (data.getShort(local + 28) & 0xFFFF);
        int packed = index(entry.packed);
        if (packed > data.capacity() - start) throw damaged();
        ByteArrayInputStream in = new ByteArrayInputStream(data.array(), start, packed);
        byte[] bytes;
        if (entry.method == 0) {
            bytes = unpacker.read(in, packed, "the ZIP archive");
        } else {
            Inflater inflater = new Inflater(true);
            try (InflaterInputStream inflated = new InflaterInputStream(in, inflater, 1 << 16)) {
                bytes = unpacker.read(inflated, packed, "the ZIP archive");
            } finally {
                inflater.end();
            }
        }
        CRC32 crc = new CRC32();
        crc.update(bytes);
        if (bytes.length != entry.unpacked || crc.getValue() != entry.crc) throw damaged();
        return bytes;
    }
}
