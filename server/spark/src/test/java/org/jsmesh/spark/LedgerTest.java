package org.jsmesh.spark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
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
        ledger.commit(summary(), List.of(first), ledger.start(), "a");
        ledger.writePart("b", 0, List.of(RowParquetTest.encoded("z")));
        ledger.writeJournal(Ledger.attempt("b", 0, 7) + "0.json", List.of(RowParquetTest.failed("y")));
        Losses.begin(ledger, Ledger.bin("b", 0), "y");
        // A run that is broken off here is known to the next.
        Ledger.Start before = ledger.start();
        assertThat(before.parts()).containsExactly(first, "journal/b/bin-000000-7-0.json");
        assertThat(before.openRuns()).containsExactly("b");
        ledger.writeJournal(Ledger.attempt("c", 0, 8) + "0.json", List.of(RowParquetTest.failed("y")));
        Losses.begin(ledger, Ledger.bin("c", 0), "y");
        String second = ledger.writePart("c", 0, List.of(RowParquetTest.failed("y")));
        ledger.commit(summary(), List.of(second), before, "c");
        assertThat(ledger.start().parts()).containsExactly(second);
        assertThat(files()).containsExactlyInAnyOrder("summary.json", second, second.replace("parquet", "json"));
    }

    @Test
    void shouldLeaveAloneWhatARunWritesThatGoesOn() throws IOException {
        Ledger ledger = new Ledger(new FolderObjectStore(folder));
        Ledger.Start before = ledger.start();
        Ledger.Start other = ledger.start();
        String journal = Ledger.attempt("b", 0, 7) + "0.json";
        ledger.writeJournal(journal, List.of(RowParquetTest.failed("y")));
        String part = ledger.writePart("b", 0, List.of(RowParquetTest.failed("y")));
        assertThat(ledger.hasChangedSince(other)).isFalse();
        ledger.commit(summary(), List.of(), before, "a");
        assertThat(files()).containsExactlyInAnyOrder("summary.json", journal, part, part.replace("parquet", "json"));
        assertThat(ledger.hasChangedSince(other)).isTrue();
        assertThatThrownBy(() -> ledger.commit(summary(), List.of(part), other, "b"))
                .isInstanceOf(ObjectConflictException.class);
        assertThat(ledger.start().openRuns()).containsExactly("b");
    }

    private List<String> files() throws IOException {
        List<String> keys = new ArrayList<>();
        new FolderObjectStore(folder).list("", "", object -> keys.add(object.key()));
        return keys;
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
