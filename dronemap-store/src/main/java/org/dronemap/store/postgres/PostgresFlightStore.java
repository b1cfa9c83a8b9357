package org.dronemap.store.postgres;

import java.sql.SQLException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.history.Flight;
import org.dronemap.core.history.FlightQuery;
import org.dronemap.core.history.FlightStatistics;
import org.dronemap.core.history.FlightStore;
import org.jspecify.annotations.Nullable;

/** Stores flights in PostgreSQL. Thread-safe. */
public final class PostgresFlightStore implements FlightStore {
    private static final String ORDER = " ORDER BY started_at DESC, id DESC LIMIT ?";

    /** Notes are people's own, whatever the flight does. */
    private static final String SAVE = """
        INSERT INTO flight (id, drone_id, drone_name, started_at, ended_at, state, heard_at, distance, highest,
            fastest, farthest, battery_first, battery_last, from_latitude, from_longitude, last_latitude,
            last_longitude, users, operation_id, operation_words, notice, notes)
        VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)
        ON CONFLICT (id) DO UPDATE SET (drone_name, ended_at, state, heard_at, distance, highest, fastest,
            farthest, battery_first, battery_last, from_latitude, from_longitude, last_latitude,
            last_longitude, users, operation_id, operation_words, notice) =
            (excluded.drone_name, excluded.ended_at, excluded.state, excluded.heard_at, excluded.distance,
            excluded.highest, excluded.fastest, excluded.farthest, excluded.battery_first,
            excluded.battery_last, excluded.from_latitude, excluded.from_longitude, excluded.last_latitude,
            excluded.last_longitude, excluded.users, excluded.operation_id, excluded.operation_words,
            excluded.notice)""";

    private final SqlTransactions sql;

    PostgresFlightStore(SqlTransactions sql) {
        this.sql = sql;
    }

    @Override
    public List<Flight> flights(FlightQuery query, @Nullable Flight after, int limit) {
        StringBuilder where = new StringBuilder("SELECT * FROM flight WHERE true");
        List<@Nullable Object> arguments = new ArrayList<>();
        if (query.drone() != null) {
            where.append(" AND drone_id = ?");
            arguments.add(query.drone().value());
        }
        if (query.user() != null) {
            where.append(" AND ? = ANY (users)");
            arguments.add(query.user());
        }
        if (query.from() != null) {
            where.append(" AND started_at >= ?");
            arguments.add(query.from());
        }
        if (query.until() != null) {
            where.append(" AND started_at < ?");
            arguments.add(query.until());
        }
        if (query.words() != null) {
            where.append(" AND strpos(lower(concat_ws(E'\\n', drone_name, notes, operation_words)), lower(?)) > 0");
            arguments.add(query.words());
        }
        if (after != null) {
            where.append(" AND (started_at, id) < (?, ? COLLATE \"C\")");
            arguments.add(after.start());
            arguments.add(after.id());
        }
        arguments.add(limit);
        return sql.list(where + ORDER, PostgresFlightStore::flight, arguments.toArray());
    }

    @Override
    public Optional<Flight> flight(String id) {
        return sql.one("SELECT * FROM flight WHERE id = ?", PostgresFlightStore::flight, id);
    }

    @Override
    public List<Flight> open() {
        return sql.list(
                "SELECT DISTINCT ON (drone_id) * FROM flight WHERE state <> 'ENDED' ORDER BY drone_id, started_at DESC",
                PostgresFlightStore::flight);
    }

    @Override
    public void save(Flight flight) {
        FlightStatistics measures = flight.measures();
        Geodetic from = measures.takeOff();
        Geodetic last = measures.last();
        Flight.FlightOperation operation = flight.operation();
        sql.update(
                SAVE,
                flight.id(),
                flight.drone().value(),
                flight.droneName(),
                flight.start(),
                flight.end(),
                flight.state(),
                flight.lastHeardAt(),
                measures.distanceMeters(),
                measures.highestMeters(),
                measures.fastest(),
                measures.farthestMeters(),
                measures.batteryFirst(),
                measures.batteryLast(),
                from == null ? null : from.latitudeDegrees(),
                from == null ? null : from.longitudeDegrees(),
                last == null ? null : last.latitudeDegrees(),
                last == null ? null : last.longitudeDegrees(),
                flight.users().toArray(new String[0]),
                operation == null ? null : operation.id(),
                operation == null ? null : operation.words(),
                flight.notice(),
                flight.notes());
    }

    @Override
    public boolean annotate(String id, String notes) {
        return sql.update("UPDATE flight SET notes = ? WHERE id = ?", notes, id) == 1;
    }

    private static Flight flight(ResultRow row) throws SQLException {
        String operation = row.textOrNull("operation_id");
        return new Flight(
                row.text("id"),
                new DroneId(row.text("drone_id")),
                row.text("drone_name"),
                row.time("started_at"),
                row.timeOrNull("ended_at"),
                row.name("state", Flight.State.class),
                row.time("heard_at"),
                new FlightStatistics(
                        row.float8("distance"),
                        row.number("highest"),
                        row.number("fastest"),
                        row.number("farthest"),
                        row.integerOrNull("battery_first"),
                        row.integerOrNull("battery_last"),
                        place(row, "from_"),
                        place(row, "last_")),
                row.texts("users"),
                operation == null ? null : new Flight.FlightOperation(operation, row.text("operation_words")),
                row.textOrNull("notice"),
                row.text("notes"));
    }

    private static @Nullable Geodetic place(ResultRow row, String prefix) throws SQLException {
        Double latitude = row.number(prefix + "latitude");
        Double longitude = row.number(prefix + "longitude");
        return latitude == null || longitude == null ? null : new Geodetic(latitude, longitude);
    }
}
