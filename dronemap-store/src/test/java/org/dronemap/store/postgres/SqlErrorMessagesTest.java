package org.dronemap.store.postgres;

import static org.assertj.core.api.Assertions.assertThat;

import java.sql.SQLException;
import java.sql.SQLTransientConnectionException;
import org.dronemap.store.StoreException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What an error of the database means for whoever asked. */
class SqlErrorMessagesTest {
    @ParameterizedTest
    @CsvSource({
        "53100, true, disk of the database is full",
        "57P03, true, cannot be reached",
        "08006, true, cannot be reached",
        "53300, true, cannot be reached",
        "23505, false, refused",
        "42501, false, lacks a right"
    })
    void tellsWhatPassesFromWhatDoesNot(String state, boolean passing, String sentence) {
        StoreException told = SqlErrorMessages.exception(new SQLException("so it is", state));

        assertThat(told.isTransient()).isEqualTo(passing);
        assertThat(told).hasMessageContaining(sentence).hasMessageContaining("so it is");
    }

    @Test
    void seesThroughThePoolThatGaveUpWaiting() {
        SQLException pool = new SQLTransientConnectionException("request timed out", new SQLException("away", "08001"));

        assertThat(SqlErrorMessages.exception(pool).isTransient()).isTrue();
    }
}
