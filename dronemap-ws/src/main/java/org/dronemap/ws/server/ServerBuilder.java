package org.dronemap.ws.server;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.function.Supplier;
import javax.net.ssl.SSLContext;
import org.dronemap.core.access.GrantRegistry;
import org.dronemap.core.audit.AuditedCommandStore;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.ControlAuditListener;
import org.dronemap.core.cloud.lane.Lane;
import org.dronemap.core.cloud.lane.Lanes;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.cloud.listener.CloudListener;
import org.dronemap.core.command.CommandStore;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.conduct.BindingAuditListener;
import org.dronemap.core.conduct.Operations;
import org.dronemap.core.conduct.SeparationConductor;
import org.dronemap.core.conduct.VirtualDrones;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.history.HistoryRecorder;
import org.dronemap.core.history.TelemetryStore;
import org.dronemap.core.link.EndpointStore;
import org.dronemap.core.link.SavedEndpoint;
import org.dronemap.core.process.ProcessStart;
import org.dronemap.core.separation.SeparationBoard;
import org.dronemap.core.time.Time;
import org.dronemap.core.virtual.VirtualRunMachine;
import org.dronemap.proxy.MavlinkConnector;
import org.dronemap.proxy.endpoint.BoundedWebSocketFactory;
import org.dronemap.proxy.endpoint.EndpointSecurity;
import org.dronemap.proxy.endpoint.EndpointUrl;
import org.dronemap.proxy.endpoint.PeerHandler;
import org.dronemap.proxy.outlet.Outlet;
import org.dronemap.proxy.record.Recorder;
import org.dronemap.proxy.roslink.RoslinkConnector;
import org.dronemap.proxy.session.FrameTap;
import org.dronemap.proxy.signing.KeyringRegistry;
import org.dronemap.store.Stores;
import org.dronemap.store.mongo.MongoTelemetryStore;
import org.dronemap.store.secret.SecretBox;
import org.dronemap.store.secret.ServerSecret;
import org.dronemap.ws.environment.SetupException;
import org.dronemap.ws.link.DtlsKeyRing;
import org.dronemap.ws.operation.OwnerRightsCache;
import org.dronemap.ws.robotkey.RobotKeyRing;
import org.dronemap.ws.security.Argon2Passwords;
import org.dronemap.ws.settings.OutletSettings;
import org.dronemap.ws.settings.ServerSettings;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Builds the server around the cloud manager: stores, journal and lanes, endpoints for vehicles, and the outlet. */
public final class ServerBuilder {
    private static final Logger LOG = LoggerFactory.getLogger(ServerBuilder.class);
    private static final int LANES = 2;
    private static final String SET_ASIDE =
            "The server ended three times within two minutes, and started without what it was conducting.";

    private final ServerSettings settings;
    private final ShutdownSequence closing;
    private final List<EndpointUrl> endpoints;
    private final Time time;
    private final ProcessStart beginning;
    private final Lanes lanes;
    private final OutletBuilder outlets;
    private final RobotEndpointBuilder robots;
    private final SeparationBoard board = new SeparationBoard();
    private @Nullable Outlet outlet;
    private @Nullable MavlinkConnector proxy;
    private @Nullable RoslinkConnector robotLinks;
    private @Nullable EndpointStore savedLinks;
    private @Nullable Operations operations;
    private volatile boolean connected;

    /** What is opened is handed to {@code closing} as it opens, so that a failed start leaves nothing behind. */
    public ServerBuilder(ServerSettings settings, ShutdownSequence closing, Time time, ProcessStart beginning) {
        this.settings = settings;
        this.beginning = beginning;
        this.time = time;
        this.lanes = new Lanes(time, LANES);
        this.closing = closing;
        this.endpoints =
                settings.endpoints().stream().map(ServerBuilder::endpoint).toList();
        this.outlets = new OutletBuilder(settings.outlet(), time);
        this.robots = new RobotEndpointBuilder(settings.robots(), time);
    }

    public List<Lane> lanes() {
        return lanes.all();
    }

    /** Everything but the links: nothing is heard and nothing sent yet. */
    public ServerComponents open(Stores stores) {
        ServerComponents.AuditComponents audit = new AuditBuilder(settings, time).open(stores, closing);
        StoreWriter journal = closing.adding("the journal", new StoreWriter(time));
        HistoryBuilder histories = new HistoryBuilder(settings.history(), telemetry(stores), closing, time);
        CloudManager cloud = cloud(stores, commands(stores, audit), journal);
        GrantRegistry grants = grants(stores, cloud, audit);
        HistoryRecorder history = histories.open(stores.flights(), cloud);
        SecretBox box = box();
        DtlsKeyRing dtlsKeys = new DtlsKeyRing(stores.links(), new SecretBoxEncryption(box));
        Recorder recorder = recorder(stores, journal, cloud);
        Outlet clients = outlet(control(cloud, audit), stores, journal, box, grants, doors(dtlsKeys));
        KeyringRegistry keyrings = keyrings(cloud, stores, journal, box);
        MavlinkConnector links = links(cloud, keyrings, taps(recorder, clients), doors(dtlsKeys), stores.links());
        RobotKeyRing robotKeys = new RobotKeyRing(stores.links());
        RoslinkConnector robotSide = robots(cloud, recorder, robotKeys, doors(dtlsKeys));
        SeparationConductor separation = OperationComponents.separation(cloud, settings.apart(), board, closing, time);
        VirtualDrones virtuals = virtualDrones(cloud, stores, grants, audit);
        OperationComponents runs = runs(cloud, stores, grants);
        return new ServerComponents(
                time,
                cloud,
                stores.access(),
                stores.missions(),
                stores.zones(),
                new ProxyReplayGateway(links.replays()),
                recorder.archive(),
                history,
                linkSide(new ProxyEndpointGateway(links, robotSide), stores, dtlsKeys, robotKeys, clients),
                stores::isUp,
                file -> writeBackup(stores, file),
                new ProxyLinkSecurityGateway(links.keyrings()),
                stores.grants(),
                grants,
                virtuals,
                runs,
                audit,
                new Argon2Passwords(),
                new MonitoredParts(lanes, journal, virtuals, runs, separation, links.links(), robotSide).all(),
                beginning);
    }

    private ServerComponents.LinkComponents linkSide(
            ProxyEndpointGateway vehicles,
            Stores stores,
            DtlsKeyRing dtlsKeys,
            RobotKeyRing robotKeys,
            Outlet clients) {
        return new ServerComponents.LinkComponents(
                vehicles, stores.links(), dtlsKeys, robotKeys, new ProxyOutletGateway(clients), () -> connected);
    }

    private MavlinkConnector links(
            CloudManager cloud,
            KeyringRegistry keyrings,
            FrameTap.Factory taps,
            EndpointSecurity doors,
            EndpointStore saved) {
        MavlinkConnector.Policy policy = new MavlinkConnector.Policy(keyrings, taps, doors, settings.enrolment());
        MavlinkConnector links = new MavlinkConnector(cloud, lanes, endpoints, policy, time);
        closing.add("the links", links);
        proxy = links;
        savedLinks = saved;
        return links;
    }

    private AuditedOutletControl control(CloudManager cloud, ServerComponents.AuditComponents audit) {
        return new AuditedOutletControl(cloud, audit.recorder());
    }

    private RoslinkConnector robots(CloudManager cloud, Recorder recorder, RobotKeyRing keys, EndpointSecurity doors) {
        RoslinkConnector.Policy policy = new RoslinkConnector.Policy(
                new IssuedRobotKeys(keys), recorder::openLines, doors, settings.enrolment());
        RoslinkConnector built = robots.build(cloud, lanes, policy);
        closing.add("the links to robots", built);
        robotLinks = built;
        return built;
    }

    private Outlet outlet(
            AuditedOutletControl control,
            Stores stores,
            StoreWriter journal,
            SecretBox box,
            GrantRegistry grants,
            EndpointSecurity doors) {
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

    private CloudManager cloud(Stores stores, CommandStore commands, StoreWriter journal) {
        closing.add("the lanes", lanes);
        return new CloudManager(
                lanes,
                new CloudManager.Rules(settings.watchdog(), settings.control(), settings.lossSeconds()),
                time,
                new CloudManager.Persistence(stores.drones(), commands, stores.leases(), stores.owners(), journal),
                new DroneIdGenerator(time.random()));
    }

    /** In force before anybody can ask, or any vehicle is heard. */
    private GrantRegistry grants(Stores stores, CloudManager cloud, ServerComponents.AuditComponents audit) {
        GrantRegistry grants = new GrantRegistry(time.clock());
        grants.replace(stores.grants().directory());
        cloud.zones().ownersBy(grants::owner);
        cloud.zones().put(stores.zones().zones());
        cloud.addListener(new ControlAuditListener(audit.store(), time.clock(), grants::owner));
        return grants;
    }

    /** Takes up what was under way, before any vehicle is heard and anybody else can command. */
    private VirtualDrones virtualDrones(
            CloudManager cloud, Stores stores, GrantRegistry grants, ServerComponents.AuditComponents audit) {
        VirtualDrones virtuals = new VirtualDrones(
                cloud,
                stores.virtualDrones(),
                new VirtualRunMachine(settings.virtualSilence()),
                new OwnerRightsCache(stores.access(), grants, time),
                board,
                time);
        virtuals.addListener(new BindingAuditListener(audit.store(), time.clock(), virtuals.all()));
        if (beginning.precautions().isActive()) {
            virtuals.startSuspended(SET_ASIDE);
        } else {
            virtuals.start();
        }
        return closing.adding("the virtual drones", virtuals);
    }

    /** As for virtual drones. */
    private OperationComponents runs(CloudManager cloud, Stores stores, GrantRegistry grants) {
        OwnerRightsCache owners = new OwnerRightsCache(stores.access(), grants, time);
        OperationComponents runs =
                OperationComponents.of(cloud, stores.operations(), owners, settings.apart(), board, time);
        if (beginning.precautions().isActive()) {
            runs.operations().setAside(SET_ASIDE);
        } else {
            runs.operations().restore();
        }
        operations = runs.operations();
        closing.add("the operations", runs.operations());
        return runs;
    }

    private SecretBox box() {
        return ServerSecret.box(
                ServerSettings.Hidden.shown(settings.linkSecret()),
                settings.dataDirectory().resolve("link-secret"));
    }

    private CommandStore commands(Stores stores, ServerComponents.AuditComponents audit) {
        CommandStore commands = new AuditedCommandStore(stores.commands(), audit.store(), time::nanos);
        int ended = commands.endUnfinished(
                new Outcome.Unknown("The server restarted while it was under way."),
                time.clock().instant());
        if (ended > 0) {
            LOG.warn("{} commands were under way when the server stopped; their outcome is unknown", ended);
        }
        return commands;
    }

    private EndpointSecurity doors(DtlsKeyRing keys) {
        ServerSettings.Tls tls = settings.tls();
        Supplier<@Nullable SSLContext> certificate = tls == null ? () -> null : ReloadableCertificate.of(tls)::current;
        return new EndpointSecurity(
                keys::secret, certificate, BoundedWebSocketFactory.Limits.DEFAULT, beginning.watch());
    }

    private KeyringRegistry keyrings(CloudManager cloud, Stores stores, StoreWriter journal, SecretBox box) {
        KeyringRegistry keyrings = new KeyringRegistry(
                new KeyringRegistry.Dependencies(
                        stores.linkSecurity(box),
                        journal,
                        drone -> cloud.drone(drone)
                                .map(state -> state.link().key().systemId())
                                .orElse(-1),
                        (drone, sentence) -> cloud.publishMessage(drone, Severity.WARNING, sentence)),
                time);
        closing.add("the keys", keyrings);
        cloud.addListener(new RemovedDroneListener(keyrings));
        return keyrings;
    }

    /** A drone that is removed takes its keys along. */
    private record RemovedDroneListener(KeyringRegistry keyrings) implements CloudListener {
        @Override
        public void droneRemoved(DroneId id) {
            keyrings.removed(id);
        }
    }

    private TelemetryStore telemetry(Stores stores) {
        String url = ServerSettings.Hidden.shown(settings.mongodbUrl());
        if (url == null) {
            return stores.telemetry();
        }
        MongoTelemetryStore store = MongoTelemetryStore.open(url);
        closing.add("the MongoDB", store);
        return store;
    }

    private Recorder recorder(Stores stores, StoreWriter journal, CloudManager cloud) {
        Path directory = settings.dataDirectory().resolve("recordings");
        Recorder recorder = new Recorder(
                directory,
                settings.recording(),
                new Recorder.Dependencies(
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
    public void openLinks() {
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

    /** Takes in the bytes of links to vehicles, once the server is open. */
    public PeerHandler.Factory vehicles() {
        return Objects.requireNonNull(proxy, "the server is not open yet").handlers();
    }

    /** Takes in the bytes of links to robots, once the server is open. */
    public PeerHandler.Factory robots() {
        return Objects.requireNonNull(robotLinks, "the server is not open yet").handlers();
    }

    /** Takes in the bytes of ground stations of other makers, once the server is open. */
    public PeerHandler.Factory stations() {
        return Objects.requireNonNull(outlet, "the server is not open yet");
    }

    /** Lets ground stations of other makers in. */
    public void serve() {
        if (outlet != null) {
            outlets.open(outlet);
        }
        connected = true;
    }

    /** What was added at run time; an endpoint that the settings name as well is there already. */
    private static void addSaved(MavlinkConnector proxy, EndpointStore saved) {
        for (SavedEndpoint link : saved.links()) {
            try {
                proxy.links().retryLater(link.id(), EndpointUrl.parse(link.url()));
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
