package org.jsmesh.store.ids;

import java.nio.charset.StandardCharsets;
import java.text.Normalizer;
import java.util.Locale;
import java.util.Map;

/**
 * A text as ids write it. Letters lose case, and Latin letters lose accents. Letters and digits of other scripts stay
 * as they are, in Unicode's normalization form C. Runs of everything else become one hyphen.
 *
 * @param text without a hyphen at its ends, maybe empty
 * @param isLatin whether it consists of ASCII letters, digits and hyphens
 */
public record IdText(String text, boolean isLatin) {
    /** Latin letters that Unicode does not decompose. */
    private static final Map<Integer, String> LATIN = Map.ofEntries(
            Map.entry((int) 'ß', "ss"),
            Map.entry((int) 'æ', "ae"),
            Map.entry((int) 'œ', "oe"),
            Map.entry((int) 'ø', "o"),
            Map.entry((int) 'ł', "l"),
            Map.entry((int) 'đ', "d"),
            Map.entry((int) 'ð', "d"),
            Map.entry((int) 'þ', "th"),
            Map.entry((int) 'ħ', "h"),
            Map.entry((int) 'ı', "i"));

    public static IdText of(String name) {
        String plain = Normalizer.normalize(name, Normalizer.Form.NFKD).toLowerCase(Locale.ROOT);
        StringBuilder text = new StringBuilder();
        boolean latinBase = true;
        boolean latin = true;
        boolean gap = false;
        for (int c : plain.codePoints().toArray()) {
            boolean mark = isMark(c);
            if (mark && latinBase) continue;
            String letters = isAscii(c) ? Character.toString(c) : LATIN.get(c);
            latinBase = letters != null;
            if (letters == null && (mark || Character.isLetterOrDigit(c))) {
                letters = Character.toString(c);
                latin = false;
            }
            if (letters == null) {
                gap = true;
                latinBase = true; // marks behind a separator belong to nothing
                continue;
            }
            if (gap && text.length() > 0) text.append('-');
            gap = false;
            text.append(letters);
        }
        return new IdText(Normalizer.normalize(text, Normalizer.Form.NFC), latin);
    }

    /** Whether ids may hold the character. */
    static boolean isPart(int c) {
        return isAscii(c) || c == '-' || c >= 0x80 && (Character.isLetterOrDigit(c) || isMark(c));
    }

    /** The beginning of it that takes at most so many bytes of UTF-8. */
    String cut(int mostBytes) {
        int end = 0;
        int bytes = 0;
        while (end < text.length()) {
            int c = text.codePointAt(end);
            bytes += Character.toString(c).getBytes(StandardCharsets.UTF_8).length;
            if (bytes > mostBytes) break;
            end += Character.charCount(c);
        }
        return text.substring(0, end);
    }

    private static boolean isAscii(int c) {
        return c >= 'a' && c <= 'z' || c >= '0' && c <= '9';
    }

    private static boolean isMark(int c) {
        int type = Character.getType(c);
        return type == Character.NON_SPACING_MARK
                || type == Character.COMBINING_SPACING_MARK
                || type == Character.ENCLOSING_MARK;
    }
}
