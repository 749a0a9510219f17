package org.jsmesh.desktop;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.BatchIndexBuilder;
import org.jsmesh.archive.BatchKind;
import org.jsmesh.archive.Provenance;
import org.jsmesh.desktop.draw.Framing;
import org.jsmesh.desktop.draw.Scene;
import org.jsmesh.desktop.draw.Shapes;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.session.RoundReport;
import org.jsmesh.session.SessionProgress;
import org.jsmesh.session.SessionResult;
import org.junit.jupiter.api.Test;

class SessionViewTest {
    private static final Mesh MESH = Shapes.torus(6, 4);
    private static final RoundReport ROUND = new RoundReport(2000, 2000, 500, 500, 250, 1, 48, .5);

    private final List<ViewState> states = new ArrayList<>();
    private final List<Scene> scenes = new ArrayList<>();
    private Framing framing;
    private final SessionView view = new SessionView(
            new SessionView.Display() {
                @Override
                public void frame(Framing next) {
                    framing = next;
                }

                @Override
                public void show(Scene scene) {
                    scenes.add(scene);
                }

                @Override
                public void show(ViewState state) {
                    states.add(state);
                }
            },
            "torus.jsm");

    @Test
    void shouldFrameTheOriginalAndShowEachResolution() {
        view.requested();
        assertThat(last().phase()).isEqualTo(ViewState.Phase.LOADING);
        view.opened(header());
        assertThat(framing).isEqualTo(Framing.of(new float[] {0, 0, 0, 1, 2, 3}, UpAxis.UNKNOWN));
        view.progressed(progress(0));
        assertThat(last().phase()).isEqualTo(ViewState.Phase.LOADING);
        view.progressed(progress(1));
        view.refined(MESH, progress(1));
        assertThat(last().phase()).isEqualTo(ViewState.Phase.REFINING);
        assertThat(last().levels()).isEqualTo(2);
        assertThat(scenes).hasSize(1);
        assertThat(scenes.get(0).mesh().faces()).isEqualTo(48);
    }

    @Test
    void shouldDrawCreasesOfModelsWithoutNormals() {
        view.opened(header());
        view.refined(Shapes.cube(), progress(1));
        view.completed(new SessionResult(Shapes.cube(), "aa", "aa", null));
        assertThat(scenes).extracting(scene -> scene.mesh().vertices()).containsExactly(24, 24);
    }

    @Test
    void shouldStayReadyWhenBytesArriveAfterTheRound() {
        view.requested();
        view.opened(header());
        view.progressed(progress(1));
        view.roundEnded(ROUND);
        assertThat(last().canRefine()).isTrue();
        view.progressed(progress(2));
        assertThat(last().phase()).isEqualTo(ViewState.Phase.IDLE);
        view.requested();
        assertThat(last().phase()).isEqualTo(ViewState.Phase.REFINING);
        assertThat(last().canRefine()).isFalse();
    }

    @Test
    void shouldTellOfALostConnectionUntilSomethingComes() {
        view.requested();
        view.opened(header());
        view.progressed(progress(1));
        view.retrying(new IOException("Connection reset"), 2, 2000);
        assertThat(last().phase()).isEqualTo(ViewState.Phase.RETRYING);
        assertThat(last().message())
                .isEqualTo("The connection was lost: Connection reset. Attempt 2 follows in 2 s."
                        + " What has arrived is kept.");
        assertThat(last().canRefine()).isFalse();
        assertThat(last().isBusy()).isTrue();
        view.progressed(progress(1));
        assertThat(last().phase()).isEqualTo(ViewState.Phase.RETRYING);
        view.progressed(new SessionProgress(600, 1000, 2, 3, 48, 96, 1, .5, 250));
        assertThat(last().phase()).isEqualTo(ViewState.Phase.REFINING);
        assertThat(last().message()).isNull();
        view.retrying(new IOException(), 3, -1);
        assertThat(last().message()).contains("IOException", "ask again");
        view.roundEnded(ROUND);
        assertThat(last().canRefine()).isTrue();
    }

    @Test
    void shouldTellHowFarTheServerIsWithAModel() {
        view.requested();
        view.preparing("collapse", .4);
        assertThat(last().phase()).isEqualTo(ViewState.Phase.PREPARING);
        assertThat(last().prepared()).isEqualTo(.4);
        assertThat(last().message()).isEqualTo("The server prepares the model: collapse, 40%.");
        view.opened(header());
        assertThat(last().phase()).isEqualTo(ViewState.Phase.LOADING);
        assertThat(last().message()).isNull();
        view.stopped();
        assertThat(last().canRefine()).isTrue();
    }

    @Test
    void shouldCallTheMeshIdenticalOnlyWhenItIs() {
        view.opened(header());
        view.progressed(progress(3));
        view.roundEnded(ROUND);
        assertThat(last().phase()).isEqualTo(ViewState.Phase.CHECKING);
        assertThat(last().canRefine()).isFalse();
        view.completed(new SessionResult(MESH, "aa", "bb", null));
        view.requested();
        assertThat(last().phase()).isEqualTo(ViewState.Phase.IDENTICAL);
        assertThat(last().canRefine()).isFalse();
        view.completed(new SessionResult(MESH, "aa", "bb", "the mesh's hash is not the header's"));
        assertThat(last().phase()).isEqualTo(ViewState.Phase.DIFFERENT);
        assertThat(last().message()).isEqualTo("the mesh's hash is not the header's");
    }

    @Test
    void shouldSayBesideIdenticalWhatOfTheFileIsNotKept() {
        view.opened(header(Note.dropped("3 group names not kept.", 3, "wheel")));
        view.completed(new SessionResult(MESH, "aa", "bb", null));
        assertThat(last().phase()).isEqualTo(ViewState.Phase.IDENTICAL);
        assertThat(last().message()).isEqualTo("Of the file not kept: 3 group names.");
    }

    @Test
    void shouldNotCallIdenticalWhatLacksSomethingThatIsSeen() {
        view.opened(header(Note.dropped("124 parts missing.", 124, "").asWarning()));
        view.completed(new SessionResult(MESH, "aa", "bb", null));
        assertThat(last().phase()).isEqualTo(ViewState.Phase.INCOMPLETE);
        assertThat(last().message()).isEqualTo("Not the whole original: 124 parts missing.");
        assertThat(last().canRefine()).isFalse();
        view.requested();
        assertThat(last().phase()).isEqualTo(ViewState.Phase.INCOMPLETE);
    }

    @Test
    void shouldSayWhatIsWrongWhereAndWhatToDo() {
        view.failed(new MalformedStreamException(0, "no magic number"));
        assertThat(last().phase()).isEqualTo(ViewState.Phase.ERROR);
        assertThat(last().message())
                .startsWith("torus.jsm: no magic number (byte 0); ")
                .contains("jsm encode");
        view.broken(new OutOfMemoryError());
        assertThat(last().message()).contains("torus.jsm", "-Xmx");
        view.broken(new IllegalStateException());
        assertThat(last().message()).contains("IllegalStateException");
    }

    @Test
    void shouldKeepAnErrorUntilSomethingIsAskedFor() {
        view.opened(header());
        view.progressed(progress(3));
        view.broken(new OutOfMemoryError());
        view.roundEnded(ROUND);
        assertThat(last().phase()).isEqualTo(ViewState.Phase.ERROR);
    }

    @Test
    void shouldTellTheOutcomeAgainAfterAnError() {
        view.opened(header());
        view.progressed(progress(1));
        view.completed(new SessionResult(MESH, "aa", "bb", null));
        view.broken(new IllegalStateException());
        view.ended();
        assertThat(last().phase()).isEqualTo(ViewState.Phase.ERROR);
        view.requested();
        assertThat(last().phase()).isEqualTo(ViewState.Phase.REFINING);
        view.ended();
        assertThat(last().phase()).isEqualTo(ViewState.Phase.IDENTICAL);
        int said = states.size();
        // The window says that it refines before it asks.
        view.requested();
        assertThat(states).hasSize(said + 1);
        assertThat(last().phase()).isEqualTo(ViewState.Phase.IDENTICAL);
    }

    private ViewState last() {
        return states.get(states.size() - 1);
    }

    private static SessionProgress progress(int batches) {
        return new SessionProgress(500, 1000, batches, 3, 48, 96, batches, .5, 250);
    }

    private static ArchiveHeader header(Note... notes) {
        List<ArchiveHeader.Level> levels =
                List.of(new ArchiveHeader.Level(1, 48, .5), new ArchiveHeader.Level(.1, 96, 0));
        return new ArchiveHeader(
                96,
                48,
                48,
                List.of(),
                List.of(),
                List.of(),
                List.of(),
                new double[3],
                new float[] {0, 0, 0, 1, 2, 3},
                UpAxis.UNKNOWN,
                false,
                levels,
                "aa",
                new Provenance("OBJ", List.of(notes)),
                new BatchIndexBuilder().add(BatchKind.BASE, 1000, 0).build());
    }
}
