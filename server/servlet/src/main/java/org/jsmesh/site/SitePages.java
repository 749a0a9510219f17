package org.jsmesh.site;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.jsmesh.files.ArchiveParts;
import org.jsmesh.page.PageTemplate;
import org.jsmesh.store.ids.ModelIds;

/** The pages of the models of a site. */
final class SitePages {
    private final PageTemplate template;
    private final String publicUrl;

    /**
     * @param page of the site
     * @param publicUrl its address, or null when that is not known
     */
    SitePages(byte[] page, String publicUrl) {
        template = new PageTemplate(new String(page, StandardCharsets.UTF_8), Map.of());
        this.publicUrl = publicUrl;
    }

    /** @param folder of the model, with its manifest */
    byte[] page(String id, Path folder) throws IOException {
        JsonNode manifest = SiteCatalogue.manifest(folder);
        // What a manifest says is what this program wrote; the file is looked for in the model's own folder alone.
        Path poster = folder.resolve(manifest.path("archiveSha256").asText()).resolve(ArchiveParts.POSTER);
        byte[] jpeg = manifest.has("posterUrl") && Files.isRegularFile(poster) ? Files.readAllBytes(poster) : null;
        return template.page(ModelIds.segment(id), manifest.toString(), jpeg, publicUrl)
                .getBytes(StandardCharsets.UTF_8);
    }
}
