package org.dronemap.store.postgres;

import static org.assertj.core.api.Assertions.assertThat;

import java.sql.Connection;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.ArrayList;
import java.util.List;
import javax.sql.DataSource;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Events of before keep their numbers after the migration, unless two have the same. */
class EventNumbersTest {
    private static final String SCHEMA = "before_numbers";

    private final DataSource dataSource = SharedDatabase.empty().dataSource();
    private final Migration migration = new Migration(dataSource);

    @BeforeEach
    void older() {
        migration.to(SCHEMA, "26");
    }

    @AfterEach
    void close() throws SQLException {
        execute("DROP SCHEMA " + SCHEMA + " CASCADE");
    }

    @Test
    void staysAsItIsWhereEachIsThereOnce() throws SQLException {
        happened(7, "2026-03-02T00:00:00Z", "b");
        happened(3, "2026-03-01T00:00:00Z", "a");

        migration.toLatest(SCHEMA);
        happenedNow("c");

        assertThat(texts("SELECT text || id FROM drone_event ORDER BY id")).containsExactly("a3", "b7", "c8");
    }

    @Test
    void becomesTheOrderOfTimeWhereARestoreHasBegunAnew() throws SQLException {
        happened(1, "2026-03-01T00:00:00Z", "a");
        happened(2, "2026-03-02T00:00:00Z", "b");
        happened(1, "2026-03-03T00:00:00Z", "c");

        migration.toLatest(SCHEMA);
        happenedNow("d");

        assertThat(texts("SELECT text || id FROM drone_event ORDER BY id")).containsExactly("a1", "b2", "c3", "d4");
    }

    @Test
    void beginsWhereThereAreNone() throws SQLException {
        migration.toLatest(SCHEMA);
        happenedNow("a");

        assertThat(texts("SELECT text || id FROM drone_event")).containsExactly("a1");
        assertThat(texts("SELECT id FROM event_series WHERE opened_at IS NULL AND expired = 0"))
                .hasSize(1);
    }

    private void happened(int number, String at, String text) throws SQLException {
        execute("INSERT INTO drone_event (id, drone_id, at, kind, text) VALUES (" + number + ", 'copter-1', '" + at
                + "', 'MODE', '" + text + "')");
    }

    private void happenedNow(String text) throws SQLException {
        execute("INSERT INTO drone_event (drone_id, at, kind, text) VALUES ('copter-1', now(), 'MODE', '" + text
                + "')");
    }

    private List<String> texts(String sql) throws SQLException {
        try (Connection connection = dataSource.getConnection();
                Statement statement = connection.createStatement()) {
            statement.execute("SET search_path TO " + SCHEMA);
            List<String> texts = new ArrayList<>();
            try (ResultSet rows = statement.executeQuery(sql)) {
                while (rows.next()) {
                    texts.add(rows.getString(1));
                }
            }
            statement.execute("RESET search_path");
            return texts;
        }
    }

    private void execute(String sql) throws SQLException {
        try (Connection connection = dataSource.getConnection();
                Statement statement = connection.createStatement()) {
            statement.execute("SET search_path TO " + SCHEMA);
            statement.execute(sql);
            statement.execute("RESET search_path");
        }
    }
}
