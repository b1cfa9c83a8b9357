package org.dronemap.store.postgres;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.dronemap.store.StoreException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class DatabaseSettingsTest {
    @Test
    void takesAJdbcUrlAsItIs() {
        DatabaseSettings settings = DatabaseSettings.of(" jdbc:postgresql://db:5432/drones?user=u&password=p ");
        assertThat(settings.jdbcUrl()).isEqualTo("jdbc:postgresql://db:5432/drones?user=u&password=p");
        assertThat(settings.user()).isNull();
        assertThat(settings).hasToString("jdbc:postgresql://db:5432/drones?user=u&password=***");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "postgresql://an%40u:p+%2F%3Aw@db/drones?sslmode=require",
                "postgres://an%40u:p+%2F%3Aw@db/drones?sslmode=require",
                "jdbc:postgresql://an%40u:p+%2F%3Aw@db/drones?sslmode=require"
            })
    void splitsUserAndPasswordOffAUri(String url) {
        DatabaseSettings settings = DatabaseSettings.of(url);
        assertThat(settings.jdbcUrl()).isEqualTo("jdbc:postgresql://db/drones?sslmode=require");
        assertThat(settings.user()).isEqualTo("an@u");
        assertThat(settings.password()).isEqualTo("p+/:w");
        assertThat(settings).hasToString("jdbc:postgresql://db/drones?sslmode=require");
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "mysql://u:secret@db/x", "postgresql://u:secret@db", "postgresql://u:secret @db/x"})
    void refusesAnythingElseWithoutRepeatingIt(String url) {
        assertThatThrownBy(() -> DatabaseSettings.of(url))
                .isInstanceOf(StoreException.class)
                .hasMessageContaining("postgresql://user:password@host:5432/name")
                .hasMessageNotContaining("secret");
    }
}
