package org.jsmesh.servlet;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.jsmesh.files.ArchiveReport;
import org.jsmesh.servlet.http.Document;
import org.jsmesh.store.Archive;
import org.jsmesh.store.ModelEntry;

/** The manifest of a model: its totals, bounds, hashes, batches, and where its archive is. */
final class ManifestJson {
    private ManifestJson() {}

    static String of(ModelEntry entry, Archive archive) {
        ArchiveReport report = ArchiveReport.of(archive.header(), archive.sha256());
        return report.toManifestJson(entry.id(), entry.name(), archive.sha256() + ".jsm", Annotations.url(entry));
    }

    static void send(HttpServletRequest request, HttpServletResponse response, ModelEntry entry, Archive archive)
            throws IOException {
        byte[] json = SignedAddresses.json(request, of(entry, archive).getBytes(StandardCharsets.UTF_8));
        // Short, because the model may be encoded again, and its archive then has another URL.
        Document.of("application/json", json)
                .send(request, response, SignedAddresses.caching(request, "public, max-age=10"));
    }
}
