package org.jsmesh.secret;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.regex.Pattern;
import javax.crypto.Mac;
import javax.crypto.spec.SecretKeySpec;

/**
 * Keys that sign addresses, one a line of a file: the first signs, and all are good to verify, so that a new key can be
 * put in front of an old one, which is removed when its last addresses have expired. When the file changes, the new
 * keys count within a second or so; a file that has become wrong changes nothing. A signature is the HMAC-SHA256 of the
 * model's id and of the time until which it is good; it opens every resource of that model. One for the empty id,
 * {@link #ALL}, opens the catalogue and every model. An application signs an address for ten minutes:
 *
 * <pre>{@code
 * SignKeys keys = SignKeys.read(Path.of("/etc/jsm/sign-keys"));
 * String query = keys.query("chair", Instant.now().plus(Duration.ofMinutes(10)));
 * String address = "https://meshes.example.org/m/chair/?" + query;
 * }</pre>
 *
 * Thread-safe.
 */
public final class SignKeys {
    /** Stands for the catalogue and every model. */
    public static final String ALL = "";

    private static final int SHORTEST = 32;
    private static final String ALGORITHM = "HmacSHA256";
    private static final String CONTEXT = "jsm-address-1\n";
    private static final String EXPIRES = "expires=";
    private static final String SIGNATURE = "signature=";
    private static final Pattern SECONDS = Pattern.compile("[1-9]\\d{0,11}");

    /** What becomes of a request. */
    public enum Verdict {
        /** The signature is good. */
        GOOD,
        /** There is none. */
        NONE,
        /** It was good and is so no longer. */
        EXPIRED,
        /** It is that of no key, of another model or of another time. */
        WRONG
    }

    private final SecretFile<List<byte[]>> keys;

    private SignKeys(SecretFile<List<byte[]>> keys) {
        this.keys = keys;
    }

    /**
     * Reads the keys, and reads them again when the file has changed.
     *
     * @param file UTF-8 text, with a key of at least 32 bytes a line; empty lines and lines that begin with a hash are
     *     skipped
     * @return its keys, at least one
     * @throws FileSystemException that says what is wrong with the file
     * @throws IOException when it cannot be read
     */
    public static SignKeys read(Path file) throws IOException {
        return new SignKeys(SecretFile.open(file, SignKeys::keys));
    }

    private static List<byte[]> keys(List<String> lines) {
        List<byte[]> keys = new ArrayList<>();
        for (String line : lines) {
            byte[] key = line.getBytes(StandardCharsets.UTF_8);
            if (key.length < SHORTEST)
                throw new IllegalArgumentException("a line is shorter than the " + SHORTEST
                        + " bytes of a key. Make keys with 'openssl rand -hex 32'");
            keys.add(key);
        }
        if (keys.isEmpty()) throw new IllegalArgumentException("holds no key. Make one with 'openssl rand -hex 32'");
        return List.copyOf(keys);
    }

    /**
     * Signs.
     *
     * @param id of the model, as it stands in its address, decoded; {@link #ALL} for the catalogue and every model
     * @param until when the signature is good, in whole seconds
     * @return {@code expires=…&signature=…}, to be added to the address as its query
     */
    public String query(String id, Instant until) {
        String expires = Long.toString(until.getEpochSecond());
        byte[] signature = signature(keys.get().get(0), id, expires);
        return EXPIRES
                + expires
                + '&'
                + SIGNATURE
                + Base64.getUrlEncoder().withoutPadding().encodeToString(signature);
    }

    /**
     * Verifies the query of a request, in constant time.
     *
     * @param id of the model that is asked for, or {@link #ALL}
     * @param query of the request, or null
     * @param now to compare the expiry with
     * @return what becomes of the request
     */
    public Verdict verify(String id, String query, Instant now) {
        String expires = parameter(query, EXPIRES);
        String signature = parameter(query, SIGNATURE);
        if (expires == null && signature == null) return Verdict.NONE;
        if (expires == null || signature == null || !SECONDS.matcher(expires).matches()) return Verdict.WRONG;
        byte[] given;
        try {
            given = Base64.getUrlDecoder().decode(signature);
        } catch (IllegalArgumentException e) {
            return Verdict.WRONG;
        }
        boolean good = false;
        for (byte[] key : keys.get()) {
            // All are compared, so that the time tells nothing.
            good |= MessageDigest.isEqual(signature(key, id, expires), given);
            good |= MessageDigest.isEqual(signature(key, ALL, expires), given);
        }
        if (!good) return Verdict.WRONG;
        return now.getEpochSecond() < Long.parseLong(expires) ? Verdict.GOOD : Verdict.EXPIRED;
    }

    /**
     * {@return the part of a query that signs, as it was given; null when it has none}
     *
     * @param query of a request, or null
     */
    public static String of(String query) {
        String expires = parameter(query, EXPIRES);
        String signature = parameter(query, SIGNATURE);
        return expires == null || signature == null ? null : EXPIRES + expires + '&' + SIGNATURE + signature;
    }

    private static String parameter(String query, String name) {
        if (query == null) return null;
        String found = null;
        for (String pair : query.split("&")) {
            if (!pair.startsWith(name)) continue;
            if (found != null) return ""; // nobody knows which one counts
            found = pair.substring(name.length());
        }
        return found;
    }

    private static byte[] signature(byte[] key, String id, String expires) {
        try {
            Mac mac = Mac.getInstance(ALGORITHM);
            mac.init(new SecretKeySpec(key, ALGORITHM));
            return mac.doFinal((CONTEXT + id + '\n' + expires).getBytes(StandardCharsets.UTF_8));
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException(e);
        }
    }
}
