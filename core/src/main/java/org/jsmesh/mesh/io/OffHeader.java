package org.jsmesh.mesh.io;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The start of an OFF file: the keyword, which says what vertices have, and the counts. The letters of the keyword come
 * in any order, the first count may be glued to it, and the counts may be on several lines.
 */
record OffHeader(boolean normals, boolean coloured, boolean texcoords, int vertices, int faces) {
    private static final Pattern KEYWORD = Pattern.compile("((?:ST|C|N|4)*)OFF[0-9]*", Pattern.CASE_INSENSITIVE);

    /** Whether a word is the first of an OFF file. */
    static boolean isKeyword(String word) {
        return KEYWORD.matcher(word).matches();
    }

    static OffHeader read(TextScanner scanner) throws ModelFormatException {
        if (!scanner.next()) throw scanner.error("the file is empty", "Give an OFF file");
        String word = scanner.token();
        Matcher keyword = KEYWORD.matcher(word);
        String flags = "";
        if (keyword.matches()) {
            flags = keyword.group(1);
            refuseOtherDimensions(scanner, flags, word);
            if (Character.isDigit(word.charAt(word.length() - 1)))
                scanner.backTo(scanner.tokenStart() + flags.length() + "OFF".length());
            if (!scanner.next()) throw missing(scanner, "vertices");
            if (scanner.token().equalsIgnoreCase("BINARY"))
                throw scanner.error("binary OFF is not read", "Save it as OFF text or as PLY");
        }
        int vertices = count(scanner, "vertices");
        if (!scanner.next()) throw missing(scanner, "faces");
        int faces = count(scanner, "faces");
        skipEdges(scanner);
        flags = flags.toUpperCase(Locale.ROOT);
        return new OffHeader(flags.contains("N"), flags.contains("C"), flags.contains("ST"), vertices, faces);
    }

    private static void refuseOtherDimensions(TextScanner scanner, String flags, String word)
            throws ModelFormatException {
        // Geomview's n is small; who writes all of the word small means a normal
        boolean many = flags.endsWith("n") && word.contains("OFF")
                || flags.toUpperCase(Locale.ROOT).contains("NN");
        if (!many && !flags.contains("4")) return;
        String reason = many
                ? scanner.quote() + " holds vertices of any number of dimensions, and jSM reads those of three"
                : scanner.quote() + " holds vertices of four coordinates, and jSM reads those of three";
        throw scanner.error(reason, "Project the model into three dimensions and save it as OFF or PLY");
    }

    private static int count(TextScanner scanner, String what) throws ModelFormatException {
        int count = scanner.tokenAsInt("the number of " + what);
        if (count < 0) throw scanner.error("the number of " + what + " is " + count, "Correct the counts");
        return count;
    }

    /** The number of edges may be missing. A number alone on the next line is it, for a vertex has three. */
    private static void skipEdges(TextScanner scanner) throws ModelFormatException {
        if (!scanner.atLineEnd()) {
            scanner.restOfLine();
            return;
        }
        int position = scanner.position();
        int line = scanner.line();
        boolean alone = scanner.next() && scanner.tokensLeftOnLine() == 0 && scanner.tokenIsNumber();
        if (alone) return;
        scanner.backTo(position);
        scanner.countLinesFrom(line);
    }

    private static ModelFormatException missing(TextScanner scanner, String what) {
        return scanner.error("the number of " + what + " is missing", "The file is cut off; get it again");
    }
}
