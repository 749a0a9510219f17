package org.jsmesh.servlet.http;

import jakarta.servlet.http.HttpServletRequest;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.Base64;
import java.util.Collections;
import java.util.Enumeration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The digests that a sender gives with a body: {@code Repr-Digest} and {@code Content-Digest} (RFC 9530), dictionaries
 * of structured fields (RFC 8941, section 3.2) with byte sequences. Those of {@code sha-256} and {@code sha-512} are
 * checked, all others are passed over. Both fields mean the same bytes here, because a body is whole and is stored as
 * it comes.
 */
public final class BodyDigests {
    private static final List<String> FIELDS = List.of("Repr-Digest", "Content-Digest");
    private static final Map<String, String> ALGORITHMS = Map.of("sha-256", "SHA-256", "sha-512", "SHA-512");
    private static final String KEY = "[a-z*][a-z0-9_.*-]*+";
    private static final String BARE = "\"(?:[ !#-\\[\\]-~]|\\\\[\"\\\\])*+\"|:[A-Za-z0-9+/=]*+:|\\?[01]"
            + "|[A-Za-z*][A-Za-z0-9!#$%&'*+.^_`|~:/-]*+|-?\\d{1,15}(?:\\.\\d{1,3})?+";

    /** One member of the dictionary; parameters say nothing here. */
    private static final Pattern MEMBER =
            Pattern.compile("(" + KEY + ")=:([A-Za-z0-9+/=]*+):(?:; *+" + KEY + "(?:=(?:" + BARE + "))?+)*+");

    private static final Pattern COMMA = Pattern.compile("[ \\t]*+,[ \\t]*+");

    private record Expected(MessageDigest digest, byte[] value) {}

    private final List<Expected> expected = new ArrayList<>();

    private BodyDigests() {}

    /**
     * Reads what a request says of its body.
     *
     * @throws IllegalArgumentException when one of the fields is malformed, with a reason in words
     */
    public static BodyDigests of(HttpServletRequest request) {
        BodyDigests digests = new BodyDigests();
        for (String name : FIELDS) {
            Enumeration<String> lines = request.getHeaders(name);
            if (lines != null) digests.add(name, Collections.list(lines));
        }
        return digests;
    }

    /**
     * Reads the lines of one field.
     *
     * @throws IllegalArgumentException when one is malformed, with a reason in words
     */
    static BodyDigests of(String name, List<String> lines) {
        BodyDigests digests = new BodyDigests();
        digests.add(name, lines);
        return digests;
    }

    private void add(String name, List<String> lines) {
        if (lines.isEmpty()) return;
        parse(name, String.join(",", lines)).forEach((algorithm, value) -> {
            String known = ALGORITHMS.get(algorithm);
            if (known == null) return;
            MessageDigest digest = digest(known);
            if (value.length != digest.getDigestLength())
                throw new IllegalArgumentException(
                        name + " has no " + algorithm + " of " + digest.getDigestLength() + " bytes");
            expected.add(new Expected(digest, value));
        });
    }

    private static Map<String, byte[]> parse(String name, String field) {
        Map<String, byte[]> members = new LinkedHashMap<>();
        Matcher member = MEMBER.matcher(field);
        Matcher comma = COMMA.matcher(field);
        int at = 0;
        int end = field.stripTrailing().length();
        while (at < end && field.charAt(at) == ' ') at++;
        while (true) {
            if (!member.region(at, end).lookingAt()) throw malformed(name);
            try {
                // Of several members of one name, the last counts.
                members.put(member.group(1), Base64.getDecoder().decode(member.group(2)));
            } catch (IllegalArgumentException e) {
                throw malformed(name);
            }
            at = member.end();
            if (at == end) return members;
            if (!comma.region(at, end).lookingAt()) throw malformed(name);
            at = comma.end();
        }
    }

    private static IllegalArgumentException malformed(String name) {
        return new IllegalArgumentException(name + " is malformed");
    }

    /** {@return a stream of the same bytes that takes their digests as they are read} */
    public InputStream watch(InputStream body) {
        if (expected.isEmpty()) return body;
        return new FilterInputStream(body) {
            @Override
            public int read() throws IOException {
                int value = super.read();
                if (value >= 0) for (Expected one : expected) one.digest().update((byte) value);
                return value;
            }

            @Override
            public int read(byte[] bytes, int offset, int length) throws IOException {
                int count = super.read(bytes, offset, length);
                if (count > 0) for (Expected one : expected) one.digest().update(bytes, offset, count);
                return count;
            }
        };
    }

    /** Whether the bytes that were read are those that the sender means; to be asked once. */
    public boolean match() {
        boolean all = true;
        for (Expected one : expected) all &= MessageDigest.isEqual(one.digest().digest(), one.value());
        return all;
    }

    private static MessageDigest digest(String algorithm) {
        try {
            return MessageDigest.getInstance(algorithm);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }
}
