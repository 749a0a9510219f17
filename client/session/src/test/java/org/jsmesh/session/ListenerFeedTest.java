package org.jsmesh.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.Queue;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.junit.jupiter.api.Test;

class ListenerFeedTest {
    private final Queue<Runnable> tasks = new ArrayDeque<>();
    private final Recording heard = new Recording();
    private final ListenerFeed feed = new ListenerFeed(heard, tasks::add);

    private void runAll() {
        while (!tasks.isEmpty()) tasks.remove().run();
    }

    private static Mesh faces(int count) {
        return new MeshBuilder()
                .positions(new float[9])
                .faceWedges(new int[3 * count])
                .build();
    }

    private static SessionProgress bytes(long count) {
        return new SessionProgress(count, 100, 0, 10, 0, 10, 0, 0, 0);
    }

    @Test
    void shouldGiveABusyListenerOnlyTheLatest() {
        for (int i = 1; i <= 5; i++) {
            feed.progressed(bytes(i));
            feed.refined(faces(i), bytes(i));
        }
        runAll();
        assertThat(heard.progress).containsExactly(bytes(5));
        assertThat(heard.facesShown).containsExactly(5);
    }

    @Test
    void shouldGiveAReadyListenerEverything() {
        for (int i = 1; i <= 5; i++) {
            feed.refined(faces(i), bytes(i));
            runAll();
        }
        assertThat(heard.facesShown).containsExactly(1, 2, 3, 4, 5);
    }

    @Test
    void shouldKeepEventsBehindTheMeshesBeforeThem() {
        feed.refined(faces(1), bytes(1));
        feed.call(listener -> listener.failed(new java.io.IOException("x")));
        runAll();
        assertThat(heard.events).containsExactly("base", "failed");
    }
}
