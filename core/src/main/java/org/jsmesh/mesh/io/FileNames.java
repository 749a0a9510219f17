package org.jsmesh.mesh.io;

/** Checks paths that come from model files and archives, before a file is written under them. */
final class FileNames {
    private static final int LONGEST = 200;

    private FileNames() {}

    /**
     * A relative path with {@code /}, without {@code ..} and hidden files, that every system can write and every reader
     * of MTL can read.
     */
    static boolean isSafe(String path) {
        if (path.isEmpty() || path.length() > LONGEST || !path.equals(path.trim()) || path.startsWith("-"))
            return false;
        for (int i = 0; i < path.length(); i++) {
            char c = path.charAt(i);
            if (c < ' ' || c == 0x7F || "\\:*?\"<>|#".indexOf(c) >= 0) return false;
        }
        for (String part : path.split("/", -1)) {
            if (part.isEmpty()
                    || part.endsWith(".")
                    || part.endsWith(" ")
                    || part.startsWith(" ")
                    || part.startsWith(".")) return false;
        }
        return true;
    }

    /** The last part of a path with either slash, made safe. */
    static String last(String path) {
        String name = path.substring(Math.max(path.lastIndexOf('/'), path.lastIndexOf('\\')) + 1);
        StringBuilder safe = new StringBuilder();
        for (int i = 0; i < name.length() && safe.length() < LONGEST / 2; i++) {
            char c = name.charAt(i);
            safe.append(c < ' ' || c == 0x7F || "\\/:*?\"<>|#".indexOf(c) >= 0 ? '_' : c);
        }
        String result = safe.toString().trim();
        while (result.startsWith("-") || result.startsWith(".")) result = result.substring(1);
        while (result.endsWith(".") || result.endsWith(" ")) result = result.substring(0, result.length() - 1);
        return isSafe(result) ? result : "texture";
    }

    /** Without quotation marks around it. */
    static String unquoted(String name) {
        int end = name.length() - 1;
        boolean quoted = end > 0
                && (name.charAt(0) == '"' || name.charAt(0) == '\'')
                && name.charAt(end) == name.charAt(0)
                && name.indexOf(name.charAt(0), 1) == end;
        return quoted ? name.substring(1, end).trim() : name;
    }

    /** Without its extension. */
    static String stem(String fileName) {
        int dot = fileName.lastIndexOf('.');
        return dot > 0 ? fileName.substring(0, dot) : fileName;
    }

    /** A name with a number before its extension. */
    static String numbered(String name, int number) {
        int dot = name.lastIndexOf('.');
        if (dot <= name.lastIndexOf('/')) dot = name.length();
        return name.substring(0, dot) + '-' + number + name.substring(dot);
    }
}
