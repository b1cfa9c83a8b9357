package org.dronemap.store.postgres;

import java.sql.SQLException;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneRecord;
import org.dronemap.core.drone.DroneStore;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.IdentityEvidence;
import org.dronemap.core.drone.IdentityTrust;
import org.dronemap.core.drone.KnownMission;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.store.postgres.json.MissionItemJson;

/** Stores drones, and the mission last known to be on each, in PostgreSQL. Thread-safe. */
public final class PostgresDroneStore implements DroneStore {
    private final SqlTransactions sql;

    PostgresDroneStore(SqlTransactions sql) {
        this.sql = sql;
    }

    @Override
    public List<DroneRecord> drones() {
        return sql.list("SELECT * FROM drone ORDER BY id", PostgresDroneStore::drone);
    }

    @Override
    public void save(DroneRecord drone) {
        sql.update(
                """
                INSERT INTO drone (id, name, address, port, system_id, transport,
                    kind, autopilot, vehicle, firmware, hardware_uid, last_heard,
                    evidence, link_identity, distinct_hardware, ground_amsl)
                VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)
                ON CONFLICT (id) DO UPDATE SET name = excluded.name, address = excluded.address, port = excluded.port,
                    system_id = excluded.system_id, transport = excluded.transport, kind = excluded.kind,
                    autopilot = excluded.autopilot, vehicle = excluded.vehicle, firmware = excluded.firmware,
                    hardware_uid = excluded.hardware_uid, last_heard = excluded.last_heard,
                    evidence = excluded.evidence, link_identity = excluded.link_identity,
                    distinct_hardware = excluded.distinct_hardware, ground_amsl = excluded.ground_amsl""",
                drone.id().value(),
                drone.name(),
                drone.key().address(),
                drone.key().port(),
                drone.key().systemId(),
                drone.transport(),
                drone.identification().kind(),
                drone.identification().autopilot(),
                drone.identification().vehicle(),
                drone.identification().firmware(),
                drone.identification().hardwareUid(),
                drone.lastHeard(),
                drone.standing().strongest(),
                drone.standing().linkIdentity(),
                drone.standing().distinct(),
                drone.groundAmslMeters());
    }

    @Override
    public void delete(DroneId id) {
        sql.update("DELETE FROM drone WHERE id = ?", id.value());
    }

    @Override
    public Optional<KnownMission> knownMission(DroneId id) {
        return sql.one(
                "SELECT items, content_hash, current_item FROM known_mission WHERE drone_id = ?",
                row -> new KnownMission(
                        MissionItemJson.read(row.text("items")),
                        row.textOrNull("content_hash"),
                        row.integerOrNull("current_item")),
                id.value());
    }

    @Override
    public void saveKnownMission(DroneId id, KnownMission mission) {
        sql.update("""
                INSERT INTO known_mission (drone_id, items, content_hash, current_item) VALUES (?, ?::json, ?, ?)
                ON CONFLICT (drone_id) DO UPDATE SET items = excluded.items, content_hash = excluded.content_hash,
                    current_item = excluded.current_item""", id.value(), MissionItemJson.write(mission.items()), mission.hash(), mission.current());
    }

    private static DroneRecord drone(ResultRow row) throws SQLException {
        return new DroneRecord(
                new DroneId(row.text("id")),
                row.text("name"),
                new DroneKey(row.text("address"), row.integer("port"), row.integer("system_id")),
                row.text("transport"),
                new Identification(
                        row.name("kind", VehicleKind.class),
                        row.text("autopilot"),
                        row.text("vehicle"),
                        row.textOrNull("firmware"),
                        row.textOrNull("hardware_uid")),
                new IdentityTrust(
                        row.name("evidence", IdentityEvidence.class),
                        row.textOrNull("link_identity"),
                        row.bool("distinct_hardware")),
                row.time("last_heard"),
                row.number("ground_amsl"));
    }
}
