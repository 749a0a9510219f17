package org.jsmesh.session;

import java.io.IOException;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.mesh.Mesh;

/**
 * Hears of a session on a given executor, one call at a time if that executor has one thread. When the listener is
 * slower than the network, progress and meshes in between are skipped, never the last ones.
 */
public interface SessionListener {
    /** Hears nothing. */
    SessionListener NONE = new SessionListener() {};

    /**
     * The server encodes the model before it can send anything.
     *
     * @param stage what it does, a few words
     * @param fraction of the stage, 0 to 1
     */
    default void preparing(String stage, double fraction) {}

    /**
     * Header and index have arrived: totals, bounds, channels and materials are known.
     *
     * @param header what the archive says of itself
     */
    default void opened(ArchiveHeader header) {}

    /**
     * Bytes or batches arrived, or the throughput estimate changed.
     *
     * @param progress how far the session is
     */
    default void progressed(SessionProgress progress) {}

    /**
     * The mesh was refined.
     *
     * @param mesh a snapshot that stays as it is
     * @param progress how far the session was then
     */
    default void refined(Mesh mesh, SessionProgress progress) {}

    /**
     * Tells how the listener wants meshes; asked once, when a session is opened.
     *
     * @return true for what each step changes, {@link #stepped}; false for whole meshes, {@link #refined}
     */
    default boolean isLive() {
        return false;
    }

    /**
     * The mesh was refined. No step is skipped.
     *
     * @param step what it changes, and whom to tell when the next one may come
     */
    default void stepped(MeshStep step) {}

    /**
     * A round has ended. Its mesh was given before.
     *
     * @param round what the round planned and what it brought
     */
    default void roundEnded(RoundReport round) {}

    /**
     * Everything has arrived and was compared with the hashes.
     *
     * @param result the mesh, and whether it is the original
     */
    default void completed(SessionResult result) {}

    /**
     * The connection broke, or the server is busy. The session waits and tries again; what has arrived is kept.
     * {@link StreamingSession#tryNow} ends the wait.
     *
     * @param error what failed
     * @param attempt that follows, from 2 on
     * @param pauseMillis until then; −1 when the round ends before, so that the next call tries
     */
    default void retrying(IOException error, int attempt, long pauseMillis) {}

    /**
     * A call failed; what has arrived is kept. After an {@link ArchiveChangedException} or a malformed archive the
     * session is over.
     *
     * @param error says what, where and what to do
     */
    default void failed(IOException error) {}
}
