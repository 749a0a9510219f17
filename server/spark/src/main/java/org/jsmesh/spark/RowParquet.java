package org.jsmesh.spark;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.Iterator;
import java.util.function.Consumer;
import org.apache.hadoop.conf.Configuration;
import org.apache.parquet.example.data.Group;
import org.apache.parquet.example.data.simple.SimpleGroup;
import org.apache.parquet.hadoop.ParquetReader;
import org.apache.parquet.hadoop.ParquetWriter;
import org.apache.parquet.hadoop.api.ReadSupport;
import org.apache.parquet.hadoop.example.ExampleParquetWriter;
import org.apache.parquet.hadoop.example.GroupReadSupport;
import org.apache.parquet.hadoop.metadata.CompressionCodecName;
import org.apache.parquet.io.InputFile;
import org.apache.parquet.schema.LogicalTypeAnnotation;
import org.apache.parquet.schema.MessageType;
import org.apache.parquet.schema.PrimitiveType.PrimitiveTypeName;
import org.apache.parquet.schema.Type;
import org.apache.parquet.schema.Types;

/** Rows of a report as Parquet, in memory: what stores them needs no file system of Hadoop's. */
final class RowParquet {
    private static final ObjectMapper JSON = new ObjectMapper();
    private static final String[] TEXTS = {
        "id",
        "state",
        "input",
        "store",
        "key",
        "place",
        "inputTag",
        "run",
        "settings",
        "output",
        "archiveSha256",
        "errorPlace",
        "errorReason",
        "errorRemedy",
        "errorKind",
        "notes",
        "companions",
        "annotations",
        "entry",
        "entryRun"
    };
    private static final String[] INTS = {"encoderVersion", "faces", "vertices", "baseFaces", "batches"};
    private static final String[] LONGS = {"inputBytes", "bytes"};
    private static final String[] DOUBLES = {"encodeSeconds"};
    private static final MessageType SCHEMA = schema();

    private RowParquet() {}

    private static MessageType schema() {
        Types.MessageTypeBuilder columns = Types.buildMessage();
        for (String name : TEXTS)
            columns.optional(PrimitiveTypeName.BINARY)
                    .as(LogicalTypeAnnotation.stringType())
                    .named(name);
        for (String name : INTS) columns.optional(PrimitiveTypeName.INT32).named(name);
        for (String name : LONGS) columns.optional(PrimitiveTypeName.INT64).named(name);
        for (String name : DOUBLES) columns.optional(PrimitiveTypeName.DOUBLE).named(name);
        return columns.named("model");
    }

    /** {@return a whole Parquet file} */
    static byte[] write(Iterator<Row> rows) throws IOException {
        MemoryParquet file = new MemoryParquet();
        try (ParquetWriter<Group> writer = ExampleParquetWriter.builder(file)
                .withConf(new Configuration(false))
                .withType(SCHEMA)
                .withCompressionCodec(CompressionCodecName.SNAPPY)
                .build()) {
            while (rows.hasNext()) writer.write(group(rows.next().toJson()));
        }
        return file.bytes();
    }

    private static Group group(ObjectNode row) {
        Group group = new SimpleGroup(SCHEMA);
        for (Type column : SCHEMA.getFields()) {
            String name = column.getName();
            JsonNode value = row.path(name);
            if (value.isMissingNode() || value.isNull()) continue;
            switch (column.asPrimitiveType().getPrimitiveTypeName()) {
                case INT32 -> group.add(name, value.asInt());
                case INT64 -> group.add(name, value.asLong());
                case DOUBLE -> group.add(name, value.asDouble());
                default -> group.add(name, value.asText());
            }
        }
        return group;
    }

    /** Reads the rows of a whole Parquet file in their order. Columns of other versions are passed over. */
    static void read(byte[] content, Consumer<Row> rows) throws IOException {
        try (ParquetReader<Group> reader = new Builder(MemoryParquet.of(content)).build()) {
            for (Group group = reader.read(); group != null; group = reader.read())
                rows.accept(Row.fromJson(json(group)));
        }
    }

    private static ObjectNode json(Group group) {
        ObjectNode row = JSON.createObjectNode();
        for (Type column : SCHEMA.getFields()) {
            String name = column.getName();
            if (!group.getType().containsField(name) || group.getFieldRepetitionCount(name) == 0) continue;
            switch (column.asPrimitiveType().getPrimitiveTypeName()) {
                case INT32 -> row.put(name, group.getInteger(name, 0));
                case INT64 -> row.put(name, group.getLong(name, 0));
                case DOUBLE -> row.put(name, group.getDouble(name, 0));
                default -> row.put(name, group.getString(name, 0));
            }
        }
        return row;
    }

    private static final class Builder extends ParquetReader.Builder<Group> {
        Builder(InputFile file) {
            super(file);
            withConf(new Configuration(false));
        }

        @Override
        protected ReadSupport<Group> getReadSupport() {
            return new GroupReadSupport();
        }
    }
}
