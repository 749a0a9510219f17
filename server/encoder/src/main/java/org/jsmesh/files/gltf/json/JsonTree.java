package org.jsmesh.files.gltf.json;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.core.exc.StreamConstraintsException;
import com.fasterxml.jackson.core.io.JsonEOFException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.MissingNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.UncheckedIOException;

/**
 * A JSON text as a tree that keeps the order of keys and the text of numbers. Nothing in it is checked: whoever uses a
 * part looks whether it is of the right kind.
 */
public final class JsonTree {
    /** How deep values may lie in each other. */
    private static final int DEEPEST = 500;

    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

    private JsonTree() {}

    /**
     * The first value of the text; the missing node when there is none.
     *
     * @throws JsonFault when the text is no JSON
     */
    public static JsonNode of(String text) throws JsonFault {
        try (JsonParser parser = factory(text.length()).createParser(text)) {
            return parser.nextToken() == null ? MissingNode.getInstance() : value(parser);
        } catch (StreamConstraintsException e) {
            throw new JsonFault(e, "values lie more than " + DEEPEST + " deep in each other");
        } catch (JsonEOFException e) {
            throw new JsonFault(e, "the text ends in the middle of a value");
        } catch (JsonProcessingException e) {
            throw new JsonFault(e, "a value or a mark is missing or wrong");
        } catch (IOException e) {
            throw new UncheckedIOException(e); // a text is read without input
        }
    }

    /** A text may be one long value. */
    private static JsonFactory factory(int length) {
        int most = Math.max(1, length);
        return JsonFactory.builder()
                .streamReadConstraints(StreamReadConstraints.builder()
                        .maxNestingDepth(DEEPEST)
                        .maxStringLength(most)
                        .maxNumberLength(most)
                        .maxNameLength(most)
                        .build())
                .build();
    }

    /** The parser limits how deep values lie in each other. */
    private static JsonNode value(JsonParser parser) throws IOException {
        return switch (parser.currentToken()) {
            case START_OBJECT -> object(parser);
            case START_ARRAY -> array(parser);
            case VALUE_STRING -> NODES.textNode(parser.getText());
            case VALUE_NUMBER_INT, VALUE_NUMBER_FLOAT -> new JsonNumber(parser.getText());
            case VALUE_TRUE -> NODES.booleanNode(true);
            case VALUE_FALSE -> NODES.booleanNode(false);
            default -> NODES.nullNode();
        };
    }

    private static JsonNode object(JsonParser parser) throws IOException {
        ObjectNode object = NODES.objectNode();
        while (parser.nextToken() == JsonToken.FIELD_NAME) {
            String key = parser.currentName();
            parser.nextToken();
            object.set(key, value(parser));
        }
        return object;
    }

    private static JsonNode array(JsonParser parser) throws IOException {
        ArrayNode array = NODES.arrayNode();
        while (parser.nextToken() != JsonToken.END_ARRAY) array.add(value(parser));
        return array;
    }

    /** Neither missing nor null. */
    public static boolean isGiven(JsonNode node) {
        return !node.isMissingNode() && !node.isNull();
    }

    /** A whole number from 0 to 2³¹ − 1, or −1 for everything else. */
    public static int index(JsonNode node) {
        double value = node.isNumber() ? node.doubleValue() : -1;
        return value >= 0 && value <= Integer.MAX_VALUE && value == Math.rint(value) ? (int) value : -1;
    }

    /** {@link #index}, with another answer for a value that is not given. */
    public static int index(JsonNode node, int otherwise) {
        return isGiven(node) ? index(node) : otherwise;
    }
}
