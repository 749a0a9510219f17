package org.jsmesh.web.build;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Shaders in scripts, without what only people read. */
final class Glsl {
    /** As three.js marks them. */
    private static final Pattern LITERAL = Pattern.compile("/\\* glsl \\*/\\s*`([^`]*)`");

    private static final Pattern COMMENT = Pattern.compile("(?s)/\\*.*?\\*/|//[^\\n]*");
    private static final Pattern AROUND_SIGNS = Pattern.compile("\\s*([*/=<>!&|?:;,(){}\\[\\]])\\s*");

    /** Not between two signs: {@code a - -b}. */
    private static final Pattern AROUND_SUMS = Pattern.compile("(?<=[\\w)\\].])\\s*([+-])\\s*(?=[\\w(.])");

    private Glsl() {}

    static String shortened(String script) {
        return LITERAL.matcher(script).replaceAll(m -> Matcher.quoteReplacement('`' + text(m.group(1)) + '`'));
    }

    /** Lines of the preprocessor stay lines. */
    private static String text(String shader) {
        StringBuilder text = new StringBuilder();
        for (String line : COMMENT.matcher(shader).replaceAll("").split("\n")) {
            String plain = line.strip();
            if (plain.isEmpty()) continue;
            if (plain.startsWith("#")) {
                if (text.length() == 0 || text.charAt(text.length() - 1) != '\n') text.append('\n');
                text.append(plain.replaceAll("\\s+", " ")).append('\n');
            } else {
                String code = AROUND_SIGNS.matcher(plain).replaceAll("$1");
                code = AROUND_SUMS.matcher(code).replaceAll("$1").replaceAll("\\s+", " ");
                if (text.length() > 0 && needsSpace(text.charAt(text.length() - 1), code.charAt(0))) text.append(' ');
                text.append(code);
            }
        }
        return text.append('\n').toString();
    }

    /** Where words would become one, and signs another. */
    private static boolean needsSpace(char before, char after) {
        return isWord(before) && isWord(after) || "+-".indexOf(before) >= 0 && "+-".indexOf(after) >= 0;
    }

    private static boolean isWord(char c) {
        return Character.isLetterOrDigit(c) || c == '_' || c == '.';
    }
}
