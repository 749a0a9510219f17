package org.jsmesh.session;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.mesh.Mesh;

/** Writes down what a listener hears. */
final class Recording implements SessionListener {
    final List<String> events = Collections.synchronizedList(new ArrayList<>());
    final List<SessionProgress> progress = Collections.synchronizedList(new ArrayList<>());
    final List<Integer> facesShown = Collections.synchronizedList(new ArrayList<>());

    @Override
    public void preparing(String stage, double fraction) {
        events.add(stage + " " + Math.round(100 * fraction) + "%");
    }

    @Override
    public void opened(ArchiveHeader header) {
        events.add("opened");
    }

    @Override
    public void progressed(SessionProgress now) {
        progress.add(now);
    }

    @Override
    public void refined(Mesh mesh, SessionProgress now) {
        facesShown.add(mesh.faces());
        if (facesShown.size() == 1) events.add("base");
    }

    @Override
    public void roundEnded(RoundReport round) {
        events.add("round");
    }

    @Override
    public void completed(SessionResult result) {
        events.add(result.identical() ? "identical" : "different");
    }

    @Override
    public void failed(IOException error) {
        events.add("failed");
    }
}
