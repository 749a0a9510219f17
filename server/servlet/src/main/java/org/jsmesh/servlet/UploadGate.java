package org.jsmesh.servlet;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jsmesh.servlet.http.Answer;
import org.jsmesh.store.ModelEntry;
import org.jsmesh.store.ModelStore;
import org.jsmesh.upload.Sender;
import org.jsmesh.upload.UploadQueue;
import org.jsmesh.upload.UploadTokens;

/** Says who may send a model under which id, and refuses all else in the words of the protocol. */
final class UploadGate {
    static final String SEND =
            "send a PLY, OBJ, STL, OFF, Hoppe .m, GLB or 3MF file, or a ZIP archive of one with its materials";
    private static final int LONGEST_ID = 80;
    private static final String RETRY_SECONDS = "10";
    private static final Pattern BEARER = Pattern.compile("(?i)Bearer +([A-Za-z0-9._~+/=-]+)");

    private final ModelStore store;

    UploadGate(ModelStore store) {
        this.store = store;
    }

    private UploadQueue queue() {
        return store.uploads();
    }

    /** Whose token the request has, if it is good for the model; otherwise answers, and null. */
    Sender sender(HttpServletRequest request, HttpServletResponse response, String id) throws IOException {
        String field = request.getHeader("Authorization");
        Matcher bearer = BEARER.matcher(field == null ? "" : field.strip());
        UploadTokens tokens = queue().settings().tokens();
        Sender sender = bearer.matches() ? tokens.sender(bearer.group(1), id) : null;
        if (sender != null) return sender;
        if (bearer.matches() && tokens.check(bearer.group(1), id) == UploadTokens.Verdict.ELSEWHERE) {
            refuse(request, response, 403, "this token is not good for the model " + id, "use another id");
            return null;
        }
        response.setHeader("WWW-Authenticate", bearer.matches() ? "Bearer error=\"invalid_token\"" : "Bearer");
        String remedy = "send 'Authorization: Bearer TOKEN' with a token of this server";
        refuse(request, response, 401, "only who has a token may send or delete models", remedy);
        return null;
    }

    /** Whether a model that is sent under the id would get it; otherwise answers. */
    boolean isFree(HttpServletRequest request, HttpServletResponse response, String id) throws IOException {
        if (!isIdToSend(id)) {
            String remedy =
                    "use up to " + LONGEST_ID + " lower-case Latin letters, digits and single hyphens between them";
            refuse(request, response, 400, "'" + id + "' is no id of a model", remedy);
            return false;
        }
        ModelEntry inTheWay = store.inTheWayOf(id);
        if (inTheWay == null) return true;
        String reason = inTheWay.id().equals(id)
                ? "the model " + id + " is a file of the server's folder"
                : "files of the server's folder are named " + inTheWay.name() + ", too";
        refuse(request, response, 409, reason, "use another id");
        return false;
    }

    /** Whether a model may be sent under it: it names a file on any system. */
    static boolean isIdToSend(String id) {
        return id.length() <= LONGEST_ID
                && id.matches("[a-z0-9-]+")
                && ModelEntry.idOf(id).equals(id);
    }

    void tooLarge(HttpServletRequest request, HttpServletResponse response) throws IOException {
        String reason = "the file has more than the " + queue().settings().mostBytes() + " bytes allowed";
        refuse(request, response, 413, reason, "send a smaller model");
    }

    void busy(HttpServletRequest request, HttpServletResponse response) throws IOException {
        response.setHeader("Retry-After", RETRY_SECONDS);
        refuse(request, response, 429, "the queue is full", "send the model again later");
    }

    void noRoom(HttpServletRequest request, HttpServletResponse response) throws IOException {
        response.setHeader("Retry-After", RETRY_SECONDS);
        refuse(request, response, 503, "the server has no room for the model", "send it again later");
    }

    static void refuse(
            HttpServletRequest request, HttpServletResponse response, int status, String reason, String remedy)
            throws IOException {
        try {
            Answer.leaveConnectionClean(request, response);
        } catch (IOException e) {
            response.setHeader("Connection", "close");
        }
        Answer.error(request, response, status, reason, remedy);
    }
}
