package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ResourcePathTest {
    private static final String SHA = "0123456789abcdef".repeat(4);

    @Test
    void shouldTellResourcesApart() {
        assertThat(ResourcePath.parse("/a-1")).isEqualTo(new ResourcePath(ResourcePath.Kind.MODEL, "a-1", null, 0, 0));
        assertThat(ResourcePath.parse("/a-1/")).isEqualTo(new ResourcePath(ResourcePath.Kind.PAGE, "a-1", null, 0, 0));
        assertThat(ResourcePath.parse("/a/" + SHA + "/poster.jpg"))
                .isEqualTo(new ResourcePath(ResourcePath.Kind.POSTER, "a", SHA, 0, 0));
        assertThat(ResourcePath.parse("/a/" + SHA + "/first.jsm"))
                .isEqualTo(new ResourcePath(ResourcePath.Kind.FIRST, "a", SHA, 0, 0));
        assertThat(ResourcePath.parse("/a/manifest.json"))
                .isEqualTo(new ResourcePath(ResourcePath.Kind.MANIFEST, "a", null, 0, 0));
        assertThat(ResourcePath.parse("/a/viewer.jnlp"))
                .isEqualTo(new ResourcePath(ResourcePath.Kind.LAUNCH, "a", null, 0, 0));
        assertThat(ResourcePath.parse("/a/" + SHA + ".jsm"))
                .isEqualTo(new ResourcePath(ResourcePath.Kind.ARCHIVE, "a", SHA, 0, 0));
        assertThat(ResourcePath.parse("/a/" + SHA + "/patches"))
                .isEqualTo(new ResourcePath(ResourcePath.Kind.PATCHES, "a", SHA, 0, 0));
        assertThat(ResourcePath.parse("/a/" + SHA + "/batches/0-999999999"))
                .isEqualTo(new ResourcePath(ResourcePath.Kind.BATCHES, "a", SHA, 0, 999_999_999));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "/",
                "//",
                "/A",
                "/..",
                "/a.b",
                "/é",
                "/a/x",
                "/a/manifest.json/",
                "/a/manifest.jsonx",
                "/a/viewer.jnlp/",
                "/a/viewer",
                "/a//manifest.json",
                "//manifest.json",
                "/a/SHA",
                "/a/SHA/",
                "/a/SHA/poster.jpg/",
                "/a/SHA/poster.png",
                "/a/SHA/first",
                "/a/SHA/batches/",
                "/a/SHA/batches/0",
                "/a/SHA/batches/-",
                "/a/SHA/batches/00-1",
                "/a/SHA/batches/0-01",
                "/a/SHA/batches/0-1-2",
                "/a/SHA/batches/+0-1",
                "/a/SHA/batches/0-1000000000",
                "/a/SHA.jsm/",
                "/a/SHA.jsmx",
                "/a/SHA/patches/x"
            })
    void shouldKnowNothingElse(String path) {
        assertThat(ResourcePath.parse(path.replace("SHA", SHA))).isNull();
        assertThat(ResourcePath.parse("/a/" + SHA.toUpperCase(java.util.Locale.ROOT) + ".jsm"))
                .isNull();
    }
}
