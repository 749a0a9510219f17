package org.jsmesh.app;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.store.ModelEncoder;
import org.jsmesh.store.ModelFilesEncoder;

/**
 * Encodes as the server does by default, but no file twice in a process: most tests want the same one, which takes
 * seconds. Files with companions are left to the encoder.
 */
final class EncodedOnce implements ModelEncoder {
    private static final Map<ByteBuffer, byte[]> ARCHIVES = new ConcurrentHashMap<>();

    private final ModelEncoder encoder = new ModelFilesEncoder(EncoderSettings.defaults());

    @Override
    public byte[] encode(Path model, ProgressListener progress) throws IOException {
        if (!model.toString().endsWith(".ply")) return encoder.encode(model, progress);
        ByteBuffer content = ByteBuffer.wrap(Files.readAllBytes(model));
        byte[] archive = ARCHIVES.get(content);
        if (archive == null) {
            archive = encoder.encode(model, progress);
            ARCHIVES.put(content, archive);
        }
        return archive.clone();
    }

    @Override
    public String settings() {
        return encoder.settings();
    }
}
