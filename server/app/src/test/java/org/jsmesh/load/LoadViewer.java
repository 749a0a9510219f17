package org.jsmesh.load;

import java.nio.ByteBuffer;
import java.util.Random;
import org.jsmesh.load.net.EventLoop;
import org.jsmesh.load.net.Link;
import org.jsmesh.load.net.ResponseHead;
import org.jsmesh.load.net.Retry;
import org.jsmesh.load.net.ViewerConnection;
import org.jsmesh.plan.BatchRequest;

/**
 * Somebody who looks at one model: rounds of T with pauses between them, until the original is there. What breaks is
 * resumed where it broke. Used on its loop alone.
 */
final class LoadViewer implements ViewerConnection.Listener {
    private static final double LOOK_AGAIN_MILLIS = 50;

    private final ViewerProfile profile;
    private final LoadRun run;
    private final EventLoop loop;
    private final Tally tally;
    private final Model model;
    private final Random random;
    private final Link link;
    private final ViewerLine line;
    private final Download download;
    private final Planning planning = new Planning();
    private final Retry retry;

    private ViewerRequest request;
    private boolean manifestRead;

    private ViewerRound round;
    private ViewerRound lastRound;
    private long cutAtByte = Long.MAX_VALUE;
    private boolean done;

    LoadViewer(ViewerProfile profile, LoadRun run) {
        this.profile = profile;
        this.run = run;
        loop = run.loop();
        tally = run.tally();
        model = profile.model();
        random = new Random(profile.seed());
        retry = new Retry(random);
        link = new Link(profile.speed().bitsPerSecond(), profile.roundTripMillis());
        line = new ViewerLine(profile, run, link, this);
        download = new Download(model, profile.decodes());
    }

    ViewerProfile profile() {
        return profile;
    }

    void begin() {
        manifestRead = !profile.readsManifest();
        if (manifestRead) beginRound();
        else ask(ViewerRequest.manifest(model));
    }

    private void beginRound() {
        double now = EventLoop.millis();
        round = new ViewerRound(profile, lastRound, now, download.received());
        if (retry.atMillis() > now || link.blockedUntilMillis() > now) round.hit();
        planning.beginRound(now, run.settings().waitMillis());
        injectFault(now);
        loop.at(planning.deadlineMillis(), this::look);
        goOn();
    }

    private void injectFault(double now) {
        ViewerFault fault = ViewerFault.draw(random, run.settings());
        double most = Math.min(link.carries(run.settings().waitMillis()), model.bytes().length);
        if (fault.isCut()) cutAtByte = download.received() + (long) (fault.place() * most);
        if (!fault.isStall()) return;
        double at = now + fault.place() * run.settings().waitMillis();
        loop.at(at, () -> {
            if (done) return;
            run.faults().viewerStalls.incrementAndGet();
            link.blockUntil(at + fault.stallMillis());
            hit();
        });
    }

    /** Asks for what comes next, when nothing is under way and it is time. */
    private void goOn() {
        if (done || request != null) return;
        double now = EventLoop.millis();
        if (now < retry.atMillis()) {
            loop.at(retry.atMillis(), this::goOn);
            return;
        }
        if (!manifestRead) {
            ask(ViewerRequest.manifest(model));
            return;
        }
        if (round == null) return;
        BatchRequest next =
                planning.next(now, model.isIndexIn(download.received()) ? model.index() : null, download.received());
        if (next == null) {
            endRound();
            return;
        }
        round.asked();
        ask(ViewerRequest.bytes(model, next, profile.serverPlan()));
        planning.sent(now);
    }

    private void ask(ViewerRequest wanted) {
        request = wanted;
        tally.requests++;
        line.send(wanted, () -> !done && request == wanted);
    }

    @Override
    public void onHead(ResponseHead head) {
        double now = EventLoop.millis();
        line.sign(now);
        tally.status(head.status(), !head.field("Retry-After").isEmpty());
        if (head.status() == 503) {
            hit();
            tally.refusals++;
            retry.refused(now, head.field("Retry-After"));
            return;
        }
        String wrong = request.check(head, model);
        if (wrong != null) fail(wrong);
    }

    @Override
    public void onBody(ByteBuffer bytes) {
        double now = EventLoop.millis();
        line.sign(now);
        if (!request.takesBody()) return;
        retry.succeeded();
        int count = bytes.remaining();
        tally.bodyBytes += count;
        String wrong = download.take(request.place(), bytes);
        request.advance(count);
        if (wrong != null) {
            fail(wrong);
            return;
        }
        planning.arrived(now, count);
        if (download.received() >= cutAtByte) cut();
        else if (round != null && now >= planning.deadlineMillis()) look();
    }

    @Override
    public void onLateBody(int bytes) {
        line.sign(EventLoop.millis());
        tally.lateBytes += bytes;
    }

    private void cut() {
        cutAtByte = Long.MAX_VALUE;
        if (download.isComplete()) return;
        if (run.settings().http2() && random.nextBoolean()) {
            run.faults().viewerResets.incrementAndGet();
            hit();
            giveUp();
            goOn();
            return;
        }
        line.cut();
        onBroken("cut by the viewer itself");
    }

    @Override
    public void onEnd(ResponseHead head) {
        boolean manifest = request.isManifest();
        request = null;
        if (!manifest) planning.ended();
        if (manifest && head.status() == 200) {
            manifestRead = true;
            beginRound();
        } else if (round != null || !manifestRead) {
            goOn();
        } else if (download.isComplete()) {
            finish();
        }
    }

    @Override
    public void onBroken(String why) {
        double now = EventLoop.millis();
        boolean asked = request != null;
        // Without a request the server may close.
        if (asked && !line.isExplained(now)) {
            tally.unexplainedBreaks++;
            tally.error("viewer " + profile.number() + ": " + why + " at byte " + download.received());
        }
        line.lost();
        if (!asked || done) return;
        hit();
        if (!request.isManifest()) planning.ended();
        request = null;
        if (!retry.failed(now)) {
            fail("gave up, too many failures: " + why);
            return;
        }
        goOn();
    }

    private void hit() {
        if (round != null) round.hit();
    }

    /** At the deadline, and at each byte after it as long as there is nothing to show. */
    private void look() {
        if (done || round == null || EventLoop.millis() < planning.deadlineMillis()) return;
        if (download.received() >= model.index().end(0)) endRound();
    }

    private void endRound() {
        double now = EventLoop.millis();
        if (line.wasFaulty(round.beginMillis())) hit();
        if (run.faults().isOutage(round.beginMillis(), now)) hit();
        tally.rounds.add(round.ended(now, run.settings().waitMillis(), link, download.received()));
        lastRound = round;
        round = null;
        if (download.isComplete()) finish();
        else pause(now);
    }

    private void pause(double now) {
        if (request != null) readOn();
        double pause = run.isOver() ? 100 : run.settings().pauseMillis(random);
        loop.at(now + pause, () -> {
            if (!done) beginRound();
        });
    }

    /** Between two rounds: reads a response on as long as the planner likes. */
    private void readOn() {
        if (done || round != null || request == null || request.isManifest()) return;
        double now = EventLoop.millis();
        if (planning.mayGoOn(now, request.bytesLeft())) {
            loop.at(now + LOOK_AGAIN_MILLIS, this::readOn);
            return;
        }
        tally.givenUp++;
        giveUp();
    }

    private void giveUp() {
        line.giveUp();
        request = null;
        planning.ended();
    }

    private void finish() {
        if (done) return;
        if (!download.isOriginal()) {
            fail("the archive's SHA-256 is another one");
            return;
        }
        tally.completed(profile.speed());
        if (profile.decodes()) run.decode(model, download.kept());
        done = true;
        // People look at what they waited for; the connection stays open meanwhile.
        double look = run.settings().lastLookMillis(random);
        loop.at(EventLoop.millis() + (run.isOver() ? 0 : look), this::leave);
    }

    private void fail(String why) {
        if (done) return;
        tally.wrongEnds++;
        tally.error("viewer " + profile.number() + " (" + model.id() + ", byte " + download.received() + "): " + why);
        done = true;
        leave();
    }

    private void leave() {
        tally.bytesTwice += download.sentTwice();
        line.close();
        run.left(this);
    }
}
