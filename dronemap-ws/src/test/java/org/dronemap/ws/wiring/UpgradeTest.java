package org.dronemap.ws.wiring;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.dronemap.core.access.AccessKey;
import org.dronemap.core.access.OrganisationDirectory;
import org.dronemap.core.access.User;
import org.dronemap.core.audit.SignedAuditHead;
import org.dronemap.core.history.FlightQuery;
import org.dronemap.core.history.NumberedEvent;
import org.dronemap.core.history.TelemetryPoint;
import org.dronemap.core.history.TimeRange;
import org.dronemap.core.operation.JournalReplay;
import org.dronemap.core.operation.OperationKind;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.core.recording.Recording;
import org.dronemap.core.virtual.VirtualDrone;
import org.dronemap.core.virtual.VirtualDroneId;
import org.dronemap.core.virtual.VirtualRun;
import org.dronemap.core.virtual.VirtualRunStage;
import org.dronemap.core.zone.Zone;
import org.dronemap.core.zone.ZoneBinding;
import org.dronemap.store.postgres.PostgresStores;
import org.dronemap.store.secret.SecretBox;
import org.dronemap.store.secret.ServerSecret;
import org.dronemap.ws.audit.AuditReceiptView;
import org.dronemap.ws.reading.JsonCodec;
import org.dronemap.ws.reading.SecretGenerator;
import org.dronemap.ws.security.AuthenticatedCaller;
import org.dronemap.ws.security.CallerAuthenticator;
import org.dronemap.ws.server.OperationComponents;
import org.dronemap.ws.server.ServerComponents;
import org.dronemap.ws.settings.ServerSettings;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What each earlier version has stored while much was under way is read, taken up and decided on in the same way now. */
class UpgradeTest {
    private static final int MOST = 1_000;
    private static final Duration LONG = Duration.ofHours(1);
    private static final Map<String, UpgradedServer> VERSIONS = new LinkedHashMap<>();

    @TempDir
    private static Path folder;

    @BeforeAll
    static void start() {
        UpgradedServer.versions().forEach(version -> {
            String name = version.getFileName().toString();
            VERSIONS.put(name, new UpgradedServer(version, folder.resolve(name)));
        });
    }

    @AfterAll
    static void stop() {
        VERSIONS.values().forEach(UpgradedServer::close);
    }

    static Stream<String> versions() {
        return VERSIONS.keySet().stream();
    }

    @ParameterizedTest
    @MethodSource("versions")
    void nothingIsLost(String version) {
        UpgradedServer now = VERSIONS.get(version);
        PostgresStores kept = now.database();
        OrganisationDirectory holdings = kept.grants().directory();
        List<User> users = kept.access().users();

        assertThat(users).hasSize(rows(now, "account"));
        assertThat(users.stream()
                        .mapToInt(user -> kept.access().accessKeys(user.name()).size())
                        .sum())
                .isEqualTo(rows(now, "access_key"));
        assertThat(kept.access().invitations(now.time().clock().instant())).hasSize(rows(now, "invitation"));
        assertThat(holdings.organisations()).hasSize(rows(now, "organisation"));
        assertThat(holdings.groups()).hasSize(rows(now, "user_group"));
        assertThat(holdings.fleets()).hasSize(rows(now, "fleet"));
        assertThat(holdings.grants()).hasSize(rows(now, "access_grant"));
        assertThat(kept.drones().drones()).hasSize(rows(now, "drone"));
        assertThat(kept.drones().drones().stream()
                        .filter(drone -> kept.drones().knownMission(drone.id()).isPresent()))
                .hasSize(rows(now, "known_mission"));
        assertThat(kept.missions().missions()).hasSize(rows(now, "saved_mission"));
        assertThat(kept.zones().zones()).hasSize(rows(now, "zone"));
        assertThat(kept.virtualDrones().virtualDrones()).hasSize(rows(now, "virtual_drone"));
        assertThat(kept.links().robotKeys()).hasSize(rows(now, "robot_key"));
        assertThat(kept.flights().flights(FlightQuery.ALL, null, MOST)).hasSize(rows(now, "flight"));
        assertThat(kept.telemetry().eventsAfter(0, MOST).entries())
                .filteredOn(NumberedEvent.class::isInstance)
                .hasSizeGreaterThanOrEqualTo(rows(now, "drone_event"));
        assertThat(kept.recordings().recordings())
                .hasSize(rows(now, "recording"))
                .allMatch(recording ->
                        Files.exists(now.data().resolve("recordings").resolve(recording.id() + ".tlog")));
        assertThat(kept.recordings().recordings()).extracting(Recording::state).doesNotContain(Recording.State.RUNNING);
        assertThat(operations(now)).hasSize(rows(now, "operation"));
        assertThat(kept.owners().all()).hasSize(rowsOrNone(now, "owners_values"));
    }

    static Stream<String> versionsWithOwnersValues() {
        return versions().filter(version -> VERSIONS.get(version).facts().has("held"));
    }

    @ParameterizedTest
    @MethodSource("versionsWithOwnersValues")
    void whatOwnersHadSetAndHowTheirDronesFlewIsRead(String version) {
        UpgradedServer now = VERSIONS.get(version);
        String held = now.facts().required("held").stringValue();

        assertThat(now.database().leases().leases())
                .filteredOn(lease -> lease.drone().value().equals(held))
                .singleElement()
                .matches(lease -> lease.user().equals(pilot(now)) && "GUIDED".equals(lease.mode()));
        assertThat(now.database().owners().all())
                .anySatisfy(owners -> assertThat(owners.values())
                        .filteredOn(value -> value.name().equals("FS_GCS_ENABLE"))
                        .singleElement()
                        .matches(value -> value.owners() == 0 && value.ours() == 1));
    }

    static Stream<String> versionsWithoutJitter() {
        return versions().filter(version -> !VERSIONS.get(version).hasColumn("telemetry", "jitter"));
    }

    @ParameterizedTest
    @MethodSource("versionsWithoutJitter")
    void telemetryThatWasStoredBeforeJitterWasIsReadWithoutIt(String version) {
        UpgradedServer now = VERSIONS.get(version);
        TimeRange ever = new TimeRange(
                now.time().clock().instant().minus(Duration.ofDays(1)),
                now.time().clock().instant());
        List<TelemetryPoint> points = new ArrayList<>();
        now.database()
                .drones()
                .drones()
                .forEach(drone -> now.database().telemetry().points(drone.id(), ever, points::add));

        assertThat(points)
                .hasSizeGreaterThanOrEqualTo(rows(now, "telemetry"))
                .anyMatch(point -> point.quality().lossShort() != null)
                .anyMatch(point -> point.quality().roundTripMillis() != null);
        assertThat(points)
                .extracting(TelemetryPoint::quality)
                .allMatch(quality -> quality.jitterMillis() == null && quality.jitterLongMillis() == null);
    }

    @ParameterizedTest
    @MethodSource("versions")
    void whatStandsInTextsIsRead(String version) {
        UpgradedServer now = VERSIONS.get(version);
        PostgresStores kept = now.database();

        assertThat(kept.zones().zones())
                .extracting(Zone::binding)
                .hasAtLeastOneElementOfType(ZoneBinding.OfUser.class)
                .hasAtLeastOneElementOfType(ZoneBinding.OfDrone.class)
                .hasAtLeastOneElementOfType(ZoneBinding.Everybody.class);
        assertThat(kept.zones().zones()).anyMatch(zone -> zone.validity().until() != null);
        assertThat(keys(now))
                .anyMatch(key -> key.rights().scope().bounds().stream().anyMatch(bounds -> bounds.area() != null));
        assertThat(keys(now)).anyMatch(key -> key.rights().scope().drones() != null);
        assertThat(kept.missions().missions())
                .allMatch(one -> !one.mission().items().isEmpty());
        assertThat(kept.flights().flights(FlightQuery.ALL, null, MOST))
                .anyMatch(flight -> flight.users().contains(pilot(now)));
    }

    @ParameterizedTest
    @MethodSource("versions")
    void usersSignInAsBefore(String version) {
        UpgradedServer now = VERSIONS.get(version);
        ServiceConfiguration services = new ServiceConfiguration();
        SecretGenerator secrets = services.secrets();
        ServerComponents house = now.house();
        ServerSettings settings = now.settings();
        CallerAuthenticator door = services.authentication(
                house.access(),
                services.firstPassword(house.access(), house.passwords(), secrets, settings),
                services.verifiers(house.passwords(), secrets, house.grantBook(), settings),
                now.time().clock());
        String password = now.facts().required("account").required("password").stringValue();

        AuthenticatedCaller byPassword = door.byPassword(pilot(now), password, "127.0.0.1");
        AuthenticatedCaller byKey = door.byKey(shown(now, "accessKey"));
        AuthenticatedCaller byLocalKey =
                door.byKey(UpgradedServer.read(now.data().resolve("local-key")).strip());

        assertThat(byPassword.principal().name()).isEqualTo(pilot(now));
        assertThat(byKey.principal().name()).isEqualTo(pilot(now));
        assertThat(byKey.principal().scope().bounds()).hasSize(1);
        assertThat(byLocalKey.principal().key()).isNotEqualTo(byKey.principal().key());
    }

    @ParameterizedTest
    @MethodSource("versions")
    void whatWasSealedOpens(String version) {
        UpgradedServer now = VERSIONS.get(version);
        SecretBox box = ServerSecret.box(null, now.data().resolve("link-secret"));

        assertThat(now.database().outlet(box).keys()).hasSize(rows(now, "outlet_key"));
        assertThat(now.database().linkSecurity(box).all())
                .hasSize(rows(now, "link_security"))
                .anyMatch(security -> security.key() != null);
        assertThat(now.house().links().keys().secret(shown(now, "dtlsKey"))).isPresent();
    }

    @ParameterizedTest
    @MethodSource("versions")
    void theRecordsOfWhatWasDoneAreAsTheyWereWritten(String version) {
        UpgradedServer now = VERSIONS.get(version);
        SignedAuditHead receipt = new JsonCodec()
                .read(UpgradedServer.read(now.receipt()), AuditReceiptView.class)
                .signedHead();

        assertThat(now.house().audit().verify(receipt).sentence()).contains("records are as they were written");
    }

    @ParameterizedTest
    @MethodSource("versions")
    void whatWasUnderWayGoesOnOrEndsWithAReason(String version) {
        UpgradedServer now = VERSIONS.get(version);
        OperationComponents side = now.house().runs();
        assertThat(now.underWay())
                .extracting(one -> one.id().value())
                .containsExactlyInAnyOrder(underWay(now, "run"), underWay(now, "follow"));
        now.time().advance(LONG);

        assertThat(now.time().failures()).isEmpty();
        assertThat(side.operations().failedCount()).isZero();
        assertThat(now.underWay()).allSatisfy(before -> {
            SavedOperation after = now.database().operations().find(before.id()).orElseThrow();
            assertThat(side.operations().journal(before.id(), before.last() + 1, 1))
                    .allMatch(entry -> entry.input().startsWith("{\"type\":\"Resumed\""))
                    .hasSize(1);
            assertThat(after.endedAt() == null || after.state().contains("\"end\":\""))
                    .isTrue();
        });
        for (SavedOperation one : operations(now)) {
            assertThat(differenceIn(now, one)).isEmpty();
        }
    }

    @ParameterizedTest
    @MethodSource("versions")
    void virtualDronesGoOn(String version) {
        UpgradedServer now = VERSIONS.get(version);
        VirtualRun flew = run(now.virtuals(), underWay(now, "virtualDrone"));
        VirtualRun waited = run(now.virtuals(), underWay(now, "waitingVirtualDrone"));
        assertThat(flew.stage()).isEqualTo(VirtualRunStage.FLYING);
        assertThat(flew.assignment()).isNotNull();
        assertThat(waited.stage()).isEqualTo(VirtualRunStage.QUEUED);
        now.time().advance(LONG);

        VirtualRun flies = run(now.house().virtuals().all(), underWay(now, "virtualDrone"));
        assertThat(flies.flown()).isGreaterThanOrEqualTo(flew.flown());
        assertThat(flies.stage()).isEqualTo(VirtualRunStage.QUEUED);
        assertThat(flies.note()).isNotEmpty();
        assertThat(run(now.house().virtuals().all(), underWay(now, "waitingVirtualDrone"))
                        .stage())
                .isEqualTo(VirtualRunStage.QUEUED);
        assertThat(now.house().virtuals().failedCount()).isZero();
    }

    private static VirtualRun run(List<VirtualDrone> all, String id) {
        return all.stream()
                .filter(one -> one.id().equals(new VirtualDroneId(id)))
                .flatMap(one -> one.runs().stream())
                .findFirst()
                .orElseThrow();
    }

    private static Optional<JournalReplay.Difference> differenceIn(UpgradedServer now, SavedOperation operation) {
        OperationComponents side = now.house().runs();
        return operation.kind().equals(side.kind().name())
                ? differenceIn(now, operation, side.kind())
                : differenceIn(now, operation, side.follows());
    }

    private static <S, I> Optional<JournalReplay.Difference> differenceIn(
            UpgradedServer now, SavedOperation operation, OperationKind<S, I> kind) {
        JournalReplay<S, I> replay = new JournalReplay<>(kind);
        replay.replay(now.database().operations().journal(operation.id(), 0, Integer.MAX_VALUE));
        assertThat(replay.difference().isPresent() || replay.count() == operation.last() + 1)
                .isTrue();
        return replay.difference();
    }

    private static List<SavedOperation> operations(UpgradedServer now) {
        OperationComponents side = now.house().runs();
        return Stream.of(side.kind(), side.follows())
                .flatMap(kind -> side.operations().latest(OrganisationId.HOME, kind, MOST).stream())
                .toList();
    }

    private static List<AccessKey> keys(UpgradedServer now) {
        return now.database().access().accessKeys(pilot(now));
    }

    private static String pilot(UpgradedServer now) {
        return now.facts().required("account").required("name").stringValue();
    }

    private static String shown(UpgradedServer now, String what) {
        return now.facts().required("shown").required(what).stringValue();
    }

    private static String underWay(UpgradedServer now, String what) {
        return now.facts().required("underWay").required(what).stringValue();
    }

    /** That version need not have had that table. */
    private static int rowsOrNone(UpgradedServer now, String table) {
        return now.hasTable(table) ? rows(now, table) : 0;
    }

    private static int rows(UpgradedServer now, String table) {
        return Math.toIntExact(now.rows(table));
    }
}
