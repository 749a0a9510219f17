package org.jsmesh.mesh.io;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/** Small PLY files. */
final class PlySamples {
    private static final String[] SQUARE = {
        "ply",
        "format ascii 1.0",
        "element vertex 4",
        "property float x",
        "property float y",
        "property float z",
        "element face 1",
        "property list uchar int vertex_indices",
        "end_header",
        "0 0 0",
        "1 0 0",
        "1 1 0",
        "0 1 0"
    };

    private PlySamples() {}

    static String[] square(String... faceLines) {
        String[] all = java.util.Arrays.copyOf(SQUARE, SQUARE.length + faceLines.length);
        System.arraycopy(faceLines, 0, all, SQUARE.length, faceLines.length);
        return all;
    }

    static byte[] binary(String type, ByteOrder order, int bytes) throws IOException {
        String header = "ply\nformat binary_" + (order == ByteOrder.LITTLE_ENDIAN ? "little" : "big")
                + "_endian 1.0\nelement vertex 3\nproperty " + type + " x\nproperty " + type + " y\nproperty " + type
                + " z\nelement face 1\nproperty list ushort int vertex_indices\nend_header\n";
        ByteBuffer data = ByteBuffer.allocate(9 * bytes + 2 + 12).order(order);
        for (int i = 0; i < 9; i++) {
            int value = i == 3 || i == 7 ? 100 : 0;
            switch (type) {
                case "char", "uchar", "int8", "uint8" -> data.put((byte) value);
                case "short", "ushort", "int16", "uint16" -> data.putShort((short) value);
                case "int", "uint", "int32", "uint32" -> data.putInt(value);
                case "float", "float32" -> data.putFloat(value);
                default -> data.putDouble(value);
            }
        }
        data.putShort((short) 3).putInt(0).putInt(1).putInt(2);
        return join(header.getBytes(StandardCharsets.US_ASCII), data.array());
    }

    private static byte[] join(byte[] a, byte[] b) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.writeBytes(a);
        out.writeBytes(b);
        return out.toByteArray();
    }
}
