package org.dronemap.store.postgres;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import java.util.zip.ZipOutputStream;
import org.dronemap.core.access.AccessKey;
import org.dronemap.core.access.AccountState;
import org.dronemap.core.access.KeyRights;
import org.dronemap.core.access.KeyScope;
import org.dronemap.core.access.Permission;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.SignIn;
import org.dronemap.core.access.User;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandPhase;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneRecord;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.IdentityTrust;
import org.dronemap.core.drone.KnownMission;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.history.EventGap;
import org.dronemap.core.history.EventPage;
import org.dronemap.core.history.Flight;
import org.dronemap.core.history.FlightStatistics;
import org.dronemap.core.history.HistoryEvent;
import org.dronemap.core.history.Retention;
import org.dronemap.core.history.TelemetryPoint;
import org.dronemap.core.history.TelemetryStore;
import org.dronemap.core.history.TimeRange;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.mission.SavedMission;
import org.dronemap.core.zone.AltitudeBand;
import org.dronemap.core.zone.FlightBounds;
import org.dronemap.store.StoreException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class BackupTest {
    private static final Instant AT = Instant.parse("2026-03-04T05:06:07.123456Z");
    private static final DroneRecord DRONE = new DroneRecord(
            new DroneId("copter-1"),
            "a, \"quoted\"\nname — Zürich 🚁",
            new DroneKey("127.0.0.1", 14601, 1),
            "udp",
            new Identification(VehicleKind.MULTICOPTER, "ArduPilot", "ArduCopter", "", null),
            IdentityTrust.UNPROVED,
            AT,
            499.5);
    private static final KnownMission KNOWN =
            new KnownMission(List.of(new MissionItem.TakeOff(20), new MissionItem.Land()), 1);
    private static final SavedMission SAVED =
            new SavedMission("m1", "roof", new Mission(List.of(new MissionItem.Land())), "alice", AT);
    private static final CommandRecord COMMAND = new CommandRecord(
            new CommandId("command-1"),
            DRONE.id(),
            "alice",
            "rest",
            "arm",
            "arm",
            AT,
            CommandPhase.DONE,
            null,
            new Outcome.Refused("vehicle", "PreArm: \\N is not null, \\. is no end", OutcomeCode.VEHICLE_REFUSED),
            AT,
            17L);
    private static final User ALICE = new User("alice", Role.ADMINISTRATOR, AccountState.ACTIVE, "salt$hash", false);
    private static final AccessKey KEY = new AccessKey(
            "k1",
            "script",
            "alice",
            null,
            new KeyRights(
                    Role.OPERATOR,
                    new KeyScope(Set.of(DRONE.id()), Set.of(Permission.COMMAND))
                            .boundedBy(new FlightBounds(null, new AltitudeBand(10.0, 50.0, Altitude.Reference.HOME))),
                    AT),
            "secret",
            AT,
            AT);

    @TempDir
    private Path temporary;

    private PostgresStores database;

    @BeforeEach
    void fill() {
        database = SharedDatabase.empty();
        database.drones().save(DRONE);
        database.drones().saveKnownMission(DRONE.id(), KNOWN);
        database.missions().save(SAVED);
        database.commands().begin(COMMAND);
        database.access().addUser(ALICE);
        database.access().addAccessKey(KEY);
        database.access().addSignIn(new SignIn("token", "alice", AT));
    }

    @Test
    void isAnotherSeriesOfEventsThatTellsWhatIsMissing() throws IOException {
        TelemetryStore events = database.telemetry();
        events.openEvents(AT);
        events.append(List.of(), List.of(HistoryEvent.of(DRONE.id(), AT, HistoryEvent.Kind.MODE, "GUIDED")));
        Path zip = backup();
        events.append(List.of(), List.of(HistoryEvent.of(DRONE.id(), AT, HistoryEvent.Kind.MODE, "AUTO")));
        EventPage before = events.eventsAfter(0, 10);

        database.backup().restore(zip);
        events.openEvents(Instant.EPOCH);
        events.append(List.of(), List.of(HistoryEvent.of(DRONE.id(), AT, HistoryEvent.Kind.MODE, "LAND")));

        EventPage after = events.eventsAfter(0, 10);
        assertThat(after.series().id()).isNotEqualTo(before.series().id());
        assertThat(after.entries()).hasSize(3);
        assertThat(after.entries().get(0)).isEqualTo(before.entries().get(0));
        assertThat(after.entries().get(1)).isInstanceOfSatisfying(EventGap.class, gap -> {
            assertThat(gap.cause()).isEqualTo(EventGap.Cause.RESTORED);
            assertThat(gap.from()).isEqualTo(AT);
        });
        assertThat(after.entries().get(2).number())
                .isGreaterThan(after.entries().get(1).number());
    }

    @Test
    void givesBackTelemetryEventsAndFlights() throws IOException {
        TelemetryPoint point = point(AT);
        TelemetryPoint unexpected = point(AT.plusSeconds(40 * 86_400L));
        HistoryEvent event = HistoryEvent.of(DRONE.id(), AT, HistoryEvent.Kind.MODE, "GUIDED");
        Flight flight = new Flight(
                "f1",
                DRONE.id(),
                DRONE.name(),
                AT,
                null,
                Flight.State.RUNNING,
                AT,
                FlightStatistics.NONE,
                List.of("alice, \"{bob}\""),
                null,
                null,
                "notes");
        database.telemetry().tidy(Retention.DEFAULT, AT);
        database.telemetry().append(List.of(point, unexpected), List.of(event));
        database.flights().save(flight);
        Path zip = backup();
        SharedDatabase.empty();

        database.backup().restore(zip);
        Retention forEver = new Retention(0, 0, Duration.ofSeconds(10));
        database.telemetry().tidy(forEver, AT);
        database.telemetry().append(List.of(), List.of(event));

        List<TelemetryPoint> points = new ArrayList<>();
        TimeRange span = new TimeRange(AT.minusSeconds(1), AT.plusSeconds(50 * 86_400L));
        database.telemetry().points(DRONE.id(), span, points::add);
        assertThat(points).containsExactly(point, unexpected);
        assertThat(database.telemetry().events(DRONE.id(), span, 10)).containsExactly(event, event);
        assertThat(database.flights().flight("f1")).contains(flight);
    }

    private static TelemetryPoint point(Instant at) {
        return new TelemetryPoint(
                DRONE.id(),
                at,
                new Position(new Geodetic(47.1234567891, 8.5), 400.5, null),
                null,
                null,
                null,
                null,
                LinkState.LIVE,
                LinkQuality.UNKNOWN,
                "GUIDED",
                true,
                null,
                null);
    }

    @Test
    void givesBackEverythingButSessions() throws IOException {
        Path zip = backup();
        database.drones().delete(DRONE.id());
        database.access().deleteUser("alice");
        database.missions().delete("m1");
        database.access().addUser(new User("bob", Role.VIEWER, AccountState.ACTIVE, "x", false));

        BackupSummary restored = database.backup().restore(zip);

        assertThat(restored.rows()).isEqualTo(7);
        assertHoldsEverything();
        assertThat(database.access().signIn("token", AT.minusSeconds(1))).isEmpty();
        // Statements that the pool's connections had prepared before still find their tables.
        for (int i = 0; i < 20; i++) {
            database.drones().save(DRONE);
            assertThat(database.drones().drones()).containsExactly(DRONE);
        }
    }

    @Test
    void restoresTwice() throws IOException {
        Path zip = backup();
        database.backup().restore(zip);
        database.backup().restore(zip);
        assertHoldsEverything();
    }

    @Test
    void neverGivesOutAnEpochAgainThatWasGivenOutSinceTheBackup() throws IOException {
        database.leases().reserve(10);
        Path zip = backup();
        long newest = database.leases().reserve(10);

        database.backup().restore(zip);

        assertThat(database.leases().reserve(1)).isEqualTo(newest + 1);
    }

    @Test
    void holdsOneMomentWhileOthersWrite() throws IOException {
        Path zip = temporary.resolve("moment.zip");
        try (OutputStream file = Files.newOutputStream(zip);
                OutputStream meddling = new OutputStream() {
                    private boolean done;

                    @Override
                    public void write(int value) throws IOException {
                        if (!done) {
                            done = true;
                            database.access().deleteUser("alice");
                            database.missions().delete("m1");
                        }
                        file.write(value);
                    }
                }) {
            database.backup().write(meddling);
        }
        database.backup().restore(zip);
        assertHoldsEverything();
    }

    @Test
    void refusesABackupOfANewerSchemaAndChangesNothing() throws IOException {
        Path zip = rewritten(
                BackupManifest.ENTRY,
                text -> text.replaceAll("\"schemaVersion\" : \"\\d+\"", "\"schemaVersion\" : \"9999\""));
        assertRefused(zip, "newer Dronemap (schema 9999)");
    }

    @Test
    void refusesADamagedTableAndChangesNothing() throws IOException {
        Path zip = rewritten("account.csv", text -> text.replace("alice", "mallo"));
        assertRefused(zip, "account.csv does not have the checksum");
    }

    @Test
    void refusesAManifestWithMoreThanNames() throws IOException {
        Path zip = rewritten(BackupManifest.ENTRY, text -> text.replace("\"account\"", "\"account; DROP\""));
        assertRefused(zip, "is not a name");
    }

    @Test
    void refusesAFileThatIsNoBackup() throws IOException {
        Path zip = Files.writeString(temporary.resolve("no.zip"), "this is no zip file");
        assertRefused(zip, "is not a Dronemap backup");
        assertRefused(temporary.resolve("missing.zip"), "There is no backup");
    }

    @Test
    void refusesRowsThatTheTablesDoNotTakeAndChangesNothing() throws IOException {
        Path zip = temporary.resolve("foreign.zip");
        byte[] csv = "name,role,password_hash,must_change_password\neve,EMPEROR,x,f\n".getBytes(StandardCharsets.UTF_8);
        BackupManifest manifest = new BackupManifest(
                "1",
                AT,
                List.of(new BackupManifest.Table(
                        "account",
                        List.of("name", "role", "password_hash", "must_change_password"),
                        1,
                        java.util.HexFormat.of().formatHex(Sha256.digest().digest(csv)))));
        write(zip, Map.of("account.csv", csv, BackupManifest.ENTRY, manifest.json()));
        assertRefused(zip, "nothing was changed");
    }

    private void assertRefused(Path zip, String sentence) {
        assertThatThrownBy(() -> database.backup().restore(zip))
                .isInstanceOf(StoreException.class)
                .hasMessageContaining(sentence);
        assertHoldsEverything();
    }

    private void assertHoldsEverything() {
        assertThat(database.drones().drones()).containsExactly(DRONE);
        assertThat(database.drones().knownMission(DRONE.id())).contains(KNOWN);
        assertThat(database.missions().missions()).containsExactly(SAVED);
        assertThat(database.commands().command(COMMAND.id())).contains(COMMAND);
        assertThat(database.access().users())
                .usingRecursiveFieldByFieldElementComparatorIgnoringFields("id")
                .containsExactly(ALICE);
        assertThat(database.access().accessKeys("alice")).containsExactly(KEY);
    }

    private Path backup() throws IOException {
        Path zip = temporary.resolve("backup.zip");
        try (OutputStream out = Files.newOutputStream(zip)) {
            database.backup().write(out);
        }
        return zip;
    }

    private Path rewritten(String entry, java.util.function.UnaryOperator<String> change) throws IOException {
        Map<String, byte[]> entries = new LinkedHashMap<>();
        try (ZipInputStream in = new ZipInputStream(new ByteArrayInputStream(Files.readAllBytes(backup())))) {
            for (ZipEntry each = in.getNextEntry(); each != null; each = in.getNextEntry()) {
                ByteArrayOutputStream bytes = new ByteArrayOutputStream();
                in.transferTo(bytes);
                entries.put(each.getName(), bytes.toByteArray());
            }
        }
        String before = new String(entries.get(entry), StandardCharsets.UTF_8);
        String after = change.apply(before);
        assertThat(after).isNotEqualTo(before);
        entries.put(entry, after.getBytes(StandardCharsets.UTF_8));
        Path zip = temporary.resolve("rewritten.zip");
        write(zip, entries);
        return zip;
    }

    private static void write(Path zip, Map<String, byte[]> entries) throws IOException {
        try (ZipOutputStream out = new ZipOutputStream(Files.newOutputStream(zip))) {
            for (Map.Entry<String, byte[]> each : entries.entrySet()) {
                out.putNextEntry(new ZipEntry(each.getKey()));
                out.write(each.getValue());
                out.closeEntry();
            }
        }
    }
}
