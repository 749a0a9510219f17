package org.jsmesh.spark;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import org.jsmesh.objects.FolderObjectStore;
import org.jsmesh.site.CatalogueRow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import scala.Tuple2;

class CatalogueChangesTest {
    @TempDir
    private Path folder;

    private static Row encoded(String id, String run) {
        return of(RowParquetTest.encoded(id), run, "{\"run\":\"" + run + "\"}");
    }

    private static Row failed(String id, String run) {
        return of(RowParquetTest.failed(id), run, "");
    }

    private static Row of(Row row, String run, String entry) {
        Row.Stamp stamp = new Row.Stamp(run, "settings", 7);
        return new Row(row.id(), row.file(), stamp, "", "", row.facts(), row.failure(), "", entry);
    }

    @Test
    void shouldPublishWhatIsInNoCatalogueYet() throws IOException {
        Ledger ledger = new Ledger(new FolderObjectStore(folder));
        List<Row> rows = List.of(
                encoded("a-old", "1"),
                encoded("b-broken-off", "2"),
                encoded("c-new", "3"),
                failed("d-never-encoded", "3"),
                // The catalogue may have another archive of it by now, or none.
                encoded("e-old", "1").then(failed("e-old", "3")),
                encoded("f-old", "1").then(failed("f-old", "2")),
                encoded("g-broken-off", "2").then(failed("g-broken-off", "3")),
                encoded("h-broken-off", "2").then(failed("h-broken-off", "2")));
        String part = ledger.writePart("3", 0, rows);
        List<CatalogueRow> changes = new ArrayList<>();
        new CatalogueChanges(ledger, List.of(part), Set.of("a-gone", "z-gone"), Set.of("2", "3")).forEach(changes::add);
        assertThat(changes)
                .containsExactly(
                        CatalogueRow.removal("a-gone"),
                        new CatalogueRow("b-broken-off", "{\"run\":\"2\"}"),
                        new CatalogueRow("c-new", "{\"run\":\"3\"}"),
                        new CatalogueRow("g-broken-off", "{\"run\":\"2\"}"),
                        new CatalogueRow("h-broken-off", "{\"run\":\"2\"}"),
                        CatalogueRow.removal("z-gone"));
    }

    @Test
    void shouldRememberTheEntryWhenJournalsTellOfFailures() {
        List<Row> rows =
                List.of(encoded("a", "1"), failed("a", "2"), encoded("a", "3"), failed("a", "4"), failed("a", "5"));
        assertThat(last(rows, 0, 1)).isEqualTo(rows.get(0).then(rows.get(1)));
        assertThat(last(rows, 2, 1, 0)).isEqualTo(rows.get(2));
        Row row = last(rows, 3, 0, 2, 4, 1);
        assertThat(List.of(row.stamp().run(), row.entryRun(), row.entry()))
                .containsExactly("5", "3", "{\"run\":\"3\"}");
        assertThat(row.failure()).isEqualTo(rows.get(4).failure());
    }

    private static Row last(List<Row> rows, int... order) {
        return Stages.last(
                IntStream.of(order).mapToObj(i -> new Tuple2<>(i, rows.get(i))).toList());
    }
}
