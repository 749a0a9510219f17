package org.jsmesh.spark;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import org.jsmesh.files.ModelEncoding;

/**
 * What a run did.
 *
 * @param run its name
 * @param listed models among the inputs
 * @param skipped of these, those that had not changed and are in the site
 * @param encoded of these, those that were encoded and published
 * @param failed of these, those that have no archive of their present file
 * @param removed models that went from the site
 * @param published models in the catalogue
 * @param failures the first of the failed ones
 */
record Outcome(
        String run,
        long listed,
        long skipped,
        long encoded,
        long failed,
        long removed,
        long published,
        List<Row> failures) {

    ObjectNode toJson(CatalogueSettings settings) {
        ObjectNode json = new ObjectMapper().createObjectNode();
        json.put("run", run).put("site", settings.site()).put("settings", settings.key());
        json.put("encoderVersion", ModelEncoding.VERSION);
        json.put("listed", listed).put("skipped", skipped).put("encoded", encoded);
        return json.put("failed", failed).put("removed", removed).put("published", published);
    }

    @Override
    public String toString() {
        return listed + " models: " + skipped + " unchanged, " + encoded + " encoded, " + failed + " failed; " + removed
                + " removed; " + published + " in the catalogue";
    }
}
