package org.jsmesh.upload;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.List;

/**
 * The tokens of those who may send models, one a line. If a token is not good for every model, the beginning of the ids
 * that it is good for follows it. Empty lines and lines that begin with a hash are skipped. Only hashes of the tokens
 * are kept, and compared in constant time.
 */
public final class UploadTokens {
    private static final int SHORTEST = 16;

    private record Grant(byte[] hash, String prefix) {}

    /** The models that a token is good for. */
    public enum Verdict {
        /** No token of the server. */
        UNKNOWN,
        /** Good for other models. */
        ELSEWHERE,
        /** Good for the model. */
        GOOD
    }

    private final List<Grant> grants = new ArrayList<>();

    /**
     * Reads the tokens once; later changes of the file have no effect.
     *
     * @param file UTF-8 text, with a token of at least 16 characters a line
     * @return its tokens, at least one
     * @throws FileSystemException that says what is wrong with the file
     * @throws IOException when it cannot be read
     */
    public static UploadTokens read(Path file) throws IOException {
        UploadTokens tokens = new UploadTokens();
        for (String line : Files.readAllLines(file)) {
            if (line.isBlank() || line.startsWith("#")) continue;
            String[] words = line.strip().split("\\s+");
            if (words[0].length() < SHORTEST || words.length > 2) {
                String why = "a line is no token of at least " + SHORTEST
                        + " characters, with at most what ids begin with behind it. Make tokens with 'openssl rand -hex 32'";
                throw new FileSystemException(file.toString(), null, why);
            }
            tokens.grants.add(new Grant(hash(words[0]), words.length > 1 ? words[1] : ""));
        }
        if (tokens.grants.isEmpty()) throw new FileSystemException(file.toString(), null, "holds no token");
        return tokens;
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
        for (Grant grant : grants) {
            // All tokens are compared, so that the time tells nothing.
            if (!MessageDigest.isEqual(hash, grant.hash())) continue;
            Verdict verdict = id.startsWith(grant.prefix()) ? Verdict.GOOD : Verdict.ELSEWHERE;
            if (verdict.compareTo(best) > 0) best = verdict;
        }
        return best;
    }

    private static byte[] hash(String token) {
        try {
            return MessageDigest.getInstance("SHA-256").digest(token.getBytes(StandardCharsets.UTF_8));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }
}
