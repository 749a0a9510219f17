package org.jsmesh.servlet;

import java.util.List;
import org.jsmesh.page.PageTemplate;
import org.jsmesh.secret.SignKeys;

/**
 * How the servlet answers.
 *
 * @param origins of pages that may read archives with scripts, such as {@code https://example.org}; {@code *} for all
 * @param embedders origins whose pages may have the pages of models in a frame; {@code *} for all. Pages of the same
 *     origin always may
 * @param page address of a page that shows the models, relative to the catalogue: browsers that open the catalogue are
 *     sent there; null when there is none, and browsers get the catalogue as JSON like everybody else
 * @param template of the pages of single models, at {@code {id}/} below the catalogue; null for none
 * @param publicUrl address of the folder of that template as visitors have it, which ends with a slash; null to take
 *     what they asked for
 * @param signKeys that sign the addresses of models, which are good for nothing then without a signature; null for
 *     models that anybody may have
 * @param senders origins of other pages that may send and delete models, such as {@code https://example.org}, or
 *     {@code *} for all; they need a token of the server besides
 * @param viewer that visitors start from the browser with a model; null for none
 */
public record ServletSettings(
        List<String> origins,
        List<String> embedders,
        String page,
        PageTemplate template,
        String publicUrl,
        SignKeys signKeys,
        List<String> senders,
        ViewerJar viewer) {
    /**
     * Checks the settings.
     *
     * @param origins see {@link #origins()}
     * @param embedders see {@link #embedders()}
     * @param page see {@link #page()}
     * @param template see {@link #template()}
     * @param publicUrl see {@link #publicUrl()}
     * @param signKeys see {@link #signKeys()}
     * @param senders see {@link #senders()}
     * @param viewer see {@link #viewer()}
     */
    public ServletSettings {
        origins = List.copyOf(origins);
        embedders = List.copyOf(embedders);
        senders = List.copyOf(senders);
        if (publicUrl != null && !publicUrl.matches("https?://[^\\s\"'<>?#]+/"))
            throw new IllegalArgumentException(
                    "'" + publicUrl + "' is no address such as https://example.org/meshes/, with a slash at its end");
        origins.forEach(ServletSettings::check);
        embedders.forEach(ServletSettings::check);
        senders.forEach(ServletSettings::check);
    }

    private static void check(String origin) {
        if (!origin.matches("\\*|https?://[A-Za-z0-9.\\-\\[\\]:]+"))
            throw new IllegalArgumentException("'" + origin + "' is no origin such as https://example.org, and not *");
    }

    /** {@return settings by which pages from anywhere may read archives, and none has the page in a frame} */
    public static ServletSettings defaults() {
        return new ServletSettings(List.of("*"), List.of(), null, null, null, null, List.of(), null);
    }

    /**
     * Changes whose pages may read archives.
     *
     * @param allowed origins, or {@code *} for all
     * @return settings that differ in that alone
     */
    public ServletSettings withOrigins(List<String> allowed) {
        return new ServletSettings(allowed, embedders, page, template, publicUrl, signKeys, senders, viewer);
    }

    /**
     * Changes whose pages may have the page in a frame, besides those of the same origin.
     *
     * @param allowed origins, or {@code *} for all
     * @return settings that differ in that alone
     */
    public ServletSettings withEmbedders(List<String> allowed) {
        return new ServletSettings(origins, allowed, page, template, publicUrl, signKeys, senders, viewer);
    }

    /**
     * Changes the page that browsers are sent to.
     *
     * @param address relative to the catalogue, or null for none
     * @return settings that differ in that alone
     */
    public ServletSettings withPage(String address) {
        return new ServletSettings(origins, embedders, address, template, publicUrl, signKeys, senders, viewer);
    }

    /**
     * Changes the pages of single models.
     *
     * @param made that they are made from, or null for none
     * @return settings that differ in that alone
     */
    public ServletSettings withTemplate(PageTemplate made) {
        return new ServletSettings(origins, embedders, page, made, publicUrl, signKeys, senders, viewer);
    }

    /**
     * Changes the address that the pages of single models give to those who show links to them.
     *
     * @param address as {@link #publicUrl} has it
     * @return settings that differ in that alone
     */
    public ServletSettings withPublicUrl(String address) {
        return new ServletSettings(origins, embedders, page, template, address, signKeys, senders, viewer);
    }

    /**
     * Asks for signed addresses: {@code settings.withSignKeys(SignKeys.read(file))}. What the keys sign opens the
     * resources of one model, or all; {@link SignKeys#query} signs.
     *
     * @param keys that sign, or null for models that anybody may have
     * @return settings that differ in that alone
     */
    public ServletSettings withSignKeys(SignKeys keys) {
        return new ServletSettings(origins, embedders, page, template, publicUrl, keys, senders, viewer);
    }

    /**
     * Changes whose pages may send and delete models, besides those of the same origin.
     *
     * @param allowed origins, or {@code *} for all
     * @return settings that differ in that alone
     */
    public ServletSettings withSenders(List<String> allowed) {
        return new ServletSettings(origins, embedders, page, template, publicUrl, signKeys, allowed, viewer);
    }

    /**
     * Lets visitors start the desktop viewer from the browser:
     * {@code settings.withViewer(ViewerJar.open(Path.of("jsm-viewer.jar")))}.
     *
     * @param jar of the viewer, signed, or null for none
     * @return settings that differ in that alone
     */
    public ServletSettings withViewer(ViewerJar jar) {
        return new ServletSettings(origins, embedders, page, template, publicUrl, signKeys, senders, jar);
    }
}
