package org.dronemap.store.postgres;

import java.time.DateTimeException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.dronemap.store.StoreException;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.SerializationFeature;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * The manifest of a backup: schema version, time and tables with their checksums.
 *
 * @param schemaVersion the migration that the tables were at
 * @param tables in an order in which they can be filled
 */
record BackupManifest(String schemaVersion, Instant createdAt, List<Table> tables) {
    static final String ENTRY = "manifest.json";

    /** The layout of the zip file itself. */
    private static final int FORMAT = 1;

    private static final Pattern NAME = Pattern.compile("[a-z_][a-z0-9_]{0,62}");
    private static final Pattern VERSION = Pattern.compile("[0-9]{1,9}(\\.[0-9]{1,9})*");
    private static final JsonMapper MAPPER =
            JsonMapper.builder().enable(SerializationFeature.INDENT_OUTPUT).build();

    BackupManifest {
        tables = List.copyOf(tables);
    }

    /** One table as a CSV file with a header line; the checksum is of the file. */
    record Table(String name, List<String> columns, long rows, String sha256) {
        Table {
            columns = List.copyOf(columns);
        }

        String entry() {
            return entry(name);
        }

        static String entry(String table) {
            return table + ".csv";
        }
    }

    long rows() {
        return tables.stream().mapToLong(Table::rows).sum();
    }

    byte[] json() {
        ObjectNode root = MAPPER.createObjectNode();
        root.put("product", "dronemap");
        root.put("format", FORMAT);
        root.put("schemaVersion", schemaVersion);
        root.put("createdAt", createdAt.toString());
        ArrayNode list = root.putArray("tables");
        for (Table table : tables) {
            ObjectNode node = list.addObject();
            node.put("name", table.name());
            ArrayNode columns = node.putArray("columns");
            table.columns().forEach(columns::add);
            node.put("rows", table.rows());
            node.put("sha256", table.sha256());
        }
        return MAPPER.writeValueAsBytes(root);
    }

    static BackupManifest read(byte[] json) {
        try {
            JsonNode root = MAPPER.readTree(json);
            int format = root.required("format").intValue();
            if (format != FORMAT) {
                throw new StoreException("This backup has format " + format + ", and this Dronemap reads format "
                        + FORMAT + "; restore it with the Dronemap that made it, or a newer one.");
            }
            List<Table> tables = new ArrayList<>();
            for (JsonNode node : root.required("tables")) {
                tables.add(table(node));
            }
            return new BackupManifest(
                    checked(VERSION, root.required("schemaVersion").stringValue()),
                    Instant.parse(root.required("createdAt").stringValue()),
                    tables);
        } catch (JacksonException | DateTimeException e) {
            throw new StoreException("The manifest of this backup is damaged: " + e.getMessage(), e);
        }
    }

    private static Table table(JsonNode node) {
        List<String> columns = new ArrayList<>();
        for (JsonNode column : node.required("columns")) {
            columns.add(checked(NAME, column.stringValue()));
        }
        return new Table(
                checked(NAME, node.required("name").stringValue()),
                columns,
                node.required("rows").longValue(),
                node.required("sha256").stringValue());
    }

    /** These become part of SQL, so nothing but a plain name passes. */
    private static String checked(Pattern form, String value) {
        if (!form.matcher(value).matches()) {
            throw new StoreException("The manifest of this backup is damaged: \"" + value + "\" is not a name.");
        }
        return value;
    }
}
