package org.jsmesh.session;

import java.net.URI;
import java.nio.file.Path;

/** A program that streams an archive of noise until it is killed. */
final class KilledSession {
    private KilledSession() {}

    public static void main(String[] arguments) {
        SessionOptions options = SessionOptions.defaults().withCache(Path.of(arguments[1]));
        try (StreamingSession session = StreamingSession.open(
                URI.create(arguments[0]), options, FakeArchive.decoder(""), SessionListener.NONE, Runnable::run)) {
            session.complete().join();
        }
    }
}
