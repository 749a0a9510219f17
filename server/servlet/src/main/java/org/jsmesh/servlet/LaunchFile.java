package org.jsmesh.servlet;

import java.nio.charset.StandardCharsets;

/**
 * The text by which Java Web Start programs start the desktop viewer with a model (JNLP, JSR 56). They refuse it unless
 * it fits the template in the viewer, {@code JNLP-INF/APPLICATION_TEMPLATE.JNLP}.
 */
final class LaunchFile {
    static final String TYPE = "application/x-java-jnlp-file";

    private LaunchFile() {}

    /**
     * @param root address of the folder of the catalogue, with a slash at its end
     * @param jar address of the viewer, relative to that
     * @param name of the model, as anybody may have written it
     * @param manifest address of the model's manifest, relative to the folder of the catalogue
     */
    static byte[] of(String root, String jar, ViewerJar.State viewer, String name, String manifest) {
        String text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                + "<jnlp spec=\"1.0+\" codebase=\"" + escaped(root) + "\">\n"
                + "  <information>\n"
                + "    <title>" + escaped(name) + " · jSM viewer</title>\n"
                + "    <vendor>The jSM authors</vendor>\n"
                + "    <description>Streams a model and shows it as it refines.</description>\n"
                + "  </information>\n"
                + "  <security><all-permissions/></security>\n"
                + "  <resources>\n"
                + "    <java version=\"17+\"/>\n"
                + "    <jar href=\"" + escaped(jar) + "\" main=\"true\" size=\"" + viewer.bytes() + "\"/>\n"
                + "  </resources>\n"
                + "  <application-desc main-class=\"" + escaped(viewer.mainClass()) + "\">\n"
                // No option follows, says the template, too.
                + "    <argument>--</argument>\n"
                + "    <argument>" + escaped(root + manifest) + "</argument>\n"
                + "  </application-desc>\n"
                + "</jnlp>\n";
        return text.getBytes(StandardCharsets.UTF_8);
    }

    /** XML has no character references for most control characters, so they become spaces. */
    private static String escaped(String text) {
        StringBuilder escaped = new StringBuilder();
        text.codePoints().forEach(c -> {
            switch (c) {
                case '&' -> escaped.append("&amp;");
                case '<' -> escaped.append("&lt;");
                case '>' -> escaped.append("&gt;");
                case '"' -> escaped.append("&quot;");
                case '\'' -> escaped.append("&#39;");
                default -> escaped.appendCodePoint(isText(c) ? c : ' ');
            }
        });
        return escaped.toString();
    }

    private static boolean isText(int c) {
        return c >= ' ' && c <= 0xd7ff || c >= 0xe000 && c <= 0xfffd || c >= 0x10000;
    }
}
