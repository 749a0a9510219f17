package org.jsmesh.session;

import java.io.IOException;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Flow;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/**
 * One HTTP response, metered. It requests buffers from the connection only when the ones before were taken. So their
 * arrival times are those of the network, and a session that pauses holds the sender back.
 */
final class HttpBody implements ArchiveBody, HttpResponse.BodySubscriber<Void> {
    /** Interprets the head of a response for the request. */
    interface HeadReader {
        Head read(HttpResponse.ResponseInfo info) throws IOException;
    }

    private record Failure(Throwable cause) {}

    private final HttpRequest request;
    private final HeadReader headReader;
    private final SteadyClock clock;
    private final BlockingQueue<Object> events = new LinkedBlockingQueue<>();
    private volatile Flow.Subscription subscription;
    private volatile boolean cancelled;
    private CompletableFuture<?> exchange;
    private boolean wanting;
    private volatile boolean http2;

    HttpBody(HttpRequest request, HeadReader headReader, SteadyClock clock) {
        this.request = request;
        this.headReader = headReader;
        this.clock = clock;
    }

    /** Sends the request and returns at once. */
    HttpBody send(HttpClient client) {
        exchange = client.sendAsync(request, info -> {
            events.add(info);
            return this;
        });
        exchange.whenComplete((response, error) -> {
            if (error != null) events.add(new Failure(error));
        });
        return this;
    }

    @Override
    public Part poll(long timeoutMillis) throws IOException {
        if (wanting) {
            wanting = false;
            subscription.request(1);
        }
        Object event;
        try {
            event = events.poll(timeoutMillis, TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return null;
        }
        if (event instanceof Failure failure) throw asIo(failure.cause());
        if (event instanceof HttpResponse.ResponseInfo info) {
            http2 = info.version() == HttpClient.Version.HTTP_2;
            return headReader.read(info);
        }
        wanting = event instanceof Bytes;
        return (Part) event;
    }

    private static IOException asIo(Throwable error) {
        Throwable cause = error instanceof CompletionException && error.getCause() != null ? error.getCause() : error;
        return cause instanceof IOException io ? io : new IOException(String.valueOf(cause), cause);
    }

    @Override
    public void cancel() {
        cancelled = true;
        Flow.Subscription s = subscription;
        if (s != null) s.cancel();
        exchange.cancel(true);
    }

    @Override
    public String url() {
        return request.uri().toString();
    }

    @Override
    public String range() {
        return request.headers().firstValue("Range").orElse(null);
    }

    @Override
    public boolean isHttp2() {
        return http2;
    }

    @Override
    public CompletionStage<Void> getBody() {
        return CompletableFuture.completedFuture(null);
    }

    @Override
    public void onSubscribe(Flow.Subscription s) {
        subscription = s;
        if (cancelled) s.cancel();
        else s.request(1);
    }

    @Override
    public void onNext(List<ByteBuffer> buffers) {
        double now = clock.millis();
        int length = 0;
        for (ByteBuffer b : buffers) length += b.remaining();
        byte[] array = new byte[length];
        int at = 0;
        for (ByteBuffer b : buffers) {
            int n = b.remaining();
            b.get(array, at, n);
            at += n;
        }
        events.add(new Bytes(array, length, now));
    }

    @Override
    public void onError(Throwable error) {
        events.add(new Failure(error));
    }

    @Override
    public void onComplete() {
        events.add(new End());
    }
}
