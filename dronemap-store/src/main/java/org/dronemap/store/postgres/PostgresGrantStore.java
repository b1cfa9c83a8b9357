package org.dronemap.store.postgres;

import java.sql.SQLException;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronemap.core.access.Fleet;
import org.dronemap.core.access.Gift;
import org.dronemap.core.access.Grant;
import org.dronemap.core.access.GrantObject;
import org.dronemap.core.access.GrantStore;
import org.dronemap.core.access.GrantSubject;
import org.dronemap.core.access.OrganisationDirectory;
import org.dronemap.core.access.UserGroup;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.organisation.Organisation;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.store.GrantOrdering;
import org.jspecify.annotations.Nullable;

/** Stores organisations, groups, fleets and grants in PostgreSQL. Thread-safe. */
public final class PostgresGrantStore implements GrantStore {
    private final SqlTransactions sql;

    PostgresGrantStore(SqlTransactions sql) {
        this.sql = sql;
    }

    @Override
    public OrganisationDirectory directory() {
        Map<DroneId, OrganisationId> owners = new HashMap<>();
        sql.list(
                        "SELECT * FROM drone_owner",
                        row -> Map.entry(new DroneId(row.text("drone_id")), OrganisationColumn.read(row)))
                .forEach(entry -> owners.put(entry.getKey(), entry.getValue()));
        return new OrganisationDirectory(
                sorted(
                        sql.list("SELECT * FROM organisation", PostgresGrantStore::organisation),
                        GrantOrdering.ORGANISATIONS),
                owners,
                sorted(groups(), GrantOrdering.GROUPS),
                sorted(sql.list("SELECT * FROM fleet", PostgresGrantStore::fleet), GrantOrdering.FLEETS),
                sorted(sql.list("SELECT * FROM access_grant", PostgresGrantStore::grant), GrantOrdering.GRANTS),
                sorted(sql.list("SELECT * FROM drone_gift", PostgresGrantStore::gift), GrantOrdering.GIFTS),
                new HashSet<>(sql.list("SELECT * FROM only_granted", PostgresGrantStore::subject)));
    }

    /** Sorted here, for the order of names in a database depends on its collation. */
    private static <T> List<T> sorted(List<T> all, Comparator<T> order) {
        return all.stream().sorted(order).toList();
    }

    private List<UserGroup> groups() {
        Map<String, Set<String>> members = new HashMap<>();
        sql.list("SELECT * FROM user_group_member", row -> Map.entry(row.text("group_id"), row.text("account_name")))
                .forEach(entry -> members.computeIfAbsent(entry.getKey(), id -> new HashSet<>())
                        .add(entry.getValue()));
        return sql.list(
                "SELECT * FROM user_group",
                row -> new UserGroup(
                        row.text("id"),
                        OrganisationColumn.read(row),
                        row.text("name"),
                        members.getOrDefault(row.text("id"), Set.of())));
    }

    @Override
    public void save(Organisation organisation) {
        sql.update("""
                INSERT INTO organisation (id, name, made_at) VALUES (?, ?, ?)
                ON CONFLICT (id) DO UPDATE SET name = excluded.name""", organisation.id().value(), organisation.name(), organisation.madeAt());
    }

    @Override
    public boolean deleteOrganisation(OrganisationId id) {
        return sql.update("DELETE FROM organisation WHERE id = ?", id.value()) > 0;
    }

    @Override
    public void assign(DroneId drone, OrganisationId owner) {
        sql.update("""
                INSERT INTO drone_owner (drone_id, organisation) VALUES (?, ?)
                ON CONFLICT (drone_id) DO UPDATE SET organisation = excluded.organisation""", drone.value(), owner.value());
    }

    @Override
    public void give(Gift gift) {
        // One statement, one transaction.
        sql.update(
                """
                WITH owned AS (
                    INSERT INTO drone_owner (drone_id, organisation) VALUES (?, ?)
                    ON CONFLICT (drone_id) DO UPDATE SET organisation = excluded.organisation)
                INSERT INTO drone_gift (drone_id, drone_name, from_organisation, to_organisation, given_at, histories)
                VALUES (?, ?, ?, ?, ?, ?)""",
                gift.drone().value(),
                gift.to().value(),
                gift.drone().value(),
                gift.droneName(),
                gift.from().value(),
                gift.to().value(),
                gift.at(),
                gift.histories());
    }

    @Override
    public void save(UserGroup group) {
        // One statement, one transaction. The rows of members that stay are not touched.
        sql.update(
                """
                WITH kept AS (
                    INSERT INTO user_group (id, organisation, name) VALUES (?, ?, ?)
                    ON CONFLICT (id) DO UPDATE SET name = excluded.name RETURNING id),
                gone AS (
                    DELETE FROM user_group_member WHERE group_id = ? AND account_name <> ALL (string_to_array(?, ',')))
                INSERT INTO user_group_member (group_id, account_name)
                SELECT kept.id, member FROM kept, unnest(string_to_array(?, ',')) AS member
                ON CONFLICT DO NOTHING""",
                group.id(),
                OrganisationColumn.stored(group.organisation()),
                group.name(),
                group.id(),
                String.join(",", group.members()),
                String.join(",", group.members()));
    }

    @Override
    public boolean deleteGroup(String id) {
        return sql.update("DELETE FROM user_group WHERE id = ?", id) > 0;
    }

    @Override
    public void save(Fleet fleet) {
        sql.update(
                """
                INSERT INTO fleet (id, organisation, name, drones) VALUES (?, ?, ?, ?)
                ON CONFLICT (id) DO UPDATE SET name = excluded.name, drones = excluded.drones""",
                fleet.id(),
                OrganisationColumn.stored(fleet.organisation()),
                fleet.name(),
                KeyScopeColumns.list(fleet.drones()));
    }

    @Override
    public boolean deleteFleet(String id) {
        return sql.update("DELETE FROM fleet WHERE id = ?", id) > 0;
    }

    @Override
    public void add(Grant grant) {
        sql.update(
                """
                INSERT INTO access_grant (id, organisation, account_name, group_id, fleet_id, drones, permissions,
                    begins_at, ends_at, made_by, made_at, of_virtual_drones)
                VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)""",
                grant.id(),
                OrganisationColumn.stored(grant.organisation()),
                user(grant.subject()),
                group(grant.subject()),
                grant.object() instanceof GrantObject.OfFleet fleet ? fleet.id() : null,
                grant.object() instanceof GrantObject.Drones drones ? KeyScopeColumns.list(drones.ids()) : null,
                KeyScopeColumns.words(grant.permissions()),
                grant.from(),
                grant.until(),
                grant.madeBy(),
                grant.madeAt(),
                grant.object() instanceof GrantObject.Virtual);
    }

    @Override
    public boolean deleteGrant(String id) {
        return sql.update("DELETE FROM access_grant WHERE id = ?", id) > 0;
    }

    @Override
    public void setOnlyGranted(GrantSubject subject, boolean only) {
        if (only) {
            sql.update(
                    "INSERT INTO only_granted (account_name, group_id) VALUES (?, ?) ON CONFLICT DO NOTHING",
                    user(subject),
                    group(subject));
        } else {
            sql.update(
                    "DELETE FROM only_granted WHERE account_name = ? OR group_id = ?", user(subject), group(subject));
        }
    }

    @Override
    public void forgetUser(String name) {
        sql.update("""
                WITH granted AS (DELETE FROM access_grant WHERE account_name = ?),
                bound AS (DELETE FROM only_granted WHERE account_name = ?)
                DELETE FROM user_group_member WHERE account_name = ?""", name, name, name);
    }

    private static @Nullable String user(GrantSubject subject) {
        return subject instanceof GrantSubject.OfUser user ? user.name() : null;
    }

    private static @Nullable String group(GrantSubject subject) {
        return subject instanceof GrantSubject.OfGroup group ? group.id() : null;
    }

    private static Organisation organisation(ResultRow row) throws SQLException {
        return new Organisation(new OrganisationId(row.text("id")), row.text("name"), row.time("made_at"));
    }

    private static Fleet fleet(ResultRow row) throws SQLException {
        return new Fleet(
                row.text("id"),
                OrganisationColumn.read(row),
                row.text("name"),
                KeyScopeColumns.ids(row.text("drones")));
    }

    private static GrantSubject subject(ResultRow row) throws SQLException {
        String user = row.textOrNull("account_name");
        return user == null ? new GrantSubject.OfGroup(row.text("group_id")) : new GrantSubject.OfUser(user);
    }

    private static Grant grant(ResultRow row) throws SQLException {
        return new Grant(
                row.text("id"),
                OrganisationColumn.read(row),
                subject(row),
                row.bool("of_virtual_drones")
                        ? new GrantObject.Virtual()
                        : object(row.textOrNull("fleet_id"), row.textOrNull("drones")),
                KeyScopeColumns.permissions(row.text("permissions")),
                row.time("begins_at"),
                row.timeOrNull("ends_at"),
                row.text("made_by"),
                row.time("made_at"));
    }

    private static Gift gift(ResultRow row) throws SQLException {
        return new Gift(
                new DroneId(row.text("drone_id")),
                row.text("drone_name"),
                new OrganisationId(row.text("from_organisation")),
                new OrganisationId(row.text("to_organisation")),
                row.time("given_at"),
                row.bool("histories"));
    }

    private static GrantObject object(@Nullable String fleet, @Nullable String drones) {
        if (fleet != null) {
            return new GrantObject.OfFleet(fleet);
        }
        return drones == null ? new GrantObject.Everything() : new GrantObject.Drones(KeyScopeColumns.ids(drones));
    }
}
