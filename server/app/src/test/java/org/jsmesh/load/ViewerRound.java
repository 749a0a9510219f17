package org.jsmesh.load;

import org.jsmesh.load.net.Link;

/** What is noted of one round while it lasts. */
final class ViewerRound {
    private final ViewerProfile profile;
    private final int number;
    private final boolean afterHit;
    private final double beginMillis;
    private final long beginBytes;
    private int requests;
    private boolean hit;

    /**
     * @param before the viewer's round before this one, or null
     * @param beginBytes of the archive that are there already
     */
    ViewerRound(ViewerProfile profile, ViewerRound before, double beginMillis, long beginBytes) {
        this.profile = profile;
        number = before == null ? 1 : before.number + 1;
        afterHit = before != null && before.hit;
        this.beginMillis = beginMillis;
        this.beginBytes = beginBytes;
    }

    double beginMillis() {
        return beginMillis;
    }

    void asked() {
        requests++;
    }

    /** A fault of the test disturbed it. */
    void hit() {
        hit = true;
    }

    /**
     * The round as it ended: beside what would be shown if the link had brought bytes all the time, but for the round
     * trip of one request.
     *
     * @param shownBytes of the archive, of batches that are not complete too
     */
    Tally.Round ended(double nowMillis, double waitMillis, Link link, long shownBytes) {
        Model model = profile.model();
        long before = model.whole(beginBytes);
        double possible = model.whole(beginBytes + link.carries(waitMillis - link.roundTripMillis())) - before;
        double shown = model.whole(shownBytes) - before;
        return new Tally.Round(
                profile.speed(),
                number == 1,
                (nowMillis - beginMillis) / waitMillis,
                possible <= 0 ? 1 : Math.min(1, shown / possible),
                requests,
                hit,
                afterHit,
                shownBytes == model.bytes().length);
    }
}
