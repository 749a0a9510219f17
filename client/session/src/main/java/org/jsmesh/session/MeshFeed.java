package org.jsmesh.session;

/**
 * Gives a listener the mesh as it is refined: copies of all of it, or what each step changes. A listener that follows
 * the changes gets the next ones when it has taken those before, or at the end of a round. Used on the session's
 * thread.
 */
final class MeshFeed {
    private final ReceivedArchive archive;
    private final ListenerFeed feed;
    private final LiveFollower follower; // or null
    private final SteadyClock clock;
    private final int millis;
    private int shownBatches;
    private double shownMillis;

    /**
     * @param follower of the archive's decoder, for a listener that follows the mesh; else null
     * @param millis at least between two meshes, but at the end of a round
     */
    MeshFeed(ReceivedArchive archive, ListenerFeed feed, LiveFollower follower, SteadyClock clock, int millis) {
        this.archive = archive;
        this.feed = feed;
        this.follower = follower;
        this.clock = clock;
        this.millis = millis;
    }

    /** Bytes have arrived. */
    void arrived(SessionProgress progress) {
        if (shownBatches == 0 || clock.millis() - shownMillis >= millis && !feed.isAwaited()) show(progress);
    }

    /** Gives what there is. */
    void show(SessionProgress progress) {
        if (archive.batches() == shownBatches || archive.batches() == 0) return;
        shownBatches = archive.batches();
        shownMillis = clock.millis();
        if (follower == null) feed.refined(archive.mesh(), progress);
        else feed.stepped(taken -> follower.step(progress, taken));
    }
}
