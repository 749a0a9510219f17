package org.jsmesh.mesh.io;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;

/** Buffers binary values for a stream, least byte first. */
final class LittleEndianOutput implements Closeable {
    private final OutputStream out;
    private final byte[] buffer = new byte[1 << 16];
    private int size;

    LittleEndianOutput(OutputStream out) {
        this.out = out;
    }

    void writeByte(int value) throws IOException {
        if (size == buffer.length) flush();
        buffer[size++] = (byte) value;
    }

    void writeShort(int value) throws IOException {
        writeByte(value);
        writeByte(value >> 8);
    }

    void writeInt(int value) throws IOException {
        if (size + 4 > buffer.length) flush();
        buffer[size] = (byte) value;
        buffer[size + 1] = (byte) (value >> 8);
        buffer[size + 2] = (byte) (value >> 16);
        buffer[size + 3] = (byte) (value >> 24);
        size += 4;
    }

    void writeFloat(float value) throws IOException {
        writeInt(Float.floatToRawIntBits(value));
    }

    void writeDouble(double value) throws IOException {
        long bits = Double.doubleToRawLongBits(value);
        writeInt((int) bits);
        writeInt((int) (bits >>> 32));
    }

    void write(byte[] bytes) throws IOException {
        flush();
        out.write(bytes);
    }

    private void flush() throws IOException {
        out.write(buffer, 0, size);
        size = 0;
    }

    @Override
    public void close() throws IOException {
        try (out) {
            flush();
        }
    }
}
