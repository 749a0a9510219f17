package org.jsmesh.load;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import org.jsmesh.app.Jsm;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.MeshIdentity;

/**
 * What the server is to send, from the file.
 *
 * @param id in the server's addresses
 * @param bytes of the archive
 * @param sha256 of the archive
 * @param meshSha256 of the original mesh, as a decoder finds it
 */
record Model(String id, byte[] bytes, String sha256, String meshSha256, BatchIndex index) {
    /** Encodes models into a folder to be served. */
    static List<Model> encode(List<Path> files, Path folder) throws IOException {
        Files.createDirectories(folder);
        List<Model> models = new ArrayList<>();
        for (Path file : files) {
            String name = file.getFileName().toString();
            String id = name.substring(0, name.lastIndexOf('.'));
            if (!id.matches("[a-z0-9-]+")) throw new IllegalArgumentException("a name that is no id: " + name);
            Path archive = folder.resolve(id + ".jsm");
            StringWriter err = new StringWriter();
            PrintWriter nowhere = new PrintWriter(new StringWriter());
            String[] command = {"encode", file.toString(), "-o", archive.toString(), "--quiet"};
            if (Jsm.run(nowhere, new PrintWriter(err, true), command) != 0) throw new IOException(err.toString());
            models.add(read(id, archive));
        }
        return models;
    }

    private static Model read(String id, Path archive) throws IOException {
        byte[] bytes = Files.readAllBytes(archive);
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(bytes, 0, bytes.length);
        String mesh = MeshIdentity.sha256(decoder.mesh());
        if (!mesh.equals(decoder.header().meshSha256())) throw new IOException(archive + " is not the original");
        String sha256 = HexFormat.of().formatHex(newDigest().digest(bytes));
        return new Model(id, bytes, sha256, mesh, decoder.header().batches());
    }

    static MessageDigest newDigest() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every JDK has SHA-256", e);
        }
    }

    /** Of so many bytes those that lie in whole batches: what can be shown. */
    long whole(double byteCount) {
        int batches = index.batchesWithin((long) Math.min(byteCount, bytes.length));
        return batches == 0 ? 0 : index.end(batches - 1);
    }

    /** Whether the index can be read from so many bytes: it fills most of what is before the base. */
    boolean isIndexIn(long byteCount) {
        return byteCount >= Math.min(index.end(0), 16384);
    }
}
