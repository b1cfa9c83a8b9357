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

/** What was owned by name belongs to ids after the migration, and of one name to the account that had it first. */
class AccountIdsTest {
    private static final String SCHEMA = "before_ids";
    private static final String BODY = "'{\"id\":\"%s\",\"owner\":\"%s\",\"createdAt\":\"%s\"}'";

    private final DataSource dataSource = SharedDatabase.empty().dataSource();
    private final Migration migration = new Migration(dataSource);

    @BeforeEach
    void older() throws SQLException {
        migration.to(SCHEMA, "21");
        for (String name : List.of("ann", "b_b", "bxb")) {
            execute("INSERT INTO account (name, role, state, password_hash, must_change_password) VALUES ('" + name
                    + "', 'OPERATOR', 'ACTIVE', 'x', false)");
        }
        removed(1, "b_b", "SUCCEEDED", "2026-03-01T00:00:00Z");
        removed(2, "ann", "REFUSED", "2026-03-01T00:00:00Z");
        owned("v1", "b_b", "2026-02-01T00:00:00Z");
        owned("v2", "b_b", "2026-04-01T00:00:00Z");
        owned("v3", "ann", "2026-04-01T00:00:00Z");
    }

    @AfterEach
    void close() throws SQLException {
        execute("DROP SCHEMA " + SCHEMA + " CASCADE");
    }

    private void removed(int number, String name, String outcome, String at) throws SQLException {
        execute("INSERT INTO audit (sequence, happened_at, face, operation, parameters, outcome, hash) VALUES ("
                + number + ", '" + at + "', 'rest', 'DELETE /api/v1/users/{name}', 'name=" + name + "', '" + outcome
                + "', 'x')");
    }

    private void owned(String id, String owner, String at) throws SQLException {
        execute("INSERT INTO virtual_drone (id, created_at, body) VALUES ('" + id + "', '" + at + "', "
                + String.format(BODY, id, owner, at) + ")");
        execute("INSERT INTO operation (id, kind, owner, name, began_at, last_entry, given, state) VALUES ('" + id
                + "', 'run', '" + owner + "', 'Roofs', '" + at + "', 0, '{}', '')");
    }

    @Test
    void aNameOfTwoAccountsGoesToTheOlderOneAndIsReported() throws SQLException {
        migration.toLatest(SCHEMA);

        String today = one("SELECT id FROM account WHERE name = 'b_b'");
        assertThat(today).startsWith("#");
        assertThat(texts("SELECT id FROM account WHERE name <> 'b_b' ORDER BY name"))
                .containsExactly("ann", "bxb");
        assertThat(texts("SELECT account FROM operation ORDER BY id")).containsExactly("b_b", today, "ann");
        assertThat(texts("SELECT coalesce(body ->> 'account', body ->> 'owner') FROM virtual_drone ORDER BY id"))
                .containsExactly("b_b", today, "ann");
        assertThat(texts("SELECT name FROM reused_name")).containsExactly("b_b");
    }

    @Test
    void aNewAccountHasAnIdThatIsNobodysName() throws SQLException {
        migration.toLatest(SCHEMA);
        execute("DELETE FROM account WHERE name = 'ann'");
        execute(
                "INSERT INTO account (name, role, state, password_hash, must_change_password) VALUES ('ann', 'OPERATOR',"
                        + " 'ACTIVE', 'x', false)");

        assertThat(one("SELECT id FROM account WHERE name = 'ann'")).startsWith("#");
    }

    private String one(String sql) throws SQLException {
        return texts(sql).get(0);
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
