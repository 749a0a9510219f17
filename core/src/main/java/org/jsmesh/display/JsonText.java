package org.jsmesh.display;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Reads JSON (RFC 8259): objects as maps, arrays as lists, numbers as Double, texts, Boolean, and null. It serves
 * definitions of materials in the core, which has no library.
 */
final class JsonText {
    private static final int DEEPEST = 64;

    private final String text;
    private int at;
    private int depth;

    private JsonText(String text) {
        this.text = text;
    }

    /** The object that a text is; an empty one when it is anything else. */
    @SuppressWarnings("unchecked")
    static Map<String, Object> object(String text) {
        try {
            JsonText json = new JsonText(text);
            Object value = json.value();
            json.blanks();
            if (json.at < text.length()) throw json.error();
            return value instanceof Map ? (Map<String, Object>) value : Map.of();
        } catch (IllegalArgumentException e) {
            return Map.of();
        }
    }

    private IllegalArgumentException error() {
        return new IllegalArgumentException("no JSON at character " + at);
    }

    private Object value() {
        blanks();
        char c = peek();
        if (c == '{') return object();
        if (c == '[') return array();
        if (c == '"') return string();
        if (take("true")) return true;
        if (take("false")) return false;
        if (take("null")) return null;
        return number();
    }

    private Map<String, Object> object() {
        Map<String, Object> members = new LinkedHashMap<>();
        open();
        while (!closed('}', members.isEmpty())) {
            blanks();
            String key = string();
            blanks();
            if (!take(":")) throw error();
            members.put(key, value());
        }
        return members;
    }

    private List<Object> array() {
        List<Object> elements = new ArrayList<>();
        open();
        while (!closed(']', elements.isEmpty())) elements.add(value());
        return elements;
    }

    private void open() {
        at++;
        if (++depth > DEEPEST) throw error();
    }

    /** Whether the bracket follows; else goes behind the comma. */
    private boolean closed(char bracket, boolean first) {
        blanks();
        if (peek() == bracket) {
            at++;
            depth--;
            return true;
        }
        if (!first && !take(",")) throw error();
        return false;
    }

    private String string() {
        if (!take("\"")) throw error();
        StringBuilder out = new StringBuilder();
        while (true) {
            char c = next();
            if (c == '"') return out.toString();
            if (c < ' ') throw error();
            out.append(c == '\\' ? escaped() : c);
        }
    }

    private char escaped() {
        char c = next();
        return switch (c) {
            case 'n' -> '\n';
            case 't' -> '\t';
            case 'r' -> '\r';
            case 'b' -> '\b';
            case 'f' -> '\f';
            case '"', '\\', '/' -> c;
            case 'u' -> {
                int code = 0;
                for (int i = 0; i < 4; i++) {
                    int digit = Character.digit(next(), 16);
                    if (digit < 0) throw error();
                    code = 16 * code + digit;
                }
                yield (char) code;
            }
            default -> throw error();
        };
    }

    private Double number() {
        int from = at;
        while (at < text.length() && "+-.eE0123456789".indexOf(text.charAt(at)) >= 0) at++;
        return Double.valueOf(text.substring(from, at)); // NumberFormatException is an IllegalArgumentException
    }

    private boolean take(String word) {
        if (!text.startsWith(word, at)) return false;
        at += word.length();
        return true;
    }

    private void blanks() {
        while (at < text.length() && " \t\r\n".indexOf(text.charAt(at)) >= 0) at++;
    }

    private char peek() {
        if (at >= text.length()) throw error();
        return text.charAt(at);
    }

    private char next() {
        char c = peek();
        at++;
        return c;
    }
}
