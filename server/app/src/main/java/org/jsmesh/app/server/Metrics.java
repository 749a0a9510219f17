package org.jsmesh.app.server;

import io.micrometer.core.instrument.Counter;
import io.micrometer.core.instrument.DistributionSummary;
import io.micrometer.core.instrument.FunctionCounter;
import io.micrometer.core.instrument.Gauge;
import io.micrometer.core.instrument.Timer;
import io.micrometer.core.instrument.binder.jvm.ClassLoaderMetrics;
import io.micrometer.core.instrument.binder.jvm.JvmGcMetrics;
import io.micrometer.core.instrument.binder.jvm.JvmMemoryMetrics;
import io.micrometer.core.instrument.binder.jvm.JvmThreadMetrics;
import io.micrometer.core.instrument.binder.system.FileDescriptorMetrics;
import io.micrometer.core.instrument.binder.system.ProcessorMetrics;
import io.micrometer.core.instrument.binder.system.UptimeMetrics;
import io.micrometer.prometheusmetrics.PrometheusConfig;
import io.micrometer.prometheusmetrics.PrometheusMeterRegistry;
import java.time.Duration;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.function.ToDoubleFunction;
import org.eclipse.jetty.server.Request;
import org.jsmesh.store.ModelSource;
import org.jsmesh.store.ModelStatus;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.bucket.SiteStore;

/** Counts what the server does, for Prometheus. {@code docs/operation.md} lists the names. Thread-safe. */
public final class Metrics implements Exchange.Listener, AutoCloseable {
    private static final int STATUS_LIMIT = 600;
    private static final int KINDS = ResourceKind.values().length;

    private final PrometheusMeterRegistry registry = new PrometheusMeterRegistry(PrometheusConfig.DEFAULT);
    private final JvmGcMetrics collections = new JvmGcMetrics();
    private final AtomicReferenceArray<Counter> requests = new AtomicReferenceArray<>(KINDS * STATUS_LIMIT);
    private final Counter[] bytes = new Counter[KINDS];
    private final Counter[] aborts = new Counter[KINDS];
    private final Timer[] firstBytes = new Timer[KINDS];
    private final Counter planned;
    private final Counter sent;
    private final DistributionSummary patches;

    /** @param store whose models and encodings are counted */
    Metrics(ModelSource source) {
        for (ResourceKind kind : ResourceKind.values()) {
            String resource = label(kind);
            bytes[kind.ordinal()] = Counter.builder("jsm.sent.bytes")
                    .description("Bytes of content that connections took")
                    .tag("resource", resource)
                    .register(registry);
            aborts[kind.ordinal()] = Counter.builder("jsm.aborts")
                    .description("Answers that ended before they were whole")
                    .tag("resource", resource)
                    .register(registry);
            firstBytes[kind.ordinal()] = Timer.builder("jsm.time.to.first.byte")
                    .description("From the first byte of a request to the first of its answer")
                    .tag("resource", resource)
                    .serviceLevelObjectives(
                            Duration.ofMillis(1),
                            Duration.ofMillis(10),
                            Duration.ofMillis(100),
                            Duration.ofSeconds(1),
                            Duration.ofSeconds(10))
                    .register(registry);
        }
        planned = Counter.builder("jsm.patches.planned.bytes")
                .description("Bytes that the server chose to send for a wait")
                .register(registry);
        sent = Counter.builder("jsm.patches.sent.bytes")
                .description("Bytes of these that connections took")
                .register(registry);
        patches = DistributionSummary.builder("jsm.patches.sent.fraction")
                .description("Share of the planned bytes that connections took, by answer")
                .serviceLevelObjectives(0.25, 0.5, 0.75, 0.999)
                .register(registry);
        if (source instanceof ModelStore store) count(store);
        if (source instanceof SiteStore site) count(site);
        new JvmMemoryMetrics().bindTo(registry);
        new JvmThreadMetrics().bindTo(registry);
        new ClassLoaderMetrics().bindTo(registry);
        new ProcessorMetrics().bindTo(registry);
        new FileDescriptorMetrics().bindTo(registry);
        new UptimeMetrics().bindTo(registry);
        collections.bindTo(registry);
    }

    private void count(ModelStore store) {
        for (ModelStatus.State state : ModelStatus.State.values()) {
            Gauge.builder("jsm.models", store, models -> models.count(state))
                    .description("Models by state")
                    .tag("state", state.name().toLowerCase(Locale.ROOT))
                    .register(registry);
        }
        gauge("jsm.encode.queue.length", "Models that wait to be encoded", store, ModelStore::waitingEncodings);
        gauge("jsm.upload.queue.length", "Models that clients send, until they are encoded", store, Metrics::uploads);
        gauge("jsm.encode.running", "Models that are being encoded", store, ModelStore::runningEncodings);
        counter("jsm.encode.done", "Models encoded", store, ModelStore::doneEncodings);
        counter("jsm.encode.failed", "Models that could not be encoded", store, ModelStore::failedEncodings);
    }

    private void count(SiteStore site) {
        gauge("jsm.models", "Models of the site when its catalogue was looked at last", site, SiteStore::models);
        counter("jsm.store.reads", "Requests to the store that were answered", site, SiteStore::doneReads);
        counter("jsm.store.failed", "Requests to the store that failed or were given up", site, SiteStore::failedReads);
        gauge("jsm.store.waiting", "Requests to the store that wait for a thread", site, SiteStore::waitingReads);
        counter("jsm.store.read.bytes", "Bytes of archives read from the store", site, SiteStore::readBytes);
        gauge("jsm.store.kept.bytes", "Bytes of archives in memory", site, SiteStore::keptBytes);
    }

    /** Adds the figures of connections once there is a server. */
    void watch(GuardedConnector connector, AdmissionHandler door, Clients clients, SlowConnectionGuard watchman) {
        gauge("jsm.connections", "Open connections", connector, GuardedConnector::connections);
        gauge(
                "jsm.requests.running",
                "Requests that are being answered",
                door,
                d -> d.running().size());
        counter("jsm.rate.refused", "Requests of addresses that ask too fast", door.rates(), RequestRates::refused);
        gauge("jsm.clients", "Addresses with a connection or a request", clients, Clients::size);
        counter(
                "jsm.dropped",
                "Connections closed, and streams of HTTP/2 reset, for their slowness",
                watchman,
                SlowConnectionGuard::dropped);
    }

    /** Adds the log's losses. */
    void watch(AccessLog log) {
        counter("jsm.access.log.lost", "Requests that the access log had no room for", log, AccessLog::lost);
    }

    private <T> void gauge(String name, String description, T of, ToDoubleFunction<T> value) {
        Gauge.builder(name, of, value)
                .description(description)
                .strongReference(true)
                .register(registry);
    }

    private <T> void counter(String name, String description, T of, ToDoubleFunction<T> value) {
        FunctionCounter.builder(name, of, value).description(description).register(registry);
    }

    @Override
    public void ended(Exchange exchange) {
        Request request = exchange.request();
        ResourceKind kind =
                ResourceKind.of(request.getMethod(), request.getHttpURI().getCanonicalPath());
        int place = kind.ordinal();
        request(kind, exchange.status()).increment();
        bytes[place].increment(exchange.sentBytes());
        if (exchange.isAborted()) aborts[place].increment();
        if (exchange.firstByteAfterNanos() >= 0)
            firstBytes[place].record(exchange.firstByteAfterNanos(), TimeUnit.NANOSECONDS);
        if (kind == ResourceKind.PATCHES && exchange.status() == 200 && exchange.plannedBytes() > 0) {
            planned.increment(exchange.plannedBytes());
            sent.increment(exchange.sentBytes());
            patches.record((double) exchange.sentBytes() / exchange.plannedBytes());
        }
    }

    private Counter request(ResourceKind kind, int status) {
        int place = kind.ordinal() * STATUS_LIMIT + (status < STATUS_LIMIT ? status : 0);
        Counter known = requests.get(place);
        if (known != null) return known;
        Counter counter = Counter.builder("jsm.requests")
                .description("Requests that are over; status 0: the client went away before the answer")
                .tag("resource", label(kind))
                .tag("status", Integer.toString(status))
                .register(registry);
        requests.set(place, counter);
        return counter;
    }

    private static String label(ResourceKind kind) {
        return kind.name().toLowerCase(Locale.ROOT);
    }

    /** Everything in the text format of Prometheus. */
    public String text() {
        return registry.scrape();
    }

    @Override
    public void close() {
        collections.close();
        registry.close();
    }

    private static int uploads(ModelStore store) {
        return store.uploads() == null ? 0 : store.uploads().length();
    }
}
