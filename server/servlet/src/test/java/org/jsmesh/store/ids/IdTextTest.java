package org.jsmesh.store.ids;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.core.type.TypeReference;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.InputStream;
import java.util.Map;
import org.junit.jupiter.api.Test;

class IdTextTest {
    /** The page's search does the same, and its test reads the same file. */
    @Test
    void shouldWriteNamesAsThePageDoes() throws Exception {
        Map<String, String> texts;
        try (InputStream json = IdTextTest.class.getResourceAsStream("id-text.json")) {
            texts = new ObjectMapper().readValue(json, new TypeReference<Map<String, String>>() {});
        }
        assertThat(texts).hasSizeGreaterThan(20);
        texts.forEach(
                (name, text) -> assertThat(IdText.of(name).text()).as(name).isEqualTo(text));
    }
}
