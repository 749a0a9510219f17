package org.jsmesh.upload;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jsmesh.secret.SecretFile;

/**
 * The tokens of those who may send models, one a line. If a token is not good for every model, the beginning of the ids
 * that it is good for follows it. {@code quota=5G} says how many bytes of archives the server keeps for the token (with
 * {@code K}, {@code M}, {@code G} or {@code T} of 1024), {@code models=100} how many models. Empty lines and lines that
 * begin with a hash are skipped. Only hashes of the tokens are kept, and compared in constant time. When the file
 * changes, the new tokens count within a second or so; a file that has become wrong changes nothing. Thread-safe.
 */
public final class UploadTokens {
    private static final int SHORTEST = 16;
    private static final Pattern QUOTA = Pattern.compile("quota=(\\d{1,10})([KMGT]?)");
    private static final Pattern MODELS = Pattern.compile("models=(\\d{1,9})");
    private static final String UNITS = "KMGT";

    private record Grant(byte[] hash, String prefix, Sender sender) {}

    /** The models that a token is good for. */
    public enum Verdict {
        /** No token of the server. */
        UNKNOWN,
        /** Good for other models. */
        ELSEWHERE,
        /** Good for the model. */
        GOOD
    }

    private final SecretFile<List<Grant>> grants;

    private UploadTokens(SecretFile<List<Grant>> grants) {
        this.grants = grants;
    }

    /**
     * Reads the tokens, and reads them again when the file has changed.
     *
     * @param file UTF-8 text, with a token of at least 16 characters a line
     * @return its tokens, at least one
     * @throws FileSystemException that says what is wrong with the file
     * @throws IOException when it cannot be read
     */
    public static UploadTokens read(Path file) throws IOException {
        return new UploadTokens(SecretFile.open(file, UploadTokens::grants));
    }

    private static List<Grant> grants(List<String> lines) {
        List<Grant> grants = new ArrayList<>();
        for (String line : lines) grants.add(grant(line.split("\\s+")));
        if (grants.isEmpty()) throw new IllegalArgumentException("holds no token");
        return List.copyOf(grants);
    }

    private static Grant grant(String[] words) {
        String prefix = null;
        long bytes = Long.MAX_VALUE;
        int models = Integer.MAX_VALUE;
        boolean good = words[0].length() >= SHORTEST;
        for (int i = 1; i < words.length; i++) {
            Matcher quota = QUOTA.matcher(words[i]);
            Matcher count = MODELS.matcher(words[i]);
            if (quota.matches()) {
                int unit = quota.group(2).isEmpty() ? 0 : 10 * (1 + UNITS.indexOf(quota.group(2)));
                long number = Long.parseLong(quota.group(1));
                bytes = number > Long.MAX_VALUE >> unit ? Long.MAX_VALUE : number << unit;
            } else if (count.matches()) {
                models = Integer.parseInt(count.group(1));
            } else {
                good &= prefix == null && words[i].indexOf('=') < 0;
                prefix = words[i];
            }
        }
        if (!good)
            throw new IllegalArgumentException("a line is no token of at least " + SHORTEST
                    + " characters, with at most what ids begin with, quota=5G and models=100 behind it."
                    + " Make tokens with 'openssl rand -hex 32'");
        byte[] hash = hash(words[0]);
        Sender sender = new Sender(HexFormat.of().formatHex(hash), bytes, models);
        return new Grant(hash, prefix == null ? "" : prefix, sender);
    }

    /**
     * Tells whether the owner of a token may send a model.
     *
     * @param token as the sender gives it
     * @param id of the model
     * @return the best that a line of the file grants
     */
    public Verdict check(String token, String id) {
        byte[] hash = hash(token);
        Verdict best = Verdict.UNKNOWN;
        for (Grant grant : grants.get()) {
            // All tokens are compared, so that the time tells nothing.
            if (!MessageDigest.isEqual(hash, grant.hash())) continue;
            Verdict verdict = id.startsWith(grant.prefix()) ? Verdict.GOOD : Verdict.ELSEWHERE;
            if (verdict.compareTo(best) > 0) best = verdict;
        }
        return best;
    }

    /**
     * Tells who the owner of a token is.
     *
     * @param token as the sender gives it
     * @param id of the model
     * @return by the first line of the file that is good for the model; null when there is none
     */
    public Sender sender(String token, String id) {
        byte[] hash = hash(token);
        Sender first = null;
        for (Grant grant : grants.get()) {
            boolean good = MessageDigest.isEqual(hash, grant.hash()) && id.startsWith(grant.prefix());
            if (good && first == null) first = grant.sender();
        }
        return first;
    }

    private static byte[] hash(String token) {
        try {
            return MessageDigest.getInstance("SHA-256").digest(token.getBytes(StandardCharsets.UTF_8));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }
}
