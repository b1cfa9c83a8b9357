package org.dronemap.store.postgres;

import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Lists the tables for a backup from the database's own catalogue, so that none of a new migration is forgotten. */
final class TableCatalog {
    /**
     * The history comes back with the schema, an old session must not come back to life, and what is restored is another
     * series of events.
     */
    private static final Set<String> LEFT_OUT = Set.of(Migration.HISTORY_TABLE, "sign_in", "event_series");

    private final Connection connection;
    private final String schema;

    TableCatalog(Connection connection, String schema) {
        this.connection = connection;
        this.schema = schema;
    }

    /** Tables with their columns, one that has parts as a whole; a table comes after those that it refers to. */
    Map<String, List<String>> tablesInOrder() throws SQLException {
        Map<String, List<String>> columns = new LinkedHashMap<>();
        pairs(
                """
                SELECT c.table_name, c.column_name FROM information_schema.columns c
                JOIN information_schema.tables t USING (table_schema, table_name)
                WHERE table_schema = ? AND t.table_type = 'BASE TABLE' AND c.is_generated = 'NEVER'
                AND NOT (SELECT relispartition FROM pg_class WHERE oid =
                    (quote_ident(table_schema) || '.' || quote_ident(c.table_name))::regclass)
                ORDER BY c.table_name, c.ordinal_position""",
                (table, column) -> columns.computeIfAbsent(table, name -> new ArrayList<>())
                        .add(column));
        columns.keySet().removeAll(LEFT_OUT);
        Map<String, Set<String>> references = new LinkedHashMap<>();
        pairs(
                """
                SELECT f.relname, t.relname FROM pg_constraint c
                JOIN pg_class f ON f.oid = c.conrelid JOIN pg_class t ON t.oid = c.confrelid
                JOIN pg_namespace n ON n.oid = c.connamespace
                WHERE c.contype = 'f' AND n.nspname = ? AND f.oid <> t.oid""",
                (from, to) -> references
                        .computeIfAbsent(from, name -> new LinkedHashSet<>())
                        .add(to));
        return ordered(columns, references);
    }

    private static Map<String, List<String>> ordered(
            Map<String, List<String>> columns, Map<String, Set<String>> references) throws SQLException {
        Map<String, List<String>> ordered = new LinkedHashMap<>();
        while (ordered.size() < columns.size()) {
            int before = ordered.size();
            columns.forEach((table, names) -> {
                if (ordered.keySet().containsAll(references.getOrDefault(table, Set.of()))) {
                    ordered.putIfAbsent(table, names);
                }
            });
            if (ordered.size() == before) {
                throw new SQLException("tables refer to each other in a circle");
            }
        }
        return ordered;
    }

    private interface TableReference {
        void of(String first, String second);
    }

    private void pairs(String sql, TableReference each) throws SQLException {
        try (PreparedStatement statement = connection.prepareStatement(sql)) {
            statement.setString(1, schema);
            try (ResultSet result = statement.executeQuery()) {
                while (result.next()) {
                    each.of(result.getString(1), result.getString(2));
                }
            }
        }
    }
}
