package org.dronemap.store.postgres;

import java.sql.SQLException;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.access.AccessKey;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.AccountState;
import org.dronemap.core.access.Invitation;
import org.dronemap.core.access.KeyRights;
import org.dronemap.core.access.KeyScope;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.SignIn;
import org.dronemap.core.access.User;
import org.dronemap.store.StoreException;
import org.dronemap.store.UserSessionLimit;
import org.dronemap.store.postgres.json.FlightBoundsJson;

/** Stores users, their sessions and access keys in PostgreSQL. Thread-safe. */
public final class PostgresAccessStore implements AccessStore {
    private final SqlTransactions sql;

    PostgresAccessStore(SqlTransactions sql) {
        this.sql = sql;
    }

    @Override
    public List<User> users() {
        return sql.list("SELECT * FROM account ORDER BY name COLLATE \"C\"", PostgresAccessStore::user);
    }

    @Override
    public Optional<User> user(String name) {
        return sql.one("SELECT * FROM account WHERE name = ?", PostgresAccessStore::user, name);
    }

    @Override
    public boolean addUser(User user) {
        return sql.update(
                        """
                        INSERT INTO account (name, role, state, password_hash, must_change_password, organisation)
                        VALUES (?, ?, ?, ?, ?, ?) ON CONFLICT (name) DO NOTHING""",
                        user.name(),
                        user.role(),
                        user.state(),
                        user.passwordHash(),
                        user.mustChangePassword(),
                        OrganisationColumn.stored(user.organisation()))
                == 1;
    }

    @Override
    public void updateUser(User user) {
        int changed = sql.update(
                "UPDATE account SET role = ?, state = ?, password_hash = ?, must_change_password = ? WHERE name = ?",
                user.role(),
                user.state(),
                user.passwordHash(),
                user.mustChangePassword(),
                user.name());
        if (changed == 0) {
            throw new StoreException("There is no user " + user.name() + ".");
        }
    }

    @Override
    public boolean deleteUser(String name) {
        return sql.update("DELETE FROM account WHERE name = ?", name) > 0;
    }

    @Override
    public void addSignIn(SignIn signIn) {
        // One statement, one transaction: the deletion does not see the row inserted beside it.
        sql.update(
                """
                WITH surplus AS (
                    DELETE FROM sign_in WHERE token_hash IN (
                        SELECT token_hash FROM sign_in WHERE account_name = ?
                        ORDER BY expires_at DESC, token_hash OFFSET ?))
                INSERT INTO sign_in (token_hash, account_name, expires_at) VALUES (?, ?, ?)""",
                signIn.user(),
                UserSessionLimit.PER_USER - 1,
                signIn.tokenHash(),
                signIn.user(),
                signIn.expiresAt());
    }

    @Override
    public Optional<SignIn> signIn(String tokenHash, Instant now) {
        return sql.one(
                "SELECT * FROM sign_in WHERE token_hash = ? AND expires_at > ?",
                row -> new SignIn(row.text("token_hash"), row.text("account_name"), row.time("expires_at")),
                tokenHash,
                now);
    }

    @Override
    public void deleteSignIn(String tokenHash) {
        sql.update("DELETE FROM sign_in WHERE token_hash = ?", tokenHash);
    }

    @Override
    public void deleteOtherSignIns(String user, String keepTokenHash) {
        sql.update("DELETE FROM sign_in WHERE account_name = ? AND token_hash <> ?", user, keepTokenHash);
    }

    @Override
    public List<AccessKey> accessKeys(String owner) {
        return sql.list(
                "SELECT * FROM access_key WHERE account_name = ? ORDER BY created_at, id COLLATE \"C\"",
                PostgresAccessStore::accessKey,
                owner);
    }

    @Override
    public Optional<AccessKey> accessKey(String secretHash) {
        return sql.one("SELECT * FROM access_key WHERE secret_hash = ?", PostgresAccessStore::accessKey, secretHash);
    }

    @Override
    public void addAccessKey(AccessKey key) {
        KeyRights rights = key.rights();
        sql.update(
                """
                INSERT INTO access_key (id, label, account_name, parent, role, drones, permissions, bounds, expires_at,
                    secret_hash, created_at, last_used_at)
                VALUES (?, ?, ?, ?, ?, ?, ?, ?::json, ?, ?, ?, ?)""",
                key.id(),
                key.label(),
                key.owner(),
                key.parent(),
                rights.role(),
                KeyScopeColumns.drones(rights.scope()),
                KeyScopeColumns.permissions(rights.scope()),
                FlightBoundsJson.write(rights.scope().bounds()),
                rights.expiresAt(),
                key.secretHash(),
                key.createdAt(),
                key.lastUsedAt());
    }

    @Override
    public boolean replaceSecret(String owner, String id, String secretHash) {
        return sql.update(
                        "UPDATE access_key SET secret_hash = ? WHERE account_name = ? AND id = ?",
                        secretHash,
                        owner,
                        id)
                > 0;
    }

    @Override
    public void accessKeyUsed(String id, Instant at) {
        sql.update(
                "UPDATE access_key SET last_used_at = ? WHERE id = ? AND (last_used_at IS NULL OR last_used_at < ?)",
                at,
                id,
                at);
    }

    @Override
    public boolean deleteAccessKey(String owner, String id) {
        return sql.update("DELETE FROM access_key WHERE account_name = ? AND id = ?", owner, id) > 0;
    }

    @Override
    public List<Invitation> invitations(Instant now) {
        return sql.list(
                "SELECT * FROM invitation WHERE expires_at > ? ORDER BY expires_at, id COLLATE \"C\"",
                PostgresAccessStore::invitation,
                now);
    }

    @Override
    public void addInvitation(Invitation invitation, Instant now) {
        sql.update(
                """
                WITH expired AS (DELETE FROM invitation WHERE expires_at <= ?)
                INSERT INTO invitation (id, label, role, code_hash, invited_by, invited_by_account, expires_at,
                    organisation)
                VALUES (?, ?, ?, ?, ?, ?, ?, ?)""",
                now,
                invitation.id(),
                invitation.label(),
                invitation.role(),
                invitation.codeHash(),
                invitation.invitedBy(),
                invitation.account(),
                invitation.expiresAt(),
                OrganisationColumn.stored(invitation.organisation()));
    }

    @Override
    public boolean deleteInvitation(String id) {
        return sql.update("DELETE FROM invitation WHERE id = ?", id) > 0;
    }

    @Override
    public Optional<Invitation> invitation(String codeHash, Instant now) {
        return sql.one(
                "SELECT * FROM invitation WHERE code_hash = ? AND expires_at > ?",
                PostgresAccessStore::invitation,
                codeHash,
                now);
    }

    @Override
    public boolean acceptInvitation(String invitationId, User user) {
        // The row lock of the deletion makes one of two at once find it gone; a name that is taken leaves it in place.
        return sql.update(
                        """
                        WITH used AS (
                            DELETE FROM invitation WHERE id = ? AND NOT EXISTS (SELECT 1 FROM account WHERE name = ?)
                            RETURNING id)
                        INSERT INTO account (name, role, state, password_hash, must_change_password, organisation)
                        SELECT ?, ?, ?, ?, ?, ? FROM used""",
                        invitationId,
                        user.name(),
                        user.name(),
                        user.role(),
                        user.state(),
                        user.passwordHash(),
                        user.mustChangePassword(),
                        OrganisationColumn.stored(user.organisation()))
                == 1;
    }

    private static Invitation invitation(ResultRow row) throws SQLException {
        return new Invitation(
                row.text("id"),
                row.text("label"),
                row.name("role", Role.class),
                row.text("code_hash"),
                row.text("invited_by"),
                row.text("invited_by_account"),
                row.time("expires_at"),
                OrganisationColumn.read(row));
    }

    private static User user(ResultRow row) throws SQLException {
        return new User(
                row.text("name"),
                row.name("role", Role.class),
                row.name("state", AccountState.class),
                row.text("password_hash"),
                row.bool("must_change_password"),
                OrganisationColumn.read(row),
                row.text("id"));
    }

    private static AccessKey accessKey(ResultRow row) throws SQLException {
        return new AccessKey(
                row.text("id"),
                row.text("label"),
                row.text("account_name"),
                row.textOrNull("parent"),
                new KeyRights(
                        row.name("role", Role.class),
                        new KeyScope(
                                KeyScopeColumns.dronesOrAll(row.textOrNull("drones")),
                                KeyScopeColumns.permissions(row.text("permissions")),
                                FlightBoundsJson.read(row.textOrNull("bounds"))),
                        row.timeOrNull("expires_at")),
                row.text("secret_hash"),
                row.time("created_at"),
                row.timeOrNull("last_used_at"));
    }
}
