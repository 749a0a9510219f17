package org.jsmesh.app;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.files.ModelInputs;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.sandbox.ModelEncoder;
import org.jsmesh.sandbox.ModelFilesEncoder;

/**
 * Encodes as the server does by default, but no file twice in a process: most tests want the same one, which takes
 * seconds. Files with companions are left to the encoder.
 */
final class EncodedOnce implements ModelEncoder {
    private static final Map<ByteBuffer, byte[]> ARCHIVES = new ConcurrentHashMap<>();

    private final ModelEncoder encoder = new ModelFilesEncoder(EncoderSettings.defaults());

    @Override
    public ModelInputs encode(Path model, Path archive, ProgressListener progress)
            throws IOException, InterruptedException {
        if (!model.toString().endsWith(".ply")) return encoder.encode(model, archive, progress);
        byte[] content = Files.readAllBytes(model);
        byte[] known = ARCHIVES.get(ByteBuffer.wrap(content));
        if (known == null) {
            encoder.encode(model, archive, progress);
            ARCHIVES.put(ByteBuffer.wrap(content), Files.readAllBytes(archive));
        } else {
            Files.write(archive, known);
        }
        ModelInputs inputs = new ModelInputs();
        inputs.model(content);
        return inputs;
    }

    @Override
    public String settings() {
        return encoder.settings();
    }
}
