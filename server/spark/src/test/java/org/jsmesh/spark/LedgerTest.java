package org.jsmesh.spark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.jsmesh.objects.FolderObjectStore;
import org.jsmesh.objects.ObjectConflictException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class LedgerTest {
    @TempDir
    private Path folder;

    private static ObjectNode summary() {
        return JsonNodeFactory.instance.objectNode();
    }

    @Test
    void shouldKeepThePartsOfTheLastRunAlone() throws IOException {
        Ledger ledger = new Ledger(new FolderObjectStore(folder));
        String first = ledger.writePart("a", 0, List.of(RowParquetTest.encoded("x")));
        ledger.commit(summary(), List.of(first), null);
        Ledger.Summary before = ledger.summary().orElseThrow();
        ledger.writeJournal(Ledger.journal("b", 0, 7), List.of(RowParquetTest.failed("y")));
        // A run that is broken off here is known to the next.
        assertThat(ledger.start().parts()).containsExactly(first, "journal/b/bin-000000-7.json");
        assertThat(ledger.start().openRuns()).containsExactly("b");
        String second = ledger.writePart("b", 0, List.of(RowParquetTest.failed("y")));
        ledger.commit(summary(), List.of(second), before);
        assertThat(ledger.start().parts()).containsExactly(second);
        assertThat(folder.resolve(first)).doesNotExist();
    }

    @Test
    void shouldNotReplaceTheReportOfARunThatHasEndedMeanwhile() throws IOException {
        Ledger ledger = new Ledger(new FolderObjectStore(folder));
        ledger.commit(summary(), List.of(), null);
        assertThatThrownBy(() -> ledger.commit(summary(), List.of(), null)).isInstanceOf(ObjectConflictException.class);
    }

    @Test
    void shouldCountLossesAtTheSameModel() throws IOException {
        Ledger ledger = new Ledger(new FolderObjectStore(folder));
        String journal = Ledger.bin("a", 3);
        assertThat(Losses.begin(ledger, journal, "x").count()).isZero();
        assertThat(Losses.begin(ledger, journal, "x").count()).isEqualTo(1);
        assertThat(Losses.begin(ledger, journal, "x").count()).isEqualTo(2);
        assertThat(Losses.begin(ledger, journal, "y").count()).isZero();
        assertThat(Losses.begin(ledger, journal, "x").count()).isZero();
        Losses.end(ledger, journal);
        assertThat(Losses.begin(ledger, journal, "x").count()).isZero();
    }
}
