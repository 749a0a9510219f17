package org.jsmesh.servlet;

import java.nio.charset.StandardCharsets;

/** The text by which Java Web Start programs start the desktop viewer with a model (JNLP, JSR 56). */
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
        return ("""
                <?xml version="1.0" encoding="UTF-8"?>
                <jnlp spec="1.0+" codebase="%s">
                  <information>
                    <title>%s · jSM viewer</title>
                    <vendor>The jSM authors</vendor>
                    <description>Streams a model and shows it as it refines.</description>
                  </information>
                  <security><all-permissions/></security>
                  <resources>
                    <java version="17+"/>
                    <jar href="%s" main="true" size="%d"/>
                  </resources>
                  <application-desc main-class="%s">
                    <argument>%s</argument>
                  </application-desc>
                </jnlp>
                """)
                .formatted(
                        escaped(root),
                        escaped(name),
                        escaped(jar),
                        viewer.bytes(),
                        escaped(viewer.mainClass()),
                        escaped(root + manifest))
                .getBytes(StandardCharsets.UTF_8);
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
