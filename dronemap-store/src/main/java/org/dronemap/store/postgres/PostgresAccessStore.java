package org.dronemap.store.postgres;

import java.sql.SQLException;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import javax.sql.DataSource;
import org.dronemap.core.access.AccessKey;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.SignIn;
import org.dronemap.core.access.User;
import org.dronemap.store.SignInLimit;
import org.dronemap.store.StoreException;

/** Users, sessions and keys in PostgreSQL. Thread-safe. */
public final class PostgresAccessStore implements AccessStore {
    private final Sql sql;

    public PostgresAccessStore(DataSource dataSource) {
        this.sql = new Sql(dataSource);
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
        return sql.update("""
                        INSERT INTO account (name, role, password_hash, must_change_password) VALUES (?, ?, ?, ?)
                        ON CONFLICT (name) DO NOTHING""", user.name(), user.role(), user.passwordHash(), user.mustChangePassword()) == 1;
    }

    @Override
    public void updateUser(User user) {
        int changed = sql.update(
                "UPDATE account SET role = ?, password_hash = ?, must_change_password = ? WHERE name = ?",
                user.role(),
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
        sql.update("""
                WITH surplus AS (
                    DELETE FROM sign_in WHERE token_hash IN (
                        SELECT token_hash FROM sign_in WHERE account_name = ?
                        ORDER BY expires_at DESC, token_hash OFFSET ?))
                INSERT INTO sign_in (token_hash, account_name, expires_at) VALUES (?, ?, ?)""", signIn.user(), SignInLimit.PER_USER - 1, signIn.tokenHash(), signIn.user(), signIn.expiresAt());
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
        sql.update("""
                INSERT INTO access_key (id, label, account_name, role, secret_hash, created_at)
                VALUES (?, ?, ?, ?, ?, ?)""", key.id(), key.label(), key.owner(), key.role(), key.secretHash(), key.createdAt());
    }

    @Override
    public boolean deleteAccessKey(String owner, String id) {
        return sql.update("DELETE FROM access_key WHERE account_name = ? AND id = ?", owner, id) > 0;
    }

    private static User user(Row row) throws SQLException {
        return new User(
                row.text("name"),
                row.name("role", Role.class),
                row.text("password_hash"),
                row.bool("must_change_password"));
    }

    private static AccessKey accessKey(Row row) throws SQLException {
        return new AccessKey(
                row.text("id"),
                row.text("label"),
                row.text("account_name"),
                row.name("role", Role.class),
                row.text("secret_hash"),
                row.time("created_at"));
    }
}
