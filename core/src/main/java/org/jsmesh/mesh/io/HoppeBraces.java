package org.jsmesh.mesh.io;

import java.nio.charset.StandardCharsets;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * The attributes in the braces at the end of a line of Hoppe's {@code .m}: {@code {normal=(0 0 1) mat="red" matid=3
 * sharp}}.
 */
final class HoppeBraces {
    private final Map<String, String> values = new LinkedHashMap<>();

    private HoppeBraces() {}

    /** From the current token to the end of the line, when that starts with a brace; else empty. */
    static HoppeBraces atToken(TextScanner scanner) throws ModelFormatException {
        HoppeBraces braces = new HoppeBraces();
        if (scanner.tokenStart() >= scanner.position() || scanner.byteAt(scanner.tokenStart()) != '{') return braces;
        scanner.backTo(scanner.tokenStart());
        String text = scanner.restOfLine();
        int at = 1;
        while (true) {
            while (at < text.length() && text.charAt(at) <= ' ') at++;
            if (at >= text.length()) throw scanner.error("a brace is not closed", "Add } at the end of the line");
            if (text.charAt(at) == '}') return braces;
            int keyEnd = at;
            while (keyEnd < text.length() && "= }".indexOf(text.charAt(keyEnd)) < 0) keyEnd++;
            String key = text.substring(at, keyEnd);
            if (keyEnd == at) throw scanner.error("an attribute without a name", "Correct this line");
            at = keyEnd;
            String value = "";
            if (at < text.length() && text.charAt(at) == '=') {
                int end = valueEnd(text, at + 1);
                if (end < 0)
                    throw scanner.error("the value of " + Notes.shown(key) + " is not closed", "Correct this line");
                value = text.substring(at + 1, end);
                at = end;
            }
            braces.values.putIfAbsent(key, value);
        }
    }

    private static int valueEnd(String text, int start) {
        if (start < text.length() && text.charAt(start) == '(')
            return text.indexOf(')', start) + 1 > 0 ? text.indexOf(')', start) + 1 : -1;
        if (start < text.length() && text.charAt(start) == '"')
            return text.indexOf('"', start + 1) + 1 > 0 ? text.indexOf('"', start + 1) + 1 : -1;
        int end = start;
        while (end < text.length() && " }".indexOf(text.charAt(end)) < 0) end++;
        return end;
    }

    /** Takes the value of an attribute, without quotation marks, off the keys; null when there is none. */
    String take(String key) {
        String value = values.remove(key);
        boolean quoted = value != null && value.length() >= 2 && value.startsWith("\"");
        return quoted ? value.substring(1, value.length() - 1) : value;
    }

    /** Names of the attributes not taken. */
    Collection<String> keys() {
        return values.keySet();
    }

    /** The numbers of {@code (1 0 0)}; null when one of them is not finite. */
    static float[] numbers(TextScanner scanner, String key, String text, int count) throws ModelFormatException {
        float[] numbers = new float[count];
        int found = 0;
        boolean finite = true;
        Decimal decimal = new Decimal();
        boolean valid = text.startsWith("(") && text.endsWith(")");
        for (String part : valid ? text.substring(1, text.length() - 1).trim().split("[ \t,]+") : new String[0]) {
            byte[] bytes = part.getBytes(StandardCharsets.ISO_8859_1);
            boolean number = decimal.scan(bytes, 0, bytes.length);
            if (found == count || !number && !TextScanner.namesNonFinite(part)) {
                valid = false;
                break;
            }
            numbers[found] = number ? decimal.toFloat() : Float.NaN;
            finite &= Float.isFinite(numbers[found++]);
        }
        if (!valid || found != count) {
            throw scanner.error(
                    key + " is " + TokenScanner.quote(text) + ", not " + count + " numbers in parentheses",
                    "Correct this line");
        }
        return finite ? numbers : null;
    }
}
