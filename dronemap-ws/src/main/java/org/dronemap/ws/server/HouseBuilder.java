package org.dronemap.ws.server;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.function.Supplier;
import javax.net.ssl.SSLContext;
import org.dronemap.core.access.GrantBook;
import org.dronemap.core.audit.AuditDesk;
import org.dronemap.core.audit.AuditedCommands;
import org.dronemap.core.cloud.AuditedControl;
import org.dronemap.core.cloud.CloudListener;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.Journal;
import org.dronemap.core.cloud.Lane;
import org.dronemap.core.cloud.Lanes;
import org.dronemap.core.command.CommandStore;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.conduct.AuditedBindings;
import org.dronemap.core.conduct.Operations;
import org.dronemap.core.conduct.VirtualDrones;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.history.History;
import org.dronemap.core.history.TelemetryStore;
import org.dronemap.core.link.LinkStore;
import org.dronemap.core.link.SavedLink;
import org.dronemap.core.process.Beginning;
import org.dronemap.core.time.Time;
import org.dronemap.core.virtual.RunMachine;
import org.dronemap.proxy.Proxy;
import org.dronemap.proxy.endpoint.Doors;
import org.dronemap.proxy.endpoint.EndpointUrl;
import org.dronemap.proxy.endpoint.PeerHandler;
import org.dronemap.proxy.endpoint.WebSocketDoor;
import org.dronemap.proxy.outlet.Outlet;
import org.dronemap.proxy.record.Recorder;
import org.dronemap.proxy.roslink.RoslinkProxy;
import org.dronemap.proxy.session.FrameTap;
import org.dronemap.proxy.signing.Keyrings;
import org.dronemap.store.Stores;
import org.dronemap.store.mongo.MongoTelemetryStore;
import org.dronemap.store.secret.SecretBox;
import org.dronemap.store.secret.ServerSecret;
import org.dronemap.ws.follow.AccountRights;
import org.dronemap.ws.link.DtlsKeyRing;
import org.dronemap.ws.robotkey.RobotKeyRing;
import org.dronemap.ws.security.Argon2Passwords;
import org.dronemap.ws.setting.SetupException;
import org.dronemap.ws.settings.OutletSettings;
import org.dronemap.ws.settings.Settings;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Builds what is around the cloud manager: stores, journal and lanes behind the faces, links to vehicles before them. */
final class HouseBuilder {
    private static final Logger LOG = LoggerFactory.getLogger(HouseBuilder.class);
    private static final int LANES = 2;
    private static final String SET_ASIDE =
            "The server ended three times within two minutes, and started without what it was conducting.";

    private final Settings settings;
    private final Closing closing;
    private final List<EndpointUrl> endpoints;
    private final Time time;
    private final Beginning beginning;
    private final Lanes lanes;
    private final OutletBuilder outlets;
    private final RobotBuilder robots;
    private @Nullable Outlet outlet;
    private @Nullable Proxy proxy;
    private @Nullable RoslinkProxy robotLinks;
    private @Nullable LinkStore savedLinks;
    private @Nullable Operations operations;
    private volatile boolean connected;

    /** What is opened is handed to {@code closing} as it opens, so that a failed start leaves nothing behind. */
    HouseBuilder(Settings settings, Closing closing, Time time, Beginning beginning) {
        this.settings = settings;
        this.beginning = beginning;
        this.time = time;
        this.lanes = new Lanes(time, LANES);
        this.closing = closing;
        this.endpoints =
                settings.endpoints().stream().map(HouseBuilder::endpoint).toList();
        this.outlets = new OutletBuilder(settings.outlet(), time);
        this.robots = new RobotBuilder(settings.robots(), time);
    }

    List<Lane> lanes() {
        return lanes.all();
    }

    /** Everything but the links: nothing is heard and nothing sent yet. */
    House open(Stores stores) {
        House.AuditSide audit = new AuditBuilder(settings, time).open(stores, closing);
        CommandStore commands = commands(stores, audit);
        Journal journal = new Journal(time);
        closing.add("the journal", journal);
        CloudManager cloud = cloud(stores, commands, journal);
        GrantBook grants = grants(stores, cloud, audit);
        History history = history(stores, cloud);
        SecretBox box = box();
        DtlsKeyRing dtlsKeys = new DtlsKeyRing(stores.links(), new BoxSealing(box));
        Recorder recorder = recorder(stores, journal, cloud);
        Outlet clients = outlet(control(cloud, audit), stores, journal, box, grants, doors(dtlsKeys));
        Keyrings keyrings = keyrings(cloud, stores, journal, box);
        Proxy links = links(cloud, keyrings, taps(recorder, clients), doors(dtlsKeys), stores.links());
        RobotKeyRing robotKeys = new RobotKeyRing(stores.links());
        RoslinkProxy robotSide = robots(cloud, recorder, robotKeys, doors(dtlsKeys));
        VirtualDrones virtuals = virtualDrones(cloud, stores, grants, audit);
        RunSide runs = runs(cloud, stores, grants);
        return new House(
                time,
                cloud,
                stores.access(),
                stores.missions(),
                stores.zones(),
                new ProxyRecordings(links.replays()),
                recorder.shelf(),
                history,
                linkSide(new ProxyLinks(links, robotSide), stores, dtlsKeys, robotKeys, clients),
                stores::isUp,
                file -> writeBackup(stores, file),
                new ProxyLinkSecurity(links.keyrings()),
                stores.grants(),
                grants,
                virtuals,
                runs,
                audit,
                new Argon2Passwords(),
                new Parts(lanes, journal, virtuals, runs.operations(), links.links(), robotSide).all(),
                beginning);
    }

    private House.LinkSide linkSide(
            ProxyLinks vehicles, Stores stores, DtlsKeyRing dtlsKeys, RobotKeyRing robotKeys, Outlet clients) {
        return new House.LinkSide(
                vehicles, stores.links(), dtlsKeys, robotKeys, new ProxyOutlet(clients), () -> connected);
    }

    private History history(Stores stores, CloudManager cloud) {
        return new HistoryBuilder(settings.history(), time).open(telemetry(stores), stores.flights(), cloud, closing);
    }

    private Proxy links(CloudManager cloud, Keyrings keyrings, FrameTap.Factory taps, Doors doors, LinkStore saved) {
        Proxy.Policy policy = new Proxy.Policy(keyrings, taps, doors, settings.enrolment());
        Proxy links = new Proxy(cloud, lanes, endpoints, policy, time);
        closing.add("the links", links);
        proxy = links;
        savedLinks = saved;
        return links;
    }

    private AuditedOutletControl control(CloudManager cloud, House.AuditSide audit) {
        return new AuditedOutletControl(cloud, new AuditDesk(audit.store(), time.clock(), time::nanos));
    }

    private RoslinkProxy robots(CloudManager cloud, Recorder recorder, RobotKeyRing keys, Doors doors) {
        RoslinkProxy.Policy policy =
                new RoslinkProxy.Policy(new IssuedKeys(keys), recorder::openLines, doors, settings.enrolment());
        RoslinkProxy built = robots.build(cloud, lanes, policy);
        closing.add("the links to robots", built);
        robotLinks = built;
        return built;
    }

    private Outlet outlet(
            AuditedOutletControl control,
            Stores stores,
            Journal journal,
            SecretBox box,
            GrantBook grants,
            Doors doors) {
        OutletBuilder.AccountOutletRights rights = new OutletBuilder.AccountOutletRights(stores.access(), grants);
        Outlet clients = outlets.build(control, stores.outlet(box), journal, rights, doors);
        closing.add("the outlet", clients);
        outlet = clients;
        return clients;
    }

    private FrameTap.Factory taps(Recorder recorder, Outlet clients) {
        return settings.outlet().equals(OutletSettings.OFF)
                ? recorder
                : component -> FrameTap.both(recorder.open(component), clients.open(component));
    }

    private CloudManager cloud(Stores stores, CommandStore commands, Journal journal) {
        closing.add("the lanes", lanes);
        return new CloudManager(
                lanes,
                new CloudManager.Rules(settings.watchdog(), settings.control(), settings.lossSeconds()),
                time,
                new CloudManager.Keeping(stores.drones(), commands, stores.leases(), stores.owners(), journal),
                new DroneIds(time.random()));
    }

    /** In force before anybody can ask, or any vehicle is heard. */
    private GrantBook grants(Stores stores, CloudManager cloud, House.AuditSide audit) {
        GrantBook grants = new GrantBook(time.clock());
        grants.replace(stores.grants().holdings());
        cloud.zones().ownersBy(grants::owner);
        cloud.zones().put(stores.zones().zones());
        cloud.addListener(new AuditedControl(audit.store(), time.clock(), grants::owner));
        return grants;
    }

    /** Takes up what was under way, before any vehicle is heard and anybody else can command. */
    private VirtualDrones virtualDrones(CloudManager cloud, Stores stores, GrantBook grants, House.AuditSide audit) {
        VirtualDrones virtuals = new VirtualDrones(
                cloud,
                stores.virtualDrones(),
                new RunMachine(settings.virtualSilence()),
                new AccountRights(stores.access(), grants, time),
                time);
        virtuals.addListener(new AuditedBindings(audit.store(), time.clock(), virtuals.all()));
        if (beginning.precautions().careful()) {
            virtuals.startSuspended(SET_ASIDE);
        } else {
            virtuals.start();
        }
        closing.add("the virtual drones", virtuals);
        return virtuals;
    }

    /** As for virtual drones. */
    private RunSide runs(CloudManager cloud, Stores stores, GrantBook grants) {
        RunSide runs = RunSide.of(
                cloud, stores.operations(), new AccountRights(stores.access(), grants, time), settings.apart(), time);
        if (beginning.precautions().careful()) {
            runs.operations().setAside(SET_ASIDE);
        } else {
            runs.operations().takeUp();
        }
        operations = runs.operations();
        closing.add("the operations", runs.operations());
        return runs;
    }

    private SecretBox box() {
        return ServerSecret.box(
                Settings.Hidden.shown(settings.linkSecret()),
                settings.dataDirectory().resolve("link-secret"));
    }

    private CommandStore commands(Stores stores, House.AuditSide audit) {
        CommandStore commands = new AuditedCommands(stores.commands(), audit.store(), time::nanos);
        int ended = commands.endUnfinished(
                new Outcome.Unknown("The server restarted while it was under way."),
                time.clock().instant());
        if (ended > 0) {
            LOG.warn("{} commands were under way when the server stopped; their outcome is unknown", ended);
        }
        return commands;
    }

    private Doors doors(DtlsKeyRing keys) {
        Settings.Tls tls = settings.tls();
        Supplier<@Nullable SSLContext> certificate = tls == null ? () -> null : Certificate.of(tls)::current;
        return new Doors(keys::secret, certificate, WebSocketDoor.Limits.DEFAULT, beginning.watch());
    }

    private Keyrings keyrings(CloudManager cloud, Stores stores, Journal journal, SecretBox box) {
        Keyrings keyrings = new Keyrings(
                new Keyrings.Keeping(
                        stores.linkSecurity(box),
                        journal,
                        drone -> cloud.drone(drone)
                                .map(state -> state.link().key().systemId())
                                .orElse(-1),
                        (drone, sentence) -> cloud.say(drone, Severity.WARNING, sentence)),
                time);
        closing.add("the keys", keyrings);
        cloud.addListener(new ForgottenDrones(keyrings));
        return keyrings;
    }

    /** A drone that is removed takes its keys along. */
    private record ForgottenDrones(Keyrings keyrings) implements CloudListener {
        @Override
        public void droneRemoved(DroneId id) {
            keyrings.removed(id);
        }
    }

    private TelemetryStore telemetry(Stores stores) {
        String url = Settings.Hidden.shown(settings.mongodbUrl());
        if (url == null) {
            return stores.telemetry();
        }
        MongoTelemetryStore store = MongoTelemetryStore.open(url);
        closing.add("the MongoDB", store);
        return store;
    }

    private Recorder recorder(Stores stores, Journal journal, CloudManager cloud) {
        Path directory = settings.dataDirectory().resolve("recordings");
        Recorder recorder = new Recorder(
                directory,
                settings.recording(),
                new Recorder.Keeping(
                        stores.recordings(),
                        journal,
                        id -> cloud.drone(id).map(DroneState::name).orElse(id.value())),
                time);
        try {
            recorder.start();
        } catch (IOException e) {
            throw new SetupException("Recordings cannot be kept in " + directory + ": " + e.getMessage(), e);
        }
        closing.add("the recorder", recorder);
        return recorder;
    }

    private static void writeBackup(Stores stores, Path file) throws IOException {
        try (OutputStream out = Files.newOutputStream(file)) {
            stores.backUp(out);
        }
    }

    /**
     * Lets vehicles and robots in, and goes on with what was under way. Those in the air fly home when they miss the server for
     * five seconds: they do not wait for the faces, which take longer than that to start.
     */
    void hear() {
        if (robotLinks != null) {
            robots.open(robotLinks);
        }
        try {
            if (proxy != null && savedLinks != null) {
                proxy.start();
                addSaved(proxy, savedLinks);
            }
        } catch (IOException e) {
            throw new SetupException(e.getMessage() + " (DRONEMAP_ENDPOINTS)", e);
        }
        if (operations != null) {
            operations.goOn();
        }
        LOG.info("Vehicles are heard");
    }

    /** Takes in the bytes of links to vehicles, once the house is open. */
    PeerHandler.Factory vehicles() {
        return Objects.requireNonNull(proxy, "the house is not open yet").handlers();
    }

    /** Takes in the bytes of links to robots, once the house is open. */
    PeerHandler.Factory robots() {
        return Objects.requireNonNull(robotLinks, "the house is not open yet").handlers();
    }

    /** Takes in the bytes of ground stations of other makers, once the house is open. */
    PeerHandler.Factory stations() {
        return Objects.requireNonNull(outlet, "the house is not open yet");
    }

    /** Lets ground stations of other makers in. */
    void serve() {
        if (outlet != null) {
            outlets.open(outlet);
        }
        connected = true;
    }

    /** What was added at run time; an endpoint that the settings name as well is there already. */
    private static void addSaved(Proxy proxy, LinkStore saved) {
        for (SavedLink link : saved.links()) {
            try {
                proxy.links().keep(link.id(), EndpointUrl.parse(link.url()));
            } catch (IllegalStateException | IllegalArgumentException e) {
                LOG.warn("The endpoint {} that {} added is left out: {}", link.url(), link.addedBy(), e.getMessage());
            }
        }
    }

    private static EndpointUrl endpoint(String url) {
        try {
            return EndpointUrl.parse(url);
        } catch (IllegalArgumentException e) {
            throw new SetupException("DRONEMAP_ENDPOINTS: " + e.getMessage(), e);
        }
    }
}
