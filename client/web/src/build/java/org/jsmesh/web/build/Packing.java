package org.jsmesh.web.build;

import com.aayushatharva.brotli4j.Brotli4jLoader;
import com.aayushatharva.brotli4j.encoder.Encoder;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import java.util.zip.Deflater;
import java.util.zip.GZIPOutputStream;

/** Packs files by gzip and Brotli, each as tight as it goes: {@code NAME.gz} and {@code NAME.br} beside it. */
final class Packing {
    /** Types that are packed in themselves. */
    private static final Set<String> PACKED = Set.of("png", "jpg", "webp", "woff2");

    /** Smaller ones fit into one packet either way. */
    private static final int SMALLEST = 200;

    private Packing() {}

    /** Packs all in the folder; those whose bytes do not get fewer have nothing beside them. Gives the plain files. */
    static Set<Path> pack(Path folder) throws IOException {
        boolean hasBrotli = Brotli4jLoader.isAvailable();
        if (!hasBrotli) {
            System.out.println("WARNING: there is no Brotli for this machine, so the page comes without .br files: "
                    + Brotli4jLoader.getUnavailabilityCause());
        }
        Set<Path> plain = new TreeSet<>(Folders.files(folder));
        plain.removeIf(file -> file.toString().matches(".*\\.(gz|br)"));
        for (Path file : plain) {
            String name = file.getFileName().toString();
            byte[] content = Files.readAllBytes(file);
            if (content.length < SMALLEST || PACKED.contains(name.substring(name.lastIndexOf('.') + 1))) continue;
            write(file.resolveSibling(name + ".gz"), gzip(content), content);
            if (hasBrotli) write(file.resolveSibling(name + ".br"), brotli(content), content);
        }
        return plain;
    }

    private static void write(Path file, byte[] packed, byte[] content) throws IOException {
        if (packed.length < content.length) Files.write(file, packed);
    }

    private static byte[] gzip(byte[] content) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (OutputStream gzip = new Tightest(out)) {
            gzip.write(content);
        }
        return out.toByteArray();
    }

    private static byte[] brotli(byte[] content) throws IOException {
        return Encoder.compress(content, new Encoder.Parameters().setQuality(11).setWindow(24));
    }

    private static final class Tightest extends GZIPOutputStream {
        Tightest(OutputStream out) throws IOException {
            super(out);
            def.setLevel(Deflater.BEST_COMPRESSION);
        }
    }
}
