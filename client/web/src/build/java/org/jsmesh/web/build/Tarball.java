package org.jsmesh.web.build;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.zip.GZIPOutputStream;

/** Files as {@code npm pack} packs them: in a folder {@code package}, sorted, of one date, and packed by gzip. */
final class Tarball {
    private static final int BLOCK = 512;

    /** The first of January 2026, as all files of the project are dated. */
    private static final long DATE = 1767225600;

    private static final int SUM_AT = 148;

    private Tarball() {}

    static void write(Path folder, Path tarball) throws IOException {
        try (OutputStream out = new GZIPOutputStream(Files.newOutputStream(tarball))) {
            for (Path file : Folders.files(folder)) {
                byte[] content = Files.readAllBytes(file);
                out.write(header("package/" + Folders.relative(folder, file), content.length));
                out.write(content);
                out.write(new byte[(BLOCK - content.length % BLOCK) % BLOCK]);
            }
            out.write(new byte[2 * BLOCK]);
        }
    }

    /** Of the format ustar. */
    private static byte[] header(String name, int bytes) throws IOException {
        byte[] header = new byte[BLOCK];
        if (name.length() > 99) throw new IOException("the name " + name + " is too long for a tarball");
        put(header, 0, name);
        put(
                header,
                100,
                "0000644\0" + "0000000\0" + "0000000\0" + "%011o\0%011o\0".formatted(bytes, DATE) + "        0");
        put(header, 257, "ustar\0" + "00");
        int sum = 0;
        for (byte b : header) sum += b & 0xff;
        put(header, SUM_AT, "%06o\0 ".formatted(sum));
        return header;
    }

    private static void put(byte[] header, int at, String text) {
        byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
        System.arraycopy(bytes, 0, header, at, bytes.length);
    }
}
