package org.jsmesh.servlet;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import org.jsmesh.secret.SignKeys;
import org.jsmesh.servlet.http.Answer;
import org.jsmesh.servlet.http.Document;

/**
 * Asks for a signature where the host has keys, and hands the signature of a request on to the addresses in its answer.
 * Shared caches must keep none of these answers.
 */
final class SignedAddresses {
    /** Of requests: the part of the query that signs, once it is verified. */
    private static final String SIGNED = SignedAddresses.class.getName() + ".signed";

    /** How long senders may ask how their model is doing. */
    private static final Duration OF_SENDERS = Duration.ofDays(1);

    private static final String[] ADDRESSES = {
        "archiveUrl", "firstUrl", "posterUrl", "annotationsUrl", "manifestUrl", "next"
    };

    /** Place of the address in a row of the index of pages. */
    private static final int FILE = 2;

    private final SignKeys keys;

    /** @param keys null where every address is good */
    SignedAddresses(SignKeys keys) {
        this.keys = keys;
    }

    /** Whether the request may have an answer about the model, or {@link SignKeys#ALL}; otherwise answers. */
    boolean admit(HttpServletRequest request, HttpServletResponse response, String id) throws IOException {
        if (keys == null) return true;
        String query = request.getQueryString();
        SignKeys.Verdict verdict = keys.verify(id, query, Instant.now());
        if (verdict == SignKeys.Verdict.GOOD) {
            request.setAttribute(SIGNED, SignKeys.of(query));
            return true;
        }
        String reason = switch (verdict) {
            case NONE -> "this address is not signed";
            case EXPIRED -> "this address was signed for a time that is over";
            default -> "the signature of this address is not that of the server";
        };
        Answer.error(
                request,
                response,
                HttpServletResponse.SC_FORBIDDEN,
                reason,
                "ask whoever gave you the address for a new one");
        return false;
    }

    /** An address of the same model, with the signature of the request. */
    static String address(HttpServletRequest request, String address) {
        String signed = (String) request.getAttribute(SIGNED);
        return signed == null ? address : address + '?' + signed;
    }

    /** The address of the status of a model for the one who has sent it. */
    String ofSender(String id, String address) {
        return keys == null
                ? address
                : address + '?' + keys.query(id, Instant.now().plus(OF_SENDERS));
    }

    /** The address of the page of all models, with the signature that the request may have. */
    String page(HttpServletRequest request, String page) {
        String signature = keys == null ? null : SignKeys.of(request.getQueryString());
        return signature == null ? page : page + '?' + signature;
    }

    /** What caches may do, for an answer that anybody may have or that is signed. */
    static String caching(HttpServletRequest request, String directives) {
        return request.getAttribute(SIGNED) == null ? directives : directives.replace("public", "private");
    }

    /** The JSON of a manifest or a catalogue, with the signature of the request in its addresses. */
    static byte[] json(HttpServletRequest request, byte[] json) throws IOException {
        if (request.getAttribute(SIGNED) == null) return json;
        JsonNode root = Answer.JSON.readTree(json);
        sign(request, root);
        for (JsonNode model : root.path("models")) sign(request, model);
        for (JsonNode page : root.path("pages")) {
            if (page instanceof ArrayNode row && row.size() > FILE)
                row.set(FILE, address(request, row.get(FILE).asText()));
        }
        return Answer.JSON.writeValueAsBytes(root);
    }

    /** The catalogue, likewise. */
    static Document document(HttpServletRequest request, Document catalogue) throws IOException {
        if (request.getAttribute(SIGNED) == null) return catalogue;
        return Document.of("application/json", json(request, catalogue.bytes()));
    }

    /** The manifest in a page, which also says where the manifest itself is. */
    static String ofPage(HttpServletRequest request, String manifest) throws IOException {
        if (request.getAttribute(SIGNED) == null) return manifest;
        ObjectNode object = (ObjectNode) Answer.JSON.readTree(manifest);
        sign(request, object.put("manifestUrl", "manifest.json"));
        return object.toString();
    }

    private static void sign(HttpServletRequest request, JsonNode node) {
        if (!(node instanceof ObjectNode object)) return;
        for (String name : ADDRESSES) {
            String address = object.path(name).asText("");
            if (!address.isEmpty()) object.put(name, address(request, address));
        }
    }
}
