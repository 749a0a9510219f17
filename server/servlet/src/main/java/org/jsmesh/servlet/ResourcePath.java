package org.jsmesh.servlet;

import org.jsmesh.files.AnnotationFile;
import org.jsmesh.files.ArchiveParts;

/**
 * The resource that a path below the servlet's path names. It is parsed without regular expressions, because every
 * request for bytes comes here. Only the resources of the protocol, spelled exactly, count. The rest of a path is an id
 * to look up, never a path.
 *
 * @param id of a model, as it stands in the list of models: letters, digits and hyphens
 * @param sha256 of its archive, or null when the model itself is meant
 * @param first first batch, when {@code kind} is {@link Kind#BATCHES}
 * @param last last batch, likewise
 */
record ResourcePath(Kind kind, String id, String sha256, int first, int last) {
    private static final int SHA_LENGTH = 64;
    private static final int MOST_DIGITS = 9;
    /** No character from here on means anything in a path. Ids spell those of Latin-1 in ASCII. */
    private static final char FIRST_LETTER = 0x100;

    private static final String LAUNCH = "viewer.jnlp";
    private static final String BATCHES = "/batches/";

    enum Kind {
        MODEL,
        PAGE,
        MANIFEST,
        ANNOTATIONS,
        STATUS,
        LAUNCH,
        ARCHIVE,
        BATCHES,
        PATCHES,
        POSTER,
        FIRST
    }

    /** Whether every model has it, or may have it. */
    boolean isOfModel() {
        return switch (kind) {
            case MODEL, PAGE, STATUS -> false;
            default -> true;
        };
    }

    /**
     * @param path that begins with a slash
     * @return null when there cannot be such a resource
     */
    static ResourcePath parse(String path) {
        int slash = path.indexOf('/', 1);
        String id = path.substring(1, slash < 0 ? path.length() : slash);
        if (!isId(id)) return null;
        if (slash < 0) return new ResourcePath(Kind.MODEL, id, null, 0, 0);
        if (path.length() == slash + 1) return new ResourcePath(Kind.PAGE, id, null, 0, 0);
        if (path.startsWith("manifest.json", slash + 1) && path.length() == slash + 14)
            return new ResourcePath(Kind.MANIFEST, id, null, 0, 0);
        if (path.startsWith(AnnotationFile.NAME, slash + 1)
                && path.length() == slash + 1 + AnnotationFile.NAME.length())
            return new ResourcePath(Kind.ANNOTATIONS, id, null, 0, 0);
        if (path.startsWith("status", slash + 1) && path.length() == slash + 7)
            return new ResourcePath(Kind.STATUS, id, null, 0, 0);
        if (path.startsWith(LAUNCH, slash + 1) && path.length() == slash + 1 + LAUNCH.length())
            return new ResourcePath(Kind.LAUNCH, id, null, 0, 0);
        int rest = slash + 1 + SHA_LENGTH;
        if (path.length() <= rest || !isHash(path, slash + 1, rest)) return null;
        String sha256 = path.substring(slash + 1, rest);
        String resource = path.substring(rest);
        if (resource.equals(".jsm")) return new ResourcePath(Kind.ARCHIVE, id, sha256, 0, 0);
        if (resource.equals("/" + ArchiveParts.POSTER)) return new ResourcePath(Kind.POSTER, id, sha256, 0, 0);
        if (resource.equals("/" + ArchiveParts.FIRST)) return new ResourcePath(Kind.FIRST, id, sha256, 0, 0);
        if (resource.equals("/patches")) return new ResourcePath(Kind.PATCHES, id, sha256, 0, 0);
        return resource.startsWith(BATCHES) ? batches(id, sha256, resource.substring(BATCHES.length())) : null;
    }

    private static ResourcePath batches(String id, String sha256, String range) {
        int hyphen = range.indexOf('-');
        if (hyphen < 0) return null;
        int first = number(range.substring(0, hyphen));
        int last = number(range.substring(hyphen + 1));
        return first < 0 || last < 0 ? null : new ResourcePath(Kind.BATCHES, id, sha256, first, last);
    }

    private static boolean isId(String text) {
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            boolean isLatin = c >= 'a' && c <= 'z' || c >= '0' && c <= '9' || c == '-';
            // What other letters there are is for the list of models to say.
            if (!isLatin && c < FIRST_LETTER) return false;
        }
        return !text.isEmpty();
    }

    private static boolean isHash(String text, int from, int to) {
        for (int i = from; i < to; i++) {
            char c = text.charAt(i);
            if (!(c >= '0' && c <= '9' || c >= 'a' && c <= 'f')) return false;
        }
        return true;
    }

    /** Reads decimal digits without leading zeros, so that a resource has one name; -1 otherwise. */
    private static int number(String digits) {
        if (digits.isEmpty() || digits.length() > MOST_DIGITS) return -1;
        if (digits.charAt(0) == '0' && digits.length() > 1) return -1;
        int value = 0;
        for (int i = 0; i < digits.length(); i++) {
            char c = digits.charAt(i);
            if (c < '0' || c > '9') return -1;
            value = 10 * value + c - '0';
        }
        return value;
    }
}
