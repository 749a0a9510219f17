package org.jsmesh.app.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.eclipse.jetty.io.ByteArrayEndPoint;
import org.eclipse.jetty.io.Connection;
import org.eclipse.jetty.server.HttpConnectionFactory;
import org.eclipse.jetty.server.Server;
import org.junit.jupiter.api.Test;

class SlowConnectionGuardTest {
    private static final int LOOKS = 3;

    @Test
    void shouldGoOnWhenAConnectionCannotBeLookedAt() throws Exception {
        Limits limits = Limits.defaults().withMillis(80, 80, 80, 80);
        Clients clients = new Clients(List.of());
        GuardedConnector connector = new GuardedConnector(new Server(), limits, clients, new HttpConnectionFactory());
        AdmissionHandler door = new AdmissionHandler(limits, clients, request -> true, List.of(), List.of());
        CountDownLatch looks = new CountDownLatch(LOOKS);
        CountDownLatch closed = new CountDownLatch(LOOKS);
        connector.onEndPointOpened(new ByteArrayEndPoint() {
            @Override
            public Connection getConnection() {
                looks.countDown();
                throw new IllegalStateException("this is what the test is about, no trouble");
            }
        });
        for (int i = 0; i < LOOKS; i++) {
            ByteArrayEndPoint idle = new ByteArrayEndPoint() {
                @Override
                public void onClose(Throwable failure) {
                    super.onClose(failure);
                    closed.countDown();
                }
            };
            connector.onEndPointOpened(idle);
        }
        SlowConnectionGuard watchman = new SlowConnectionGuard(limits, connector, door);
        watchman.start();
        try {
            assertThat(looks.await(30, TimeUnit.SECONDS)).as("it looks again").isTrue();
            assertThat(closed.await(30, TimeUnit.SECONDS))
                    .as("and at the others")
                    .isTrue();
        } finally {
            watchman.stop();
        }
    }
}
