package org.jsmesh.load;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.load.net.EventLoop;
import org.jsmesh.load.net.Http1Connection;
import org.jsmesh.load.net.Http2Connection;
import org.jsmesh.load.net.Link;
import org.jsmesh.load.net.ViewerConnection;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.MeshIdentity;

/** Starts the server, lets viewers come and go, injects faults, and looks at the server meanwhile. */
final class LoadRun implements AutoCloseable {
    /** Collecting the whole heap stops the server for some ten milliseconds: done seldom. */
    private static final double FULL_COLLECTION_SECONDS = 30;

    /** How long sockets may take to be gone when everybody has left. */
    private static final double SETTLE_SECONDS = 20;

    private final LoadSettings settings;
    private final List<Model> models;
    private final ServerProcess server;
    private final InjectedFaults faults = new InjectedFaults();
    private final Tally tally = new Tally();
    private final Samples samples = new Samples();
    private final EventLoop loop = new EventLoop("load-viewers");
    private final FaultProxy proxy;
    private final Set<LoadViewer> present = new HashSet<>();
    private final ExecutorService decoding;
    private volatile int presentCount;
    private volatile boolean over;
    private double beginMillis;
    private double lastCollection = Double.NEGATIVE_INFINITY;
    private double cpuOfStarting;
    private double cpuOfEarlierStarts;
    private double sentByEarlierStarts;
    private int starts;

    /** @param folder for archives and logs */
    LoadRun(LoadSettings settings, List<Path> modelFiles, Path folder) throws IOException {
        this.settings = settings;
        models = Model.encode(modelFiles, folder.resolve("archives"));
        server = new ServerProcess(folder, folder.resolve("archives"), settings);
        proxy = new FaultProxy(server.address(), faults, settings);
        decoding = Executors.newSingleThreadExecutor(task -> {
            Thread thread = new Thread(task, "load-decoder");
            thread.setDaemon(true);
            thread.setPriority(Thread.MIN_PRIORITY);
            return thread;
        });
    }

    EventLoop loop() {
        return loop;
    }

    Tally tally() {
        return tally;
    }

    LoadSettings settings() {
        return settings;
    }

    InjectedFaults faults() {
        return faults;
    }

    /** Starts to connect a viewer. */
    ViewerConnection connect(ViewerProfile profile, Link link, ViewerConnection.Listener listener) throws IOException {
        return settings.http2()
                ? new Http2Connection(loop, profile.source(), address(profile), link, listener)
                : new Http1Connection(loop, profile.source(), address(profile), link, listener);
    }

    /** Where a viewer finds the server. */
    InetSocketAddress address(ViewerProfile profile) {
        try {
            return profile.proxied() ? proxy.address() : server.address();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** True when nobody new comes, and those who are there are to come to their end. */
    boolean isOver() {
        return over;
    }

    /** Runs from the first viewer to the last one's end. */
    LoadReport run() throws IOException, InterruptedException {
        start();
        for (Model model : models) {
            String manifest = server.manifest(model);
            if (!manifest.contains('"' + model.sha256() + '"') || !manifest.contains('"' + model.meshSha256() + '"'))
                throw new IOException("the manifest of " + model.id() + " names other hashes than the file has");
        }
        ProcessFigures before = ProcessFigures.of(server.pid());
        beginMillis = EventLoop.millis();
        loop.submit(() -> {
            for (int i = 0; i < settings.viewers(); i++) {
                int number = i;
                double at = beginMillis + settings.arrivalSeconds() * 1000 * i / settings.viewers();
                loop.at(at, () -> arrive(number));
            }
        });
        observe();
        over = true;
        drain();
        double ended = seconds();
        ProcessFigures after = settle(before);
        takeLastCounts();
        loop.close();
        proxy.close();
        decoding.shutdown();
        if (!decoding.awaitTermination(2, TimeUnit.MINUTES)) throw new IOException("decoding does not end");
        tally.wrongEnds += present.size();
        present.forEach(v -> tally.error("viewer " + v.profile().number() + " never came to an end: " + v));
        double cpu = cpuOfEarlierStarts - cpuOfStarting;
        ServerFigures figures = new ServerFigures(before, after, cpu, sentByEarlierStarts, server.output());
        return new LoadReport(settings, models, tally, faults, samples, figures, ended);
    }

    private void start() throws IOException, InterruptedException {
        server.start();
        starts++;
        cpuOfStarting += ProcessFigures.of(server.pid()).cpuSeconds();
    }

    private double seconds() {
        return (EventLoop.millis() - beginMillis) / 1000;
    }

    /** Looks at the server and restarts it, until the time is up. */
    private void observe() throws IOException, InterruptedException {
        int restarts = 0;
        while (seconds() < settings.seconds()) {
            if (restarts < settings.restartSeconds().size()
                    && seconds() >= settings.restartSeconds().get(restarts)) {
                restarts++;
                restart();
            }
            look();
            Thread.sleep(settings.sampleMillis());
        }
    }

    private void restart() throws IOException, InterruptedException {
        takeLastCounts();
        faults.outageBegins(EventLoop.millis());
        double stopped = server.stop();
        start();
        faults.outageEnds(EventLoop.millis());
        tally.stopSeconds.add(stopped);
        lastCollection = seconds();
    }

    private void look() throws IOException, InterruptedException {
        if (loop.failure() != null) throw new IllegalStateException("the viewers' loop failed", loop.failure());
        int live = -1;
        if (seconds() - lastCollection >= FULL_COLLECTION_SECONDS) {
            lastCollection = seconds();
            live = server.liveHeapMegabytes();
        }
        Map<String, Double> metrics = server.metrics();
        double load = ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage();
        ProcessFigures figures = ProcessFigures.of(server.pid());
        samples.add(new Samples.Sample(
                seconds(), starts, figures, live, Samples.direct(metrics), presentCount, load, loop.worstLagMillis()));
    }

    private void drain() throws IOException, InterruptedException {
        double latest = seconds() + settings.longestExtraSeconds();
        while (presentCount > 0 && seconds() < latest) {
            look();
            Thread.sleep(settings.sampleMillis());
        }
    }

    /** Waits until descriptors are back at where they began, and says what there is then. */
    private ProcessFigures settle(ProcessFigures before) throws IOException, InterruptedException {
        double latest = seconds() + SETTLE_SECONDS;
        ProcessFigures now = ProcessFigures.of(server.pid());
        while (now.openFiles() > before.openFiles() && seconds() < latest) {
            Thread.sleep(500);
            now = ProcessFigures.of(server.pid());
        }
        return now;
    }

    /** Adds up what one start of the server did. */
    private void takeLastCounts() throws IOException {
        cpuOfEarlierStarts += ProcessFigures.of(server.pid()).cpuSeconds();
        sentByEarlierStarts += server.metrics().entrySet().stream()
                .filter(e -> e.getKey().startsWith("jsm_sent_bytes_total")
                        && !e.getKey().contains("manifest"))
                .mapToDouble(Map.Entry::getValue)
                .sum();
    }

    private void arrive(int number) {
        LoadViewer viewer = new LoadViewer(ViewerProfile.draw(number, settings, models), this);
        present.add(viewer);
        presentCount = present.size();
        tally.started++;
        viewer.begin();
    }

    /** A viewer came to its end, a good or a bad one. */
    void left(LoadViewer viewer) {
        present.remove(viewer);
        presentCount = present.size();
        if (over) return;
        // The next number of the same class, so that the mix stays what it was.
        arrive(viewer.profile().number() + SpeedClass.ALL.size() * settings.viewers());
    }

    /** Decodes an archive that a viewer put together, and compares the mesh. */
    void decode(Model model, byte[] archive) {
        decoding.execute(() -> {
            boolean original = false;
            try {
                ArchiveDecoder decoder = new ArchiveDecoder();
                decoder.feed(archive, 0, archive.length);
                original = decoder.isComplete()
                        && MeshIdentity.sha256(decoder.meshInOrder()).equals(model.meshSha256());
            } catch (MalformedStreamException e) {
                // counted as what it is below
            }
            tally.decoded.incrementAndGet();
            if (!original) tally.decodedWrongly.incrementAndGet();
        });
    }

    @Override
    public void close() {
        server.close();
        if (loop.failure() == null) loop.close();
        proxy.close();
        decoding.shutdownNow();
    }
}
