package org.dronemap.ws.testserver;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import org.dronemap.core.access.AccessKey;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.AccountState;
import org.dronemap.core.access.GrantRegistry;
import org.dronemap.core.access.KeyRights;
import org.dronemap.core.access.KeyScope;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.User;
import org.dronemap.core.audit.AuditChain;
import org.dronemap.core.audit.AuditHeadWriter;
import org.dronemap.core.audit.AuditRecord;
import org.dronemap.core.audit.AuditRecorder;
import org.dronemap.core.audit.AuditStore;
import org.dronemap.core.audit.AuditedCommandStore;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.ControlAuditListener;
import org.dronemap.core.cloud.lane.Lanes;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.cloud.lane.Watchdog;
import org.dronemap.core.conduct.BindingAuditListener;
import org.dronemap.core.conduct.VirtualDrones;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.history.FlightRegistry;
import org.dronemap.core.history.HistoryMaintenance;
import org.dronemap.core.history.HistoryPolicy;
import org.dronemap.core.history.HistoryRecorder;
import org.dronemap.core.history.Retention;
import org.dronemap.core.history.TelemetryWriter;
import org.dronemap.core.lease.LeaseRules;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.core.process.ProcessStart;
import org.dronemap.core.recording.RecordingPolicy;
import org.dronemap.core.separation.Separation;
import org.dronemap.core.separation.SeparationBoard;
import org.dronemap.core.time.RealTime;
import org.dronemap.core.time.Time;
import org.dronemap.core.virtual.VirtualRunMachine;
import org.dronemap.proxy.record.Recorder;
import org.dronemap.proxy.session.Enrolment;
import org.dronemap.store.file.FileAuditHeadStore;
import org.dronemap.store.memory.MemoryAuditStore;
import org.dronemap.store.memory.MemoryRecordingStore;
import org.dronemap.store.secret.HmacKeyedHash;
import org.dronemap.store.secret.SecretBox;
import org.dronemap.ws.account.PasswordHashing;
import org.dronemap.ws.budget.BudgetRates;
import org.dronemap.ws.environment.EnvironmentVariables;
import org.dronemap.ws.limit.ClientLimits;
import org.dronemap.ws.link.DtlsKeyRing;
import org.dronemap.ws.operation.OwnerRightsCache;
import org.dronemap.ws.reading.SecretGenerator;
import org.dronemap.ws.robotkey.RobotKeyRing;
import org.dronemap.ws.security.Argon2Passwords;
import org.dronemap.ws.security.oidc.OidcSettings;
import org.dronemap.ws.server.OperationComponents;
import org.dronemap.ws.server.SecretBoxEncryption;
import org.dronemap.ws.server.ServerComponents;
import org.dronemap.ws.settings.OutletSettings;
import org.dronemap.ws.settings.RobotSettings;
import org.dronemap.ws.settings.ServerSettings;
import org.dronemap.ws.user.RegistrationPolicy;
import org.dronemap.ws.wiring.FacesServer;
import org.jspecify.annotations.Nullable;
import org.springframework.context.ConfigurableApplicationContext;

/** All faces on free ports over stores in memory. */
public final class TestServer implements AutoCloseable {
    /** Scripted vehicles speak only when a test says so. */
    private static final Watchdog PATIENT =
            new Watchdog(Duration.ofMinutes(5), Duration.ofMinutes(5), Duration.ofMinutes(5), Duration.ofMinutes(10));

    private static final TelemetryWriter.BatchSettings EAGER =
            new TelemetryWriter.BatchSettings(Duration.ofMillis(10), 1_000, 10_000, Duration.ofMillis(10));

    private static final Duration RHYTHM_OF_VIRTUALS = Duration.ofMillis(40);
    private static final ServerSettings.Protection PATIENT_WITH_ALL =
            new ServerSettings.Protection(ClientLimits.DEFAULT, BudgetRates.UNBOUNDED);

    /** Each test that shares a server has an organisation of its own. */
    private static final EnvironmentVariables MANY_TENANTS =
            new EnvironmentVariables(Map.of("DRONEMAP_ORGANISATIONS", "10000"));

    private final Time time = new RealTime();
    private final Lanes lanes = new Lanes(time, 2);
    private final StoreWriter journal = new StoreWriter(time);
    private final FaultSwitchedStores stores = new FaultSwitchedStores();
    private final AccessStore access = stores.access;
    private final RobotKeyRing robotKeys = new RobotKeyRing(stores.links);
    private final FakeVehicleLinkGateway links = new FakeVehicleLinkGateway();
    private final AtomicInteger ids = new AtomicInteger();
    /** Thousands are made in tests: not as dear as a server's. */
    private static final PasswordHashing QUICK_PASSWORDS = new Argon2Passwords(64, 1);

    private final CloudManager cloud;
    private final AdjustableClock clock = new AdjustableClock();
    private final GrantRegistry grants = new GrantRegistry(clock);
    private final ServerComponents.AuditComponents audit;
    private final ConfigurableApplicationContext faces;
    private volatile boolean connected = true;
    private final VirtualDrones virtuals;
    private final OperationComponents runs;
    private final Path data;
    private final Recorder recorder;
    private final TelemetryWriter telemetry = new TelemetryWriter(stores.telemetry, EAGER, time);
    private final FlightRegistry flights = new FlightRegistry(stores.flights, Duration.ofMillis(10), time);
    private final HistoryRecorder history;

    public TestServer(Path data, boolean publicMode) {
        this(data, publicMode, RegistrationPolicy.APPROVAL);
    }

    public TestServer(Path data, boolean publicMode, RegistrationPolicy registration) {
        this(data, new Options(publicMode, registration, PATIENT_WITH_ALL, null, null));
    }

    /** What a test wants otherwise than usual. */
    public record Options(
            boolean publicMode,
            RegistrationPolicy registration,
            ServerSettings.Protection protection,
            ServerSettings.@Nullable Tls tls,
            @Nullable OidcSettings oidc) {
        /** On this machine, bounding clients like this. */
        public static Options protectedBy(ServerSettings.Protection protection) {
            return new Options(false, RegistrationPolicy.APPROVAL, protection, null, null);
        }

        /** On this machine, with a provider to sign in with. */
        public static Options signingInWith(OidcSettings oidc) {
            return new Options(false, RegistrationPolicy.APPROVAL, PATIENT_WITH_ALL, null, oidc);
        }
    }

    public TestServer(Path data, Options choices) {
        ServerStartCounter.count();
        this.data = data;
        audit = auditSide();
        cloud = new CloudManager(lanes, PATIENT, time, keeping(), () -> new DroneId("drone-" + ids.incrementAndGet()));
        cloud.zones().ownersBy(grants::owner);
        cloud.addListener(new ControlAuditListener(audit.store(), Clock.systemUTC(), grants::owner));
        recorder = startedRecorder();
        history = history();
        virtuals = virtuals();
        OwnerRightsCache rights = new OwnerRightsCache(access, grants, time);
        runs = OperationComponents.of(cloud, stores.operations, rights, Separation.USUAL, new SeparationBoard(), time);
        runs.operations().restore();
        runs.operations().goOn();
        ServerComponents house = new ServerComponents(
                time,
                cloud,
                access,
                stores.missions,
                stores.zones,
                new CountingReplayGateway(),
                recorder.archive(),
                history,
                linkSide(),
                () -> true,
                file -> Files.write(file, "a backup".getBytes(StandardCharsets.UTF_8)),
                new FakeLinkSecurityGateway(),
                stores.grants,
                grants,
                virtuals,
                runs,
                audit,
                QUICK_PASSWORDS,
                List.of(),
                ProcessStart.ORDINARY);
        faces = StatusRecordingValve.watch(FacesServer.start(settings(choices), MANY_TENANTS, house));
    }

    private VirtualDrones virtuals() {
        VirtualDrones made = new VirtualDrones(
                cloud,
                stores.virtuals,
                new VirtualRunMachine(VirtualRunMachine.USUAL_SILENCE),
                new OwnerRightsCache(access, grants, time),
                new SeparationBoard(),
                RHYTHM_OF_VIRTUALS,
                time);
        made.addListener(new BindingAuditListener(audit.store(), Clock.systemUTC(), made.all()));
        made.start();
        return made;
    }

    private HistoryRecorder history() {
        HistoryMaintenance keeper = new HistoryMaintenance(stores.telemetry, Retention.DEFAULT, time);
        HistoryRecorder made = new HistoryRecorder(
                new HistoryRecorder.Persistence(stores.telemetry, telemetry, flights, keeper),
                HistoryPolicy.DEFAULT,
                Clock.systemUTC(),
                () -> "flight-" + ids.incrementAndGet());
        telemetry.start();
        flights.start();
        made.start();
        cloud.addListener(made);
        return made;
    }

    private CloudManager.Persistence keeping() {
        return new CloudManager.Persistence(
                stores.drones,
                new AuditedCommandStore(stores.commands, audit.store(), System::nanoTime),
                stores.leases,
                stores.owners,
                journal);
    }

    private ServerComponents.AuditComponents auditSide() {
        AuditChain chain = new AuditChain(new HmacKeyedHash(new byte[] {1}));
        AuditStore store = new MemoryAuditStore(chain);
        FileAuditHeadStore heads = new FileAuditHeadStore(data.resolve("audit-heads"));
        AuditHeadWriter keeper = new AuditHeadWriter(store, heads, chain, time);
        keeper.start();
        AuditRecorder recorder = new AuditRecorder(store, Clock.systemUTC(), System::nanoTime, 1_000_000_000);
        return new ServerComponents.AuditComponents(store, heads, chain, keeper, recorder);
    }

    public List<AuditRecord> records() {
        return audit.store().after(0, Integer.MAX_VALUE);
    }

    private ServerSettings settings(Options choices) {
        return new ServerSettings(
                data,
                "127.0.0.1",
                0,
                0,
                List.of(),
                OutletSettings.OFF,
                RobotSettings.OFF,
                Enrolment.LOOPBACK,
                null,
                choices.publicMode(),
                choices.tls(),
                "https://tiles.example/{z}/{x}/{y}",
                PATIENT,
                LeaseRules.DEFAULT,
                CloudManager.Rules.USUAL_LOSS_SECONDS,
                RecordingPolicy.DEFAULT,
                HistoryPolicy.DEFAULT,
                null,
                null,
                null,
                choices.registration(),
                choices.protection(),
                choices.oidc(),
                VirtualRunMachine.USUAL_SILENCE,
                Separation.USUAL,
                false);
    }

    private Recorder startedRecorder() {
        Recorder made = new Recorder(
                data.resolve("recordings"),
                RecordingPolicy.DEFAULT,
                new Recorder.Dependencies(new MemoryRecordingStore(), journal, DroneId::value),
                time);
        try {
            made.start();
            return made;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Of all but what is remembered of drones, and the record of calls. */
    public StoreFaultSwitch stores() {
        return stores.all;
    }

    /** Of what is remembered of drones. */
    public StoreFaultSwitch historyStores() {
        return stores.history;
    }

    public Recorder recorder() {
        return recorder;
    }

    /** As the links to robots ask for them. */
    public RobotKeyRing robotKeys() {
        return robotKeys;
    }

    /** As if the ports for vehicles listened, or did not. */
    public void connected(boolean listening) {
        connected = listening;
    }

    private ServerComponents.LinkComponents linkSide() {
        return new ServerComponents.LinkComponents(
                links,
                stores.links,
                new DtlsKeyRing(stores.links, new SecretBoxEncryption(new SecretBox(new byte[SecretBox.SECRET_BYTES]))),
                robotKeys,
                new FakeOutletGateway(),
                () -> connected);
    }

    public OperationComponents runs() {
        return runs;
    }

    /** The time that grants go by. */
    public AdjustableClock clock() {
        return clock;
    }

    public GrantRegistry grants() {
        return grants;
    }

    public CloudManager cloud() {
        return cloud;
    }

    public FakeVehicleLinkGateway links() {
        return links;
    }

    public Path data() {
        return data;
    }

    public int httpPort() {
        return Integer.parseInt(String.valueOf(faces.getEnvironment().getProperty("local.server.port")));
    }

    public <T> T bean(Class<T> type) {
        return faces.getBean(type);
    }

    /** An access key of a new user with this role. */
    public String key(Role role) {
        return key(OrganisationId.HOME, new KeyRights(role, KeyScope.ALL, null));
    }

    /** The same of a new user of that organisation. */
    public String key(OrganisationId organisation, KeyRights rights) {
        String name = "user" + ids.incrementAndGet();
        return keyOf(new User(name, rights.role(), AccountState.ACTIVE, "none", false, organisation), rights);
    }

    private String keyOf(User user, KeyRights rights) {
        String secret = new SecretGenerator().token();
        if (!access.addUser(user)) {
            throw new IllegalStateException("the user " + user.name() + " was there already");
        }
        access.addAccessKey(new AccessKey(
                "key-" + user.name(),
                "test",
                user.name(),
                null,
                rights,
                SecretGenerator.hash(secret),
                Clock.systemUTC().instant(),
                null));
        return secret;
    }

    public String account(String name) {
        return access.user(name).orElseThrow().account();
    }

    public int number() {
        return ids.incrementAndGet();
    }

    public OrganisationMember member(OrganisationId organisation, String name, Role role) {
        User user = new User(name, role, AccountState.ACTIVE, "none", false, organisation);
        String secret = keyOf(user, new KeyRights(role, KeyScope.ALL, null));
        return new OrganisationMember(name, secret, new TestHttpClient(this, secret));
    }

    @Override
    public void close() {
        faces.close();
        runs.operations().close();
        virtuals.close();
        recorder.close();
        telemetry.close();
        flights.close();
        lanes.close();
        journal.close();
        audit.keeper().close();
    }
}
