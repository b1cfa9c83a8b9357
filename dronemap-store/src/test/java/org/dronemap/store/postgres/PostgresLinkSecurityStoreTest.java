package org.dronemap.store.postgres;

import static org.assertj.core.api.Assertions.assertThat;

import java.sql.Connection;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.Base64;
import java.util.HexFormat;
import org.dronemap.core.access.LinkSecurity;
import org.dronemap.core.access.LinkSecurityStore;
import org.dronemap.core.access.LinkSigningPolicy;
import org.dronemap.store.contract.LinkSecurityStoreContract;
import org.dronemap.store.secret.SecretBox;
import org.junit.jupiter.api.Test;

class PostgresLinkSecurityStoreTest extends LinkSecurityStoreContract {
    private static final LinkSecurity SECURED =
            new LinkSecurity(COPTER, LinkSigningPolicy.REQUIRED, key(1), key(2), true, 5);

    private final SecretBox box = new SecretBox(new byte[SecretBox.SECRET_BYTES]);
    private final PostgresStores database = SharedDatabase.empty();

    @Override
    protected Stores emptyStores() {
        return new Stores(database.drones(), database.linkSecurity(box));
    }

    @Test
    void noByteOfAKeyLiesReadableInTheDatabase() throws SQLException {
        database.linkSecurity(box).save(SECURED);
        try (Connection connection = database.dataSource().getConnection();
                Statement statement = connection.createStatement();
                ResultSet row = statement.executeQuery("SELECT * FROM link_security")) {
            assertThat(row.next()).isTrue();
            String sealed = row.getString("sealed_key");
            assertThat(HexFormat.of().formatHex(Base64.getDecoder().decode(sealed)))
                    .doesNotContain(HexFormat.of().formatHex(key(1).secret(), 0, 4))
                    .doesNotContain(HexFormat.of().formatHex(key(1).secret(), 28, 32));
        }
    }

    @Test
    void anotherServerSecretOpensNoKeyAndLeavesTheDroneClosed() {
        database.linkSecurity(box).save(SECURED);
        byte[] other = new byte[SecretBox.SECRET_BYTES];
        other[0] = 1;
        LinkSecurityStore elsewhere = database.linkSecurity(new SecretBox(other));

        assertThat(elsewhere.all())
                .containsExactly(new LinkSecurity(COPTER, LinkSigningPolicy.REQUIRED, null, null, false, 5));
    }

    @Test
    void aKeyMovedToTheOtherColumnDoesNotOpen() throws SQLException {
        database.linkSecurity(box).save(SECURED);
        try (Connection connection = database.dataSource().getConnection();
                Statement statement = connection.createStatement()) {
            statement.executeUpdate("UPDATE link_security SET sealed_key = sealed_next_key");
        }
        assertThat(database.linkSecurity(box).all().get(0).key()).isNull();
    }
}
