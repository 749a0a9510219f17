package org.jsmesh.store.ids;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.text.Normalizer;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jsmesh.mesh.io.ModelFormat;

/**
 * The path of a model file in its folder, and the ids that it can have. They depend on nothing else.
 *
 * @param text with slashes between folders
 * @param folders slugs of the folders that count in ids
 * @param stem slug of the file's name without extension
 * @param extension in lower case, maybe empty
 */
public record ModelPath(String text, List<IdText> folders, IdText stem, String extension) {
    /** The folder of models that clients send. Its archives are named by ids. */
    public static final String UPLOADS = "uploads";

    /** Between folders. Names never give two hyphens in a row. */
    private static final String JOIN = "--";

    /** Best first: of the files with one name, the first of these has the short id. */
    private static final List<String> FORMATS = List.of("jsm", "glb", "gltf", "obj", "ply", "3mf", "off", "m", "stl");

    private static final int LONGEST_BYTES = 240;
    private static final int HASH_LETTERS = 6;
    private static final String LETTERS = "abcdefghijkmnpqrstuvwxyz23456789";

    /** Who of several files has the short id: depends on their names alone. */
    public static final Comparator<ModelPath> BEST_FIRST = Comparator.comparing((ModelPath p) -> !p.isExact())
            .thenComparing(p -> p.text.startsWith(UPLOADS + "/"))
            .thenComparing(p -> FORMATS.contains(p.extension) ? FORMATS.indexOf(p.extension) : FORMATS.size())
            .thenComparing(ModelPath::text);

    public static ModelPath of(String path) {
        String[] parts = path.split("/");
        String file = ModelFormat.withoutGzip(parts[parts.length - 1]);
        int dot = file.lastIndexOf('.');
        String extension = dot < 0 ? "" : file.substring(dot + 1).toLowerCase(Locale.ROOT);
        boolean sent = parts.length == 2 && parts[0].equals(UPLOADS) && extension.equals("jsm");
        List<IdText> folders = Arrays.stream(parts, 0, sent ? 0 : parts.length - 1)
                .map(IdText::of)
                .toList();
        return new ModelPath(path, folders, IdText.of(stem(file)), extension);
    }

    /** The name of a file without its extension, and without that of gzip. */
    public static String stem(String fileName) {
        String name = ModelFormat.withoutGzip(fileName);
        int dot = name.lastIndexOf('.');
        return dot <= 0 ? name : name.substring(0, dot);
    }

    /**
     * Ids that lead to the file as long as no other model has them: its long one first, and those of earlier versions.
     */
    public Set<String> otherIds() {
        return new LinkedHashSet<>(
                List.of(longId(0), stem.text(), IdText.of(text).text()));
    }

    /** The id without a hash, such as {@code chair} or {@code kitchen--chair}; null when only the long id will do. */
    public String shortId() {
        boolean latin = parts().allMatch(part -> part.isLatin() && !part.text().isEmpty());
        String joined = joined();
        return latin && joined.length() <= LONGEST_BYTES ? joined : null;
    }

    /**
     * The id with a hash of the path, such as {@code chair-stl-k3x9q2}.
     *
     * @param more letters of the hash than usual, where another file has that id
     */
    public String longId(int more) {
        // One id, whichever form of accents a file system keeps, unless two files differ in nothing else.
        String path = more == 0 ? Normalizer.normalize(text, Normalizer.Form.NFC) : text;
        String ending = "-" + hash(path).substring(0, HASH_LETTERS + more);
        String kind = IdText.of(extension).text();
        if (!kind.isEmpty()) ending = "-" + kind + ending;
        String joined = joined();
        return new IdText(joined.isEmpty() ? "model" : joined, false).cut(LONGEST_BYTES - bytes(ending)) + ending;
    }

    private Stream<IdText> parts() {
        return Stream.concat(folders.stream(), Stream.of(stem));
    }

    private String joined() {
        return parts().map(IdText::text).filter(text -> !text.isEmpty()).collect(Collectors.joining(JOIN));
    }

    /** Whether the file is named as its id. */
    private boolean isExact() {
        String name = folders.isEmpty() ? text.substring(text.lastIndexOf('/') + 1) : text.replace("/", JOIN);
        return name.equals(extension.isEmpty() ? joined() : joined() + "." + extension);
    }

    private static int bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8).length;
    }

    private static String hash(String path) {
        StringBuilder letters = new StringBuilder();
        try {
            byte[] digest = MessageDigest.getInstance("SHA-256").digest(path.getBytes(StandardCharsets.UTF_8));
            for (byte b : digest) letters.append(LETTERS.charAt(b & 31));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
        return letters.toString();
    }
}
