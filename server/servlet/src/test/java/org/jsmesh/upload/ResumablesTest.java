package org.jsmesh.upload;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import org.junit.jupiter.api.Test;

/** Models that come in parts, on a disk that has an end. */
class ResumablesTest extends UploadQueueFixture {
    private Resumable begin(String id, long length) throws Exception {
        return queue.resumables().begin(SENDER, id, "ply", length, "");
    }

    @Test
    void shouldPromiseNoMoreThanTheDiskHas() throws Exception {
        open(copying());
        long most = Files.getFileStore(folder).getTotalSpace();
        assertThatThrownBy(() -> begin("larger", most + 1))
                .isInstanceOf(Upload.SpoolException.class)
                .rootCause()
                .hasMessageMatching("unfinished uploads need " + (most + 1) + " bytes, and \\d+ are free");
        assertThat(spool()).isEmpty();
        assertThat(begin("small", 100)).isNotNull();
    }

    @Test
    void shouldCountWhatIsPromisedToOthers() throws Exception {
        open(copying());
        long most = Files.getFileStore(folder).getUsableSpace();
        Resumable first = begin("first", most / 5 * 3);
        assertThat(first).isNotNull();
        assertThatThrownBy(() -> begin("second", most / 5 * 3)).isInstanceOf(Upload.SpoolException.class);
        assertThat(first.begin()).isTrue();
        queue.resumables().remove(first);
        first.end();
        assertThat(begin("second", most / 5 * 3)).isNotNull();
    }
}
