package org.dronemap.ws.audit;

import java.io.IOException;
import java.io.Writer;
import java.util.Arrays;
import java.util.stream.Collectors;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.JsonCodec;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/** File formats in which audit records are exported: CSV, or JSON Lines with one record on each line. */
enum AuditExportFormat {
    CSV("text/csv"),
    JSONL("application/jsonl");

    private static final String HEADER =
            "sequence,at,by,accessKey,face,operation,drone,epoch,command,parameters,outcome,"
                    + "reason,latencyMillis,hash";

    private final String mediaType;

    AuditExportFormat(String mediaType) {
        this.mediaType = mediaType;
    }

    public static AuditExportFormat named(String form) {
        return Arrays.stream(values())
                .filter(one -> WireNames.camel(one).equals(form))
                .findFirst()
                .orElseThrow(() -> InvalidInput.outside(
                        ValueProblem.VALUE_NOT_ALLOWED, "form", "csv or jsonl", "\"" + form + "\""));
    }

    public String mediaType() {
        return mediaType;
    }

    public String fileName() {
        return "activity." + WireNames.camel(this);
    }

    public void begin(Writer out) throws IOException {
        if (this == CSV) {
            out.write(HEADER + "\r\n");
        }
    }

    public void write(AuditView record, JsonCodec json, Writer out) throws IOException {
        out.write(this == CSV ? row(record) + "\r\n" : json.write(record) + "\n");
    }

    private static String row(AuditView record) {
        return Arrays.asList(
                        record.sequence(),
                        record.at(),
                        record.by(),
                        record.accessKey(),
                        record.face(),
                        record.operation(),
                        record.drone(),
                        record.epoch(),
                        record.command(),
                        record.parameters(),
                        record.outcome(),
                        record.reason(),
                        record.latencyMillis(),
                        record.hash())
                .stream()
                .map(AuditExportFormat::cell)
                .collect(Collectors.joining(","));
    }

    /** Nothing that a spreadsheet would take for a formula. */
    private static String cell(@Nullable Object value) {
        if (value == null) {
            return "";
        }
        String text = value.toString();
        boolean formula = !(value instanceof Number) && text.matches("(?s)[=+@\\t\\r-].*");
        return "\"" + (formula ? "'" : "") + text.replace("\"", "\"\"") + "\"";
    }
}
