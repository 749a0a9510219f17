package org.jsmesh.servlet;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.net.URI;
import java.util.Map;
import org.jsmesh.servlet.http.Answer;
import org.jsmesh.servlet.http.Document;
import org.jsmesh.servlet.http.ResponseSender;

/** What starts the desktop viewer from a browser: a text for each model, and the viewer itself. */
final class LaunchRequests {
    private static final String FOLDER = ".viewer/";
    private static final String FILE = "/jsm-viewer.jar";
    private static final String FOLDER_PATH = '/' + FOLDER;

    private final ServletSettings settings;

    LaunchRequests(ServletSettings settings) {
        this.settings = settings;
    }

    /** Whether the path is that of a viewer, this one or another. */
    static boolean isJar(String path) {
        return path.startsWith(FOLDER_PATH);
    }

    /** Sends the viewer, which is for everybody: its address has the hash of its bytes. */
    void sendJar(HttpServletRequest request, HttpServletResponse response, String path) throws IOException {
        ViewerJar.State viewer = viewer(request, response);
        if (viewer == null) return;
        if (!path.equals(FOLDER_PATH + viewer.sha256() + FILE)) {
            notFound(
                    request,
                    response,
                    "the viewer of this server is another one by now",
                    "ask for the model's viewer.jnlp again, which names it");
            return;
        }
        response.setHeader("Cache-Control", ArchiveResponse.IMMUTABLE);
        ByteRange range =
                ArchiveResponse.range(request, response, '"' + viewer.sha256() + '"', viewer.bytes(), "viewer");
        if (range == null) return;
        response.setContentType("application/java-archive");
        response.setContentLengthLong(range.length());
        if (request.getMethod().equals("HEAD")) return;
        ResponseSender.Source source = viewer.content().source();
        if (source == null) throw new IOException("the viewer was replaced while it was asked for");
        ResponseSender.start(request, response, source, range.first(), range.length());
    }

    /** Sends the text that starts the viewer with a model. It carries the signature of the request. */
    void sendLaunch(HttpServletRequest request, HttpServletResponse response, AskedModel model, String name)
            throws IOException {
        ViewerJar.State viewer = viewer(request, response);
        if (viewer == null) return;
        String root = root(request);
        if (root == null) {
            String reason = "the request names a host that is none";
            Answer.error(
                    request, response, HttpServletResponse.SC_BAD_REQUEST, reason, "ask with the name of the server");
            return;
        }
        String segment = model.segment();
        String manifest = SignedAddresses.address(request, segment + "/manifest.json");
        byte[] text = LaunchFile.of(root, FOLDER + viewer.sha256() + FILE, viewer, name, manifest);
        response.setHeader("Content-Disposition", "inline; filename*=UTF-8''" + segment + ".jnlp");
        // Not packed: those who read it are old.
        Document.of(LaunchFile.TYPE, text, Map.of()).send(request, response, "private, no-cache");
    }

    private ViewerJar.State viewer(HttpServletRequest request, HttpServletResponse response) throws IOException {
        ViewerJar.State viewer =
                settings.viewer() == null ? null : settings.viewer().state();
        if (viewer == null)
            notFound(
                    request,
                    response,
                    "this server has no desktop viewer to start",
                    "start jsm-viewer.jar with the address of the model's manifest.json");
        return viewer;
    }

    private static void notFound(HttpServletRequest request, HttpServletResponse response, String reason, String remedy)
            throws IOException {
        Answer.error(request, response, HttpServletResponse.SC_NOT_FOUND, reason, remedy);
    }

    /** Address of the folder of the catalogue as visitors have it; null when it is not known. */
    private String root(HttpServletRequest request) {
        if (settings.publicUrl() != null) {
            String folder = request.getPathInfo() == null ? "" : request.getServletPath();
            return settings.publicUrl() + (folder.isEmpty() ? "" : folder.substring(folder.lastIndexOf('/') + 1) + '/');
        }
        try {
            URI asked = URI.create(request.getRequestURL().toString());
            return asked.getHost() == null ? null : asked.resolve("../").toString();
        } catch (IllegalArgumentException e) {
            return null;
        }
    }
}
