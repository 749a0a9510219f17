package org.jsmesh.files;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jsmesh.mesh.io.Resource;
import org.jsmesh.mesh.io.ResourceResolver;

/**
 * What an encoding read: the model file, and every companion that it asked for, found or not, by the SHA-256 of the
 * bytes that it got. Two encodings with equal inputs, settings and {@link ModelEncoding#VERSION} give equal archives.
 * Thread-safe.
 */
public final class ModelInputs {
    private static final ObjectMapper JSON = new ObjectMapper();

    /**
     * A companion.
     *
     * @param path where it was found, relative to the model file; null where none was
     * @param sha256 of its bytes, in lower-case hexadecimal; null likewise
     */
    private record Found(String path, String sha256) {
        static Found of(Optional<Resource> resource) {
            return resource.map(r -> new Found(r.path(), Hashes.sha256(r.content())))
                    .orElse(new Found(null, null));
        }
    }

    private final SortedMap<String, Found> companions = new TreeMap<>();
    private String modelSha256;
    private boolean isChanged;

    /** Nothing was read yet. */
    public ModelInputs() {}

    /**
     * Notes the bytes of the model file.
     *
     * @param content all of them
     */
    public void model(byte[] content) {
        model(Hashes.sha256(content));
    }

    /** @param sha256 of the bytes of the model file; null when they changed while they were read */
    synchronized void model(String sha256) {
        modelSha256 = isChanged ? null : sha256;
    }

    /** {@return the SHA-256 of the model file's bytes, in lower-case hexadecimal; null when they were not read} */
    public synchronized String modelSha256() {
        return modelSha256;
    }

    /**
     * Notes what a resolver finds.
     *
     * @param resolver that finds companions
     * @return one that finds the same
     */
    public ResourceResolver noting(ResourceResolver resolver) {
        return new ResourceResolver() {
            @Override
            public Optional<byte[]> find(String path) throws IOException {
                return locate(path).map(Resource::content);
            }

            @Override
            public Optional<Resource> locate(String path) throws IOException {
                Optional<Resource> found = resolver.locate(path);
                note(path, Found.of(found));
                return found;
            }
        };
    }

    /** A file that changes while it is read twice is none of the files that it was: nothing equals these inputs. */
    private synchronized void note(String path, Found found) {
        Found before = companions.put(path, found);
        if (before == null || before.equals(found)) return;
        isChanged = true;
        modelSha256 = null;
    }

    /**
     * Looks for the same companions again.
     *
     * @param resolver that finds them
     * @return true when every one has the bytes that it had, in the place that it had
     * @throws IOException when one is there but cannot be read
     */
    public boolean areFoundBy(ResourceResolver resolver) throws IOException {
        for (Map.Entry<String, Found> companion : copy().entrySet()) {
            if (!companion.getValue().equals(Found.of(resolver.locate(companion.getKey())))) return false;
        }
        return true;
    }

    /**
     * The files and folders whose size or time changes when a companion does: each companion that was found, and the
     * folders where one was looked for in vain or under another spelling.
     *
     * @param model the model file
     * @return their paths; some may not exist
     */
    public Set<Path> witnesses(Path model) {
        Path folder = ModelFiles.folder(model);
        Set<Path> paths = new LinkedHashSet<>();
        copy().forEach((asked, found) -> {
            FolderResources near = new FolderResources(folder);
            if (found.path() != null) paths.add(folder.resolve(found.path()));
            if (!asked.equals(found.path())) paths.addAll(near.folders(asked));
        });
        return paths;
    }

    private synchronized SortedMap<String, Found> copy() {
        return new TreeMap<>(companions);
    }

    /** {@return these inputs as JSON} */
    public synchronized String toJson() {
        ObjectNode root = JSON.createObjectNode().put("model", modelSha256);
        ArrayNode rows = root.putArray("companions");
        companions.forEach((asked, found) ->
                rows.addObject().put("asked", asked).put("found", found.path()).put("sha256", found.sha256()));
        return root.toString();
    }

    /**
     * Reads what {@link #toJson} wrote.
     *
     * @param json the text
     * @return equal inputs
     * @throws IOException when it is no such text
     */
    public static ModelInputs fromJson(String json) throws IOException {
        ModelInputs inputs = new ModelInputs();
        try {
            inputs.take(JSON.readTree(json));
        } catch (JsonProcessingException e) {
            throw new IOException("no list of inputs: " + e.getOriginalMessage(), e);
        }
        return inputs;
    }

    private synchronized void take(JsonNode root) {
        modelSha256 = text(root, "model");
        for (JsonNode row : root.path("companions")) {
            String asked = Objects.requireNonNullElse(text(row, "asked"), "");
            companions.put(asked, new Found(text(row, "found"), text(row, "sha256")));
        }
    }

    private static String text(JsonNode node, String name) {
        return node.hasNonNull(name) ? node.path(name).asText() : null;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof ModelInputs inputs && toJson().equals(inputs.toJson());
    }

    @Override
    public int hashCode() {
        return toJson().hashCode();
    }

    @Override
    public String toString() {
        return toJson();
    }
}
