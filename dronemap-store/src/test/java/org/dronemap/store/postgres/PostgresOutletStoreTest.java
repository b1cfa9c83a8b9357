package org.dronemap.store.postgres;

import static org.assertj.core.api.Assertions.assertThat;

import java.sql.Connection;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.Base64;
import java.util.HexFormat;
import org.dronemap.core.access.OutletKey;
import org.dronemap.store.contract.OutletStoreContract;
import org.dronemap.store.secret.SecretBox;
import org.junit.jupiter.api.Test;

class PostgresOutletStoreTest extends OutletStoreContract {
    private final SecretBox box = new SecretBox(new byte[SecretBox.SECRET_BYTES]);
    private final PostgresStores database = SharedDatabase.empty();

    @Override
    protected Stores emptyStores() {
        return new Stores(database.access(), database.drones(), database.outlet(box));
    }

    @Test
    void noByteOfAKeyLiesReadableInTheDatabase() throws SQLException {
        database.outlet(box).saveKey(new OutletKey("ann", key(1), 5));
        try (Connection connection = database.dataSource().getConnection();
                Statement statement = connection.createStatement();
                ResultSet row = statement.executeQuery("SELECT sealed_key FROM outlet_key")) {
            assertThat(row.next()).isTrue();
            String sealed = HexFormat.of().formatHex(Base64.getDecoder().decode(row.getString("sealed_key")));
            assertThat(sealed).doesNotContain("a1a1a1a1");
        }
    }

    @Test
    void aKeyThatAnotherServerSealedIsNone() {
        database.outlet(box).saveKey(new OutletKey("ann", key(1), 5));
        byte[] other = new byte[SecretBox.SECRET_BYTES];
        other[0] = 1;
        assertThat(database.outlet(new SecretBox(other)).keys()).isEmpty();
    }
}
