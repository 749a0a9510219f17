package org.jsmesh.desktop;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CountDownLatch;
import java.util.stream.Stream;
import org.jsmesh.desktop.draw.Shapes;
import org.jsmesh.files.ModelFiles;
import org.jsmesh.mesh.io.ModelFormat;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.Test;

/** The end of the program, which lets what is under way come to its own. */
class BackgroundTest extends WindowFixture {
    @Test
    void shouldEndWhenTheLastWorkHasEnded() throws Exception {
        CountDownLatch saved = new CountDownLatch(1);
        on(() -> {
            windows.background().run("test-save", () -> {
                try {
                    saved.await();
                } catch (InterruptedException e) {
                    throw new IllegalStateException(e);
                }
            });
            windows.closeAll();
            return null;
        });
        assertThat(on(() -> ended)).isFalse();
        saved.countDown();
        Await.until("the end", () -> ended);
    }

    @Test
    void shouldLeaveNoFolderOfAnEncodingThatIsGivenUp() throws Exception {
        Path model = folder.resolve("torus.ply");
        ModelFiles.write(Shapes.torus(300, 200), model, ModelFormat.PLY);
        String before = System.setProperty(
                "java.io.tmpdir", Files.createDirectory(folder.resolve("tmp")).toString());
        try {
            open(model.toString());
            await(ViewState.Phase.PREPARING);
            Await.until("a folder", () -> count() == 1);
            on(() -> {
                windows.closeAll();
                return null;
            });
            Await.until("the end", () -> ended);
            assertThat(count()).isZero();
        } finally {
            System.setProperty("java.io.tmpdir", before);
        }
    }

    private long count() throws Exception {
        try (Stream<Path> found = Files.list(folder.resolve("tmp"))) {
            return found.count();
        }
    }
}
