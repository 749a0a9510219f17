package org.jsmesh.page;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Base64;
import java.util.Locale;

/** What the page of a model says of it. Everything is escaped: names of models are anybody's. */
final class PageWords {
    private static final ObjectMapper JSON = new ObjectMapper();
    private static final int WIDTH = 480;
    private static final int HEIGHT = 360;
    private static final String SLOGAN = "Appears at once and refines to the original, bit for bit.";

    private final String folder; // of the model, from the template's
    private final ObjectNode manifest;
    private final byte[] poster;
    private final String root;
    private final String name;

    PageWords(String segment, String manifest, byte[] poster, String root) {
        folder = "m/" + segment + "/";
        this.manifest = read(manifest);
        this.poster = poster;
        this.root = root;
        name = escaped(
                this.manifest.path("name").asText(this.manifest.path("id").asText()));
    }

    private static ObjectNode read(String manifest) {
        try {
            if (JSON.readTree(manifest) instanceof ObjectNode object) return object;
        } catch (JsonProcessingException e) {
            throw new IllegalArgumentException("the manifest is no JSON", e);
        }
        throw new IllegalArgumentException("the manifest is no JSON object");
    }

    String title() {
        return name + " · jSM";
    }

    String description() {
        String facts = counts();
        return name + (facts.isEmpty() ? "" : ", a model of " + facts) + ". " + SLOGAN;
    }

    private boolean isEncoded() {
        return manifest.hasNonNull("archiveUrl");
    }

    private String counts() {
        if (!isEncoded()) return "";
        long bytes = manifest.path("bytes").asLong();
        return String.format(
                Locale.ROOT, "%,d faces in %,d kB", manifest.path("faces").asLong(), Math.max(1, bytes / 1000));
    }

    /** For those who show links to the page. */
    String tags() {
        StringBuilder tags = new StringBuilder();
        tag(tags, "property", "og:type", "website");
        tag(tags, "property", "og:title", name);
        tag(tags, "property", "og:description", description());
        if (root != null) tag(tags, "property", "og:url", escaped(root + folder));
        if (poster != null) {
            String address = folder + manifest.path("posterUrl").asText();
            tag(tags, "property", "og:image", escaped(root == null ? address : root + address));
            tag(tags, "property", "og:image:type", "image/jpeg");
            tag(tags, "property", "og:image:width", Integer.toString(WIDTH));
            tag(tags, "property", "og:image:height", Integer.toString(HEIGHT));
            tag(tags, "property", "og:image:alt", name);
        }
        tag(tags, "name", "twitter:card", poster == null ? "summary" : "summary_large_image");
        return tags.append("  ").toString();
    }

    /** The first bytes of the archive are asked for before any script runs. */
    String hints() {
        if (!manifest.hasNonNull("firstUrl")) return "";
        String address = escaped(folder + manifest.path("firstUrl").asText());
        return "  <link rel=\"preload\" as=\"fetch\" crossorigin href=\"" + address + "\">\n  ";
    }

    private static void tag(StringBuilder tags, String kind, String key, String value) {
        tags.append("  <meta ").append(kind).append("=\"").append(key);
        tags.append("\" content=\"").append(value).append("\">\n  ");
    }

    /** The poster, then what scripts want to know: both come before all else. */
    String first() {
        String picture = poster == null
                ? ""
                : "\n    <img class=\"poster\" id=\"poster\" alt=\"" + name + "\" width=\"" + WIDTH + "\" height=\""
                        + HEIGHT + "\" src=\"data:image/jpeg;base64,"
                        + Base64.getEncoder().encodeToString(poster) + "\">";
        ObjectNode known = manifest.deepCopy();
        // The index is long; a decoder reads it from the archive.
        known.remove("batches");
        known.put("manifestUrl", folder + manifest.path("manifestUrl").asText("manifest.json"));
        String json = known.toString().replace("<", "\\u003c");
        return picture + "\n    <script type=\"application/json\" id=\"manifest\">" + json + "</script>";
    }

    /** For those without scripts. */
    String facts() {
        StringBuilder facts = new StringBuilder("<h2>" + name + "</h2>");
        if (!isEncoded())
            return facts.append("<p>This model is not encoded yet.</p>").toString();
        facts.append("<p>").append(counts()).append(".</p><ul>");
        link(facts, manifest.path("archiveUrl").asText(), "The model as a .jsm archive");
        if (poster != null) link(facts, manifest.path("posterUrl").asText(), "The picture as a JPEG file");
        return facts.append("</ul>").toString();
    }

    private void link(StringBuilder facts, String address, String text) {
        facts.append("<li><a href=\"")
                .append(escaped(folder + address))
                .append("\" download>")
                .append(text)
                .append("</a></li>");
    }

    private static String escaped(String text) {
        return text.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;")
                .replace("'", "&#39;");
    }
}
