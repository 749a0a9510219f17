package org.jsmesh.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.ProgressListener;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

class MeshFeedTest {
    private static final int PORTION = 997;
    private static EncodedArchive encoded;

    private final List<MeshStep> steps = new ArrayList<>();
    private final List<Mesh> meshes = new ArrayList<>();
    private boolean isLive = true;
    private boolean isQuick = true;

    private final SessionListener listener = new SessionListener() {
        @Override
        public boolean isLive() {
            return isLive;
        }

        @Override
        public void stepped(MeshStep step) {
            steps.add(step);
            if (isQuick) step.taken().run();
        }

        @Override
        public void refined(Mesh mesh, SessionProgress progress) {
            meshes.add(mesh);
        }
    };

    @BeforeAll
    static void encode() {
        encoded = new MeshEncoder(EncoderSettings.defaults())
                .encode(RealArchiveTest.torus(40, 50), ProgressListener.NONE);
    }

    private void stream() throws Exception {
        byte[] bytes = encoded.bytes();
        DecodedArchive stream = new DecodedArchive();
        LiveFollower follower = isLive ? stream.follow() : null;
        ReceivedArchive archive = new ReceivedArchive("torus.jsm", stream, null);
        MeshFeed feed =
                new MeshFeed(archive, new ListenerFeed(listener, Runnable::run), follower, new SteadyClock(), 0);
        for (int at = 0; at < bytes.length; at += PORTION) {
            archive.take(bytes, at, Math.min(PORTION, bytes.length - at));
            feed.arrived(SessionProgress.of(archive, 0));
        }
        feed.show(SessionProgress.of(archive, 0));
    }

    @Test
    void shouldGiveEveryStepToAListenerThatFollows() throws Exception {
        stream();
        assertThat(meshes).isEmpty();
        assertThat(steps).hasSizeGreaterThan(3);
        for (int i = 0; i < steps.size(); i++) {
            assertThat(steps.get(i).live().number()).isEqualTo(i + 1);
            assertThat(steps.get(i).isLast()).isEqualTo(i == steps.size() - 1);
        }
        assertThat(steps.get(steps.size() - 1).live().faces())
                .isEqualTo(encoded.header().faces());
    }

    @Test
    void shouldTellInWhichLevelEachFaceCame() throws Exception {
        stream();
        int[] faces = new int[encoded.header().levels().size() + 1];
        for (MeshStep step : steps) for (byte level : step.newLevels()) faces[level]++;
        BatchIndex index = encoded.header().batches();
        int sum = 0;
        for (int level = 0; level < faces.length; level++) {
            sum += faces[level];
            int last = -1;
            for (int b = 0; b < index.size(); b++) if (index.level(b) <= level && index.faces(b) > 0) last = b;
            assertThat(sum).as("level %d", level).isEqualTo(index.faces(last));
        }
    }

    @Test
    void shouldWaitForAListenerThatHasNotTakenTheStepBefore() throws Exception {
        isQuick = false;
        stream();
        assertThat(steps).hasSize(2);
        assertThat(steps.get(1).isLast()).isTrue();
    }

    @Test
    void shouldGiveWholeMeshesToOthers() throws Exception {
        isLive = false;
        stream();
        assertThat(steps).isEmpty();
        assertThat(meshes).isNotEmpty();
    }
}
