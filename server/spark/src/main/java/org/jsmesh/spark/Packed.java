package org.jsmesh.spark;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;
import java.util.zip.InflaterInputStream;

/**
 * Lists of files as short arrays of bytes. The driver holds millions of files so, in 30 to 60 bytes each, and sends
 * them to tasks.
 */
final class Packed {
    /** Files in one array. */
    static final int MOST = 2000;

    private interface Item<T> {
        void write(T item, DataOutputStream out) throws IOException;
    }

    private interface Reader<T> {
        T read(DataInputStream in) throws IOException;
    }

    private Packed() {}

    static byte[] listed(List<ListedModel> files) {
        return pack(files, ListedModel::write);
    }

    static List<ListedModel> listed(byte[] packed) {
        return unpack(packed, ListedModel::read);
    }

    static byte[] planned(List<PlannedModel> models) {
        return pack(models, PlannedModel::write);
    }

    static List<PlannedModel> planned(byte[] packed) {
        return unpack(packed, PlannedModel::read);
    }

    private static <T> byte[] pack(List<T> items, Item<T> item) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        Deflater deflater = new Deflater(Deflater.BEST_SPEED);
        try (DataOutputStream out = new DataOutputStream(new DeflaterOutputStream(bytes, deflater))) {
            out.writeInt(items.size());
            for (T one : items) item.write(one, out);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } finally {
            deflater.end();
        }
        return bytes.toByteArray();
    }

    private static <T> List<T> unpack(byte[] packed, Reader<T> reader) {
        try (DataInputStream in = new DataInputStream(new InflaterInputStream(new ByteArrayInputStream(packed)))) {
            int count = in.readInt();
            List<T> items = new ArrayList<>(count);
            for (int i = 0; i < count; i++) items.add(reader.read(in));
            return items;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
