package org.jsmesh.files.gltf.json;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class JsonTreeTest {
    @ParameterizedTest
    @ValueSource(
            strings = {
                "{\"b\":1.0,\"a\":[1e-9,-0,-0.0,1E+5,100000000000000000000,0.10]}",
                "[true,false,null,\"\\u0001\\\"é\",{},[]]",
                "1e999"
            })
    void shouldWriteBackWhatItRead(String text) throws IOException {
        assertThat(JsonTree.of(text).toString()).isEqualTo(text);
    }

    @ParameterizedTest
    @CsvSource({"0,0", "7,7", "7.0,7", "2147483647,2147483647", "2147483648,-1", "-1,-1", "0.5,-1", "1e999,-1"})
    void shouldTakeWholeNumbersAloneAsAnIndex(String text, int index) throws IOException {
        assertThat(JsonTree.index(JsonTree.of(text))).isEqualTo(index);
    }

    @Test
    void shouldTakeNothingElseAsAnIndex() throws IOException {
        JsonNode tree = JsonTree.of("[\"1\",null,{},[1],true]");
        for (JsonNode node : tree) assertThat(JsonTree.index(node)).isEqualTo(-1);
        assertThat(JsonTree.index(tree.path(9), 5)).isEqualTo(5);
        assertThat(JsonTree.index(tree.path(1), 5)).isEqualTo(5);
        assertThat(JsonTree.index(tree.path(0), 5)).isEqualTo(-1);
    }

    @Test
    void shouldRefuseTextThatIsCutOffOrTooDeep() {
        assertThatThrownBy(() -> JsonTree.of("{\"a\":[1,")).isInstanceOf(JsonProcessingException.class);
        assertThatThrownBy(() -> JsonTree.of("[".repeat(100_000))).isInstanceOf(JsonProcessingException.class);
    }

    @Test
    void shouldReadValuesAsLongAsTheText() throws IOException {
        String text = "{\"a\":\"" + "x".repeat(20_000_001) + "\",\"b\":" + "1".repeat(1200) + "}";
        JsonNode tree = JsonTree.of(text);
        assertThat(tree.path("a").asText()).hasSize(20_000_001);
        assertThat(tree.path("b").toString()).isEqualTo("1".repeat(1200));
        assertThat(JsonTree.of("{\"" + "k".repeat(60_000) + "\":1}").size()).isEqualTo(1);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "{\"a\":[1,2|the text ends in the middle of a value",
                "{\"a\":[1,}]|a value or a mark is missing or wrong",
                "{\"a\":tru}|a value or a mark is missing or wrong"
            })
    void shouldSayInPlainWordsWhatIsWrong(String text, String reason) {
        assertThatThrownBy(() -> JsonTree.of("\n" + text))
                .isInstanceOf(JsonFault.class)
                .hasMessage(reason)
                .extracting(fault -> ((JsonFault) fault).place())
                .isEqualTo("line 2 of the JSON");
    }

    @Test
    void shouldReadFiveHundredLevels() throws IOException {
        assertThat(JsonTree.of("[".repeat(500) + "]".repeat(500)).size()).isEqualTo(1);
        assertThatThrownBy(() -> JsonTree.of("[".repeat(501) + "]".repeat(501)))
                .hasMessage("values lie more than 500 deep in each other");
    }
}
