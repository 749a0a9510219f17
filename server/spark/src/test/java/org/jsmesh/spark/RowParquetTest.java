package org.jsmesh.spark;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class RowParquetTest {
    private static final Row.Stamp STAMP = new Row.Stamp("run", "settings", 7);

    static Row encoded(String id) {
        ListedModel file = new ListedModel("s3://b/p", "a/" + id + ".ply", id + ".ply", 1L << 33, "tag", Instant.EPOCH);
        Row.Facts facts = new Row.Facts("s3://b/site/m/x.jsm", "ab12", 10, 7, 2, 1L << 32, 3, .25);
        return new Row(id, file, STAMP, "[{\"asked\":\"ü\"}]", "", facts, null, "a\nb", "{\"id\":\"" + id + "\"}");
    }

    static Row failed(String id) {
        ListedModel file = new ListedModel("/folder", id + ".ply", id + ".ply", 5, "tag", Instant.EPOCH);
        Row.Failure failure = new Row.Failure("/folder/x.ply, line 3", "is cut", "Mend it", Row.Kind.MODEL);
        return new Row(id, file, STAMP, "", "other", null, failure, "", "");
    }

    @Test
    void shouldGiveBackRows() throws IOException {
        List<Row> rows = List.of(encoded("椅子"), failed("b"), encoded("c").then(failed("c")));
        List<Row> read = new ArrayList<>();
        RowParquet.read(RowParquet.write(rows.iterator()), read::add);
        assertThat(read).isEqualTo(rows);
    }

    @Test
    void shouldGiveBackManyRowsInTheirOrder() throws IOException {
        List<Row> rows = new ArrayList<>();
        for (int i = 0; i < 30_000; i++) rows.add(encoded("model-" + i));
        List<String> ids = new ArrayList<>();
        RowParquet.read(RowParquet.write(rows.iterator()), row -> ids.add(row.id()));
        assertThat(ids).isEqualTo(rows.stream().map(Row::id).toList());
    }

    @Test
    void shouldGiveBackRowsAsJson() {
        for (Row row : List.of(encoded("a"), failed("b"), encoded("c").then(failed("c"))))
            assertThat(Row.fromJson(row.toJson().toString())).isEqualTo(row);
    }
}
