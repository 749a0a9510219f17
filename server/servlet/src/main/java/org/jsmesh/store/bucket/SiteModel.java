package org.jsmesh.store.bucket;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.util.regex.Pattern;
import org.jsmesh.store.ModelUnavailableException;

/**
 * A model of a site, as its manifest has it.
 *
 * @param id of the model
 * @param name for people
 * @param sha256 of its present archive
 * @param manifest the JSON; shared, not copied
 */
public record SiteModel(String id, String name, String sha256, byte[] manifest) {
    private static final ObjectMapper JSON = new ObjectMapper();
    private static final Pattern ARCHIVE = Pattern.compile("[0-9a-f]{64}\\.jsm");

    static SiteModel of(String id, byte[] manifest) throws ModelUnavailableException {
        try {
            JsonNode root = JSON.readTree(manifest);
            String archive = root.path("archiveUrl").asText();
            if (ARCHIVE.matcher(archive).matches())
                return new SiteModel(id, root.path("name").asText(id), archive.substring(0, 64), manifest);
        } catch (IOException e) {
            // It is told below, like a manifest that lacks something.
        }
        throw ModelUnavailableException.ofModel(
                "the manifest of the model '" + id + "' is damaged", "publish the model again", null);
    }
}
