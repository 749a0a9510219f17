package org.jsmesh.archive;

/** Text of files, fit to be shown. */
public final class PlainText {
    private static final char REPLACEMENT = '\ufffd';

    private PlainText() {}

    /**
     * Replaces what could do harm where a text is shown: control characters, line ends, marks that turn the direction
     * of writing, and halves of surrogate pairs.
     *
     * @param text any text
     * @return a text of the same length, with U+FFFD in their places
     */
    public static String of(String text) {
        StringBuilder plain = new StringBuilder(text.length());
        for (int i = 0; i < text.length(); i++) plain.append(isHarmless(text, i) ? text.charAt(i) : REPLACEMENT);
        return plain.toString();
    }

    private static boolean isHarmless(String text, int i) {
        char c = text.charAt(i);
        if (Character.isHighSurrogate(c)) return i + 1 < text.length() && Character.isLowSurrogate(text.charAt(i + 1));
        if (Character.isLowSurrogate(c)) return i > 0 && Character.isHighSurrogate(text.charAt(i - 1));
        boolean control = c < 0x20 || c >= 0x7f && c < 0xa0;
        boolean direction =
                c == 0x200e || c == 0x200f || c == 0x61c || c >= 0x202a && c <= 0x202e || c >= 0x2066 && c <= 0x2069;
        return !control && !direction && c != 0x2028 && c != 0x2029 && c != 0xfeff;
    }

    /**
     * Shortens a text.
     *
     * @param text any text
     * @param most characters that stay, at least 1
     * @return the text, or its beginning with an ellipsis as the last character
     */
    public static String cut(String text, int most) {
        if (text.length() <= most) return text;
        int end = most - 1;
        if (end > 0 && Character.isHighSurrogate(text.charAt(end - 1))) end--;
        return text.substring(0, end) + '\u2026';
    }

    /**
     * Makes a text harmless and short.
     *
     * @param text any text
     * @param most characters that stay, at least 1
     * @return what {@link #cut} leaves of what {@link #of} gives
     */
    public static String fit(String text, int most) {
        return cut(of(text), most);
    }
}
