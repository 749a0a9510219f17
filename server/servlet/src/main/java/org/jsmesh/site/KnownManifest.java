package org.jsmesh.site;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.NoSuchFileException;
import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.StoredObject;

/**
 * A manifest that is there before a model is published again.
 *
 * @param object null when there is none
 * @param content empty then
 * @param json of the content
 */
record KnownManifest(StoredObject object, byte[] content, JsonNode json) {
    private static final Duration MOST_AHEAD = Duration.ofHours(-1);

    static KnownManifest read(ObjectStore store, String id) throws IOException {
        String key = ModelKeys.manifest(id);
        StoredObject object = store.find(key).orElse(null);
        if (object != null) {
            try (InputStream in = store.open(key)) {
                byte[] content = in.readAllBytes();
                return new KnownManifest(object, content, json(content));
            } catch (NoSuchFileException e) {
                // It was removed meanwhile.
            }
        }
        return new KnownManifest(null, new byte[0], CatalogueJson.JSON.missingNode());
    }

    private static JsonNode json(byte[] content) throws IOException {
        try {
            return CatalogueJson.JSON.readTree(content);
        } catch (JsonProcessingException e) {
            return CatalogueJson.JSON.missingNode(); // It is damaged, and will be written again.
        }
    }

    boolean hasArchive(String hash) {
        return json.path("archiveSha256").asText().equals(hash);
    }

    boolean hasAnnotations() {
        return json.has("annotationsUrl");
    }

    boolean is(byte[] other) {
        return object != null && Arrays.equals(content, other);
    }

    /** Whether another run may be about to remove the model. */
    boolean isOld() {
        return object != null && isOld(object);
    }

    /**
     * Whether another run may be about to remove an object. Clean-up leaves alone what is younger than a day; the rest
     * of that is for the update that names the object. An object from the future tells nothing, as the clocks differ.
     */
    static boolean isOld(StoredObject object) {
        Duration age = Duration.between(object.modified(), Instant.now());
        return age.compareTo(OldArchives.KEPT.dividedBy(2)) > 0 || age.compareTo(MOST_AHEAD) < 0;
    }
}
