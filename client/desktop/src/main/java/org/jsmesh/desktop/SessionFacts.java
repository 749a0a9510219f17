package org.jsmesh.desktop;

import java.io.IOException;
import java.util.List;
import java.util.function.Consumer;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.desktop.panel.ModelFacts;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Note;
import org.jsmesh.session.ArrivedBytes;
import org.jsmesh.session.MeshStep;
import org.jsmesh.session.RoundReport;
import org.jsmesh.session.SessionListener;
import org.jsmesh.session.SessionProgress;
import org.jsmesh.session.SessionResult;

/** Collects what a session tells of a model, and passes everything on. The session calls it, one call at a time. */
final class SessionFacts implements SessionListener {
    private final SessionListener next;
    private final List<Note> repairs;
    private final Consumer<ModelFacts> display;
    private ArrivedBytes arrived = new ArrivedBytes();
    private ArchiveHeader header;
    private SessionProgress progress;
    private SessionResult result;
    private int rounds;

    /**
     * @param next hears everything after this one
     * @param repairs of the encoding, or none
     * @param display is given the facts after each change
     */
    SessionFacts(SessionListener next, List<Note> repairs, Consumer<ModelFacts> display) {
        this.next = next;
        this.repairs = repairs;
        this.display = display;
    }

    /** A session begins whose bytes go there. */
    void begun(ArrivedBytes bytes) {
        arrived = bytes;
        header = null;
        progress = null;
        result = null;
        rounds = 0;
    }

    private void changed() {
        display.accept(new ModelFacts(header, progress, rounds, result, arrived, repairs));
    }

    @Override
    public void preparing(String stage, double fraction) {
        next.preparing(stage, fraction);
    }

    @Override
    public void opened(ArchiveHeader opened) {
        header = opened;
        next.opened(opened);
        changed();
    }

    @Override
    public void progressed(SessionProgress now) {
        progress = now;
        next.progressed(now);
        changed();
    }

    @Override
    public void refined(Mesh refined, SessionProgress now) {
        progress = now;
        next.refined(refined, now);
        changed();
    }

    @Override
    public boolean isLive() {
        return next.isLive();
    }

    @Override
    public void stepped(MeshStep step) {
        progress = step.progress();
        next.stepped(step);
        changed();
    }

    @Override
    public void roundEnded(RoundReport round) {
        rounds++;
        next.roundEnded(round);
        changed();
    }

    @Override
    public void completed(SessionResult end) {
        result = end;
        next.completed(end);
        changed();
    }

    @Override
    public void retrying(IOException error, int attempt, long pauseMillis) {
        next.retrying(error, attempt, pauseMillis);
    }

    @Override
    public void failed(IOException error) {
        next.failed(error);
    }
}
