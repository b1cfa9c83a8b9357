package org.dronemap.ws.house;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.dronemap.cognitive.follow.Apart;
import org.dronemap.core.access.AccessKey;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.AccountState;
import org.dronemap.core.access.GrantBook;
import org.dronemap.core.access.KeyRights;
import org.dronemap.core.access.KeyScope;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.User;
import org.dronemap.core.audit.AuditChain;
import org.dronemap.core.audit.AuditRecord;
import org.dronemap.core.audit.AuditStore;
import org.dronemap.core.audit.AuditedCommands;
import org.dronemap.core.audit.HeadKeeper;
import org.dronemap.core.cloud.AuditedControl;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.Journal;
import org.dronemap.core.cloud.Lanes;
import org.dronemap.core.cloud.Watchdog;
import org.dronemap.core.conduct.AuditedBindings;
import org.dronemap.core.conduct.VirtualDrones;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.history.FlightLog;
import org.dronemap.core.history.History;
import org.dronemap.core.history.HistoryKeeper;
import org.dronemap.core.history.HistoryPolicy;
import org.dronemap.core.history.Retention;
import org.dronemap.core.history.TelemetryWriter;
import org.dronemap.core.lease.LeaseRules;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.core.process.Beginning;
import org.dronemap.core.recording.RecordingPolicy;
import org.dronemap.core.time.SystemTime;
import org.dronemap.core.time.Time;
import org.dronemap.core.virtual.RunMachine;
import org.dronemap.proxy.record.Recorder;
import org.dronemap.proxy.session.Enrolment;
import org.dronemap.store.file.HeadsFile;
import org.dronemap.store.memory.MemoryAuditStore;
import org.dronemap.store.memory.MemoryRecordingStore;
import org.dronemap.store.secret.HmacSeal;
import org.dronemap.store.secret.SecretBox;
import org.dronemap.ws.account.PasswordHashing;
import org.dronemap.ws.budget.Rates;
import org.dronemap.ws.follow.AccountRights;
import org.dronemap.ws.guard.ClientLimits;
import org.dronemap.ws.link.DtlsKeyRing;
import org.dronemap.ws.reading.Secrets;
import org.dronemap.ws.robotkey.RobotKeyRing;
import org.dronemap.ws.security.Argon2Passwords;
import org.dronemap.ws.security.oidc.OidcSettings;
import org.dronemap.ws.server.BoxSealing;
import org.dronemap.ws.server.House;
import org.dronemap.ws.server.RunSide;
import org.dronemap.ws.settings.OutletSettings;
import org.dronemap.ws.settings.RobotSettings;
import org.dronemap.ws.settings.Settings;
import org.dronemap.ws.user.Registration;
import org.dronemap.ws.wiring.FacesServer;
import org.jspecify.annotations.Nullable;
import org.springframework.context.ConfigurableApplicationContext;

/** All faces on free ports over stores in memory. */
public final class TestHouse implements AutoCloseable {
    /** Scripted vehicles speak only when a test says so. */
    private static final Watchdog PATIENT =
            new Watchdog(Duration.ofMinutes(5), Duration.ofMinutes(5), Duration.ofMinutes(5), Duration.ofMinutes(10));

    private static final TelemetryWriter.Rhythm EAGER =
            new TelemetryWriter.Rhythm(Duration.ofMillis(10), 1_000, 10_000, Duration.ofMillis(10));

    /** Each step of a virtual drone waits for the next look. */
    private static final Duration RHYTHM_OF_VIRTUALS = Duration.ofMillis(40);

    private static final Settings.Protection PATIENT_WITH_ALL =
            new Settings.Protection(ClientLimits.DEFAULT, Rates.UNBOUNDED);

    private final Time time = new SystemTime();
    private final Lanes lanes = new Lanes(time, 2);
    private final Journal journal = new Journal(time);
    private final SwitchedStores stores = new SwitchedStores();
    private final AccessStore access = stores.access;
    private final RobotKeyRing robotKeys = new RobotKeyRing(stores.links);
    private final ListedLinks links = new ListedLinks();
    private final AtomicInteger ids = new AtomicInteger();
    /** Thousands are made in tests: not as dear as a server's. */
    private static final PasswordHashing QUICK_PASSWORDS = new Argon2Passwords(64, 1);

    private final CloudManager cloud;
    private final SteppingClock clock = new SteppingClock();
    private final GrantBook grants = new GrantBook(clock);
    private final House.AuditSide audit;
    private final ConfigurableApplicationContext faces;
    private volatile boolean connected = true;
    private final VirtualDrones virtuals;
    private final RunSide runs;
    private final Path data;
    private final Recorder recorder;
    private final TelemetryWriter telemetry = new TelemetryWriter(stores.telemetry, EAGER, time);
    private final FlightLog flights = new FlightLog(stores.flights, Duration.ofMillis(10), time);
    private final History history;

    public TestHouse(Path data, boolean publicMode) {
        this(data, publicMode, Registration.APPROVAL);
    }

    public TestHouse(Path data, boolean publicMode, Registration registration) {
        this(data, new Choices(publicMode, registration, PATIENT_WITH_ALL, null, null));
    }

    /** What a test wants otherwise than usual. */
    public record Choices(
            boolean publicMode,
            Registration registration,
            Settings.Protection protection,
            Settings.@Nullable Tls tls,
            @Nullable OidcSettings oidc) {
        /** On this machine, bounding clients like this. */
        public static Choices protectedBy(Settings.Protection protection) {
            return new Choices(false, Registration.APPROVAL, protection, null, null);
        }

        /** On this machine, with a provider to sign in with. */
        public static Choices signingInWith(OidcSettings oidc) {
            return new Choices(false, Registration.APPROVAL, PATIENT_WITH_ALL, null, oidc);
        }
    }

    public TestHouse(Path data, Choices choices) {
        ServerStarts.count();
        this.data = data;
        audit = auditSide();
        cloud = new CloudManager(lanes, PATIENT, time, keeping(), () -> new DroneId("drone-" + ids.incrementAndGet()));
        cloud.addListener(new AuditedControl(audit.store(), Clock.systemUTC(), grants::owner));
        recorder = new Recorder(
                data.resolve("recordings"),
                RecordingPolicy.DEFAULT,
                new Recorder.Keeping(new MemoryRecordingStore(), journal, DroneId::value),
                time);
        startRecorder();
        history = history();
        virtuals = virtuals();
        runs = RunSide.of(cloud, stores.operations, new AccountRights(access, grants, time), Apart.USUAL, time);
        runs.operations().takeUp();
        runs.operations().goOn();
        House house = new House(
                time,
                cloud,
                access,
                stores.missions,
                stores.zones,
                new CountingRecordings(),
                recorder.shelf(),
                history,
                linkSide(),
                () -> true,
                file -> Files.write(file, "a backup".getBytes(StandardCharsets.UTF_8)),
                new RecordedLinkSecurity(),
                stores.grants,
                grants,
                virtuals,
                runs,
                audit,
                QUICK_PASSWORDS,
                List.of(),
                Beginning.ORDINARY);
        faces = SeenStatuses.watch(FacesServer.start(settings(choices), house));
    }

    private VirtualDrones virtuals() {
        VirtualDrones made = new VirtualDrones(
                cloud,
                stores.virtuals,
                new RunMachine(RunMachine.USUAL_SILENCE),
                new AccountRights(access, grants, time),
                RHYTHM_OF_VIRTUALS,
                time);
        made.addListener(new AuditedBindings(audit.store(), Clock.systemUTC(), made.all()));
        made.start();
        return made;
    }

    private History history() {
        HistoryKeeper keeper = new HistoryKeeper(stores.telemetry, Retention.DEFAULT, time);
        History made = new History(
                new History.Keeping(stores.telemetry, telemetry, flights, keeper),
                HistoryPolicy.DEFAULT,
                Clock.systemUTC(),
                () -> "flight-" + ids.incrementAndGet());
        telemetry.start();
        flights.start();
        made.start();
        cloud.addListener(made);
        return made;
    }

    private CloudManager.Keeping keeping() {
        return new CloudManager.Keeping(
                stores.drones,
                new AuditedCommands(stores.commands, audit.store(), System::nanoTime),
                stores.leases,
                stores.owners,
                journal);
    }

    private House.AuditSide auditSide() {
        AuditChain chain = new AuditChain(new HmacSeal(new byte[] {1}));
        AuditStore store = new MemoryAuditStore(chain);
        HeadsFile heads = new HeadsFile(data.resolve("audit-heads"));
        HeadKeeper keeper = new HeadKeeper(store, heads, chain, time);
        keeper.start();
        return new House.AuditSide(store, heads, chain, keeper);
    }

    /** Every record that was left so far, in order. */
    public List<AuditRecord> records() {
        return audit.store().after(0, Integer.MAX_VALUE);
    }

    private Settings settings(Choices choices) {
        return new Settings(
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
                RunMachine.USUAL_SILENCE,
                Apart.USUAL,
                false);
    }

    private void startRecorder() {
        try {
            recorder.start();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Of all but what is remembered of drones, and the record of calls. */
    public StoreSwitch stores() {
        return stores.all;
    }

    /** Of what is remembered of drones. */
    public StoreSwitch historyStores() {
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

    private House.LinkSide linkSide() {
        BoxSealing sealing = new BoxSealing(new SecretBox(new byte[SecretBox.SECRET_BYTES]));
        return new House.LinkSide(
                links,
                stores.links,
                new DtlsKeyRing(stores.links, sealing),
                robotKeys,
                new ListedClients(),
                () -> connected);
    }

    public RunSide runs() {
        return runs;
    }

    /** The time that grants go by. */
    public SteppingClock clock() {
        return clock;
    }

    public GrantBook grants() {
        return grants;
    }

    public CloudManager cloud() {
        return cloud;
    }

    /** The ways in for vehicles, which open nothing here. */
    public ListedLinks links() {
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
        return key(new KeyRights(role, KeyScope.ALL, null));
    }

    /** An access key with these rights, of a new user with their role. */
    public String key(KeyRights rights) {
        return key(OrganisationId.HOME, rights);
    }

    /** The same of a new user of that organisation. */
    public String key(OrganisationId organisation, KeyRights rights) {
        String name = "user" + ids.incrementAndGet();
        return keyOf(new User(name, rights.role(), AccountState.ACTIVE, "none", false, organisation), rights);
    }

    private String keyOf(User user, KeyRights rights) {
        String secret = new Secrets().token();
        if (!access.addUser(user)) {
            throw new IllegalStateException("the user " + user.name() + " was there already");
        }
        access.addAccessKey(new AccessKey(
                "key-" + user.name(),
                "test",
                user.name(),
                null,
                rights,
                Secrets.hash(secret),
                Clock.systemUTC().instant(),
                null));
        return secret;
    }

    /** The id of that user's account. */
    public String account(String name) {
        return access.user(name).orElseThrow().account();
    }

    /** One that no other thing of this house has. */
    public int number() {
        return ids.incrementAndGet();
    }

    /** A new user of an organisation, with this role and a key that may as much. */
    public Member member(OrganisationId organisation, String name, Role role) {
        User user = new User(name, role, AccountState.ACTIVE, "none", false, organisation);
        String secret = keyOf(user, new KeyRights(role, KeyScope.ALL, null));
        return new Member(name, secret, new Http(this, secret));
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
