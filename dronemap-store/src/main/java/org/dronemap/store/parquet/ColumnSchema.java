package org.dronemap.store.parquet;

import java.util.ArrayList;
import java.util.List;
import org.apache.parquet.format.ConvertedType;
import org.apache.parquet.format.FieldRepetitionType;
import org.apache.parquet.format.LogicalType;
import org.apache.parquet.format.MicroSeconds;
import org.apache.parquet.format.SchemaElement;
import org.apache.parquet.format.StringType;
import org.apache.parquet.format.TimeUnit;
import org.apache.parquet.format.TimestampType;
import org.apache.parquet.format.Type;
import org.dronemap.core.history.TelemetryColumn;

/** Declares the telemetry columns in the footer of an exported Parquet file. */
final class ColumnSchema {
    private static final String ROOT = "telemetry";

    private ColumnSchema() {}

    static Type type(TelemetryColumn column) {
        return switch (column.kind()) {
            case TEXT -> Type.BYTE_ARRAY;
            case TIME -> Type.INT64;
            case FLOAT8 -> Type.DOUBLE;
            case FLOAT4 -> Type.FLOAT;
            case INTEGER -> Type.INT32;
            case TRUTH -> Type.BOOLEAN;
        };
    }

    /** The root, then the columns. */
    static List<SchemaElement> elements() {
        List<SchemaElement> elements = new ArrayList<>();
        elements.add(new SchemaElement(ROOT).setNum_children(TelemetryColumn.ALL.size()));
        for (TelemetryColumn column : TelemetryColumn.ALL) {
            elements.add(element(column));
        }
        return elements;
    }

    private static SchemaElement element(TelemetryColumn column) {
        SchemaElement element = new SchemaElement(column.label())
                .setType(type(column))
                .setRepetition_type(column.required() ? FieldRepetitionType.REQUIRED : FieldRepetitionType.OPTIONAL);
        // Twice: older readers know the second alone.
        return switch (column.kind()) {
            case TEXT ->
                element.setLogicalType(LogicalType.STRING(new StringType())).setConverted_type(ConvertedType.UTF8);
            case TIME ->
                element.setLogicalType(
                                LogicalType.TIMESTAMP(new TimestampType(true, TimeUnit.MICROS(new MicroSeconds()))))
                        .setConverted_type(ConvertedType.TIMESTAMP_MICROS);
            default -> element;
        };
    }
}
