package org.dronemap.core.cloud;

import java.time.Clock;
import java.time.Duration;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.dronemap.core.audit.AuditedCall;
import org.dronemap.core.cloud.lane.Lane;
import org.dronemap.core.cloud.lane.Lanes;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.cloud.lane.Watchdog;
import org.dronemap.core.cloud.listener.CloudListener;
import org.dronemap.core.cloud.listener.CompositeCloudListener;
import org.dronemap.core.cloud.listener.CompositeUserPresence;
import org.dronemap.core.cloud.rule.MissionTracker;
import org.dronemap.core.command.CommandStore;
import org.dronemap.core.drone.CloudLossState;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneRecord;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.DroneStore;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.IdentityTrust;
import org.dronemap.core.drone.KnownMission;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.OnboardStorage;
import org.dronemap.core.drone.ParameterOverrideStore;
import org.dronemap.core.drone.ParameterOverrides;
import org.dronemap.core.drone.SensorSnapshot;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.lease.EpochAllocator;
import org.dronemap.core.lease.LeaseMachine;
import org.dronemap.core.lease.LeaseRules;
import org.dronemap.core.lease.LeaseStore;
import org.dronemap.core.safety.SafetyTimes;
import org.dronemap.core.time.Time;
import org.dronemap.core.zone.ZoneRegistry;
import org.dronemap.core.zone.ZoneRules;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Entry point of the cloud manager: vehicle sessions register here; REST, SOAP and stream read drone states here. Links
 * bring vehicles in, faces read states, listeners hear of changes. Any thread.
 */
public final class CloudManager {
    private static final Duration LONGEST_WRITE = Duration.ofSeconds(10);

    private static final Logger LOG = LoggerFactory.getLogger(CloudManager.class);

    private final Lanes lanes;
    private final Rules rules;
    private final Time time;
    private final Clock clock;
    private final DroneStore store;
    private final StoreWriter journal;
    private final Supplier<DroneId> newIds;
    private final DroneRegistry registry = new DroneRegistry();
    private final CopyOnWriteArrayList<CloudListener> listeners = new CopyOnWriteArrayList<>();
    private final CloudListener everybody = new CompositeCloudListener(listeners);
    private final VehicleAdmission reception;
    private final CommandStore turns;
    private final CommandGate gate;
    private final SetpointGate setpoints;
    private final CompositeUserPresence onlookers = new CompositeUserPresence();
    private final ControlGate controls;
    private final DroneControl.Persistence leases;
    private final LeaseMachine leaseMachine;
    private final ParameterOverrideRegistry losses;
    private final ZoneRegistry zones = new ZoneRegistry();
    private final BoundLink.Registrations registrations = new Registered();
    private volatile BiConsumer<DroneId, LinkSession> registrar = (drone, session) -> {};

    /** Stores of the cloud manager, and the thread that writes to them. */
    public record Persistence(
            DroneStore drones,
            CommandStore commands,
            LeaseStore leases,
            ParameterOverrideStore owners,
            StoreWriter journal) {}

    /**
     * Rules of the cloud manager: when a drone counts as lost, timeouts of control, and seconds until return on cloud
     * loss.
     */
    public record Rules(Watchdog watchdog, LeaseRules leases, int lossSeconds) {
        /** As long as a vehicle waits where nobody has said otherwise. */
        public static final int USUAL_LOSS_SECONDS = (int) SafetyTimes.VEHICLE_RETURNS.toSeconds();
    }

    /** With the usual rules of control. */
    public CloudManager(Lanes lanes, Watchdog watchdog, Time time, Persistence keeping, Supplier<DroneId> newIds) {
        this(lanes, new Rules(watchdog, LeaseRules.DEFAULT, Rules.USUAL_LOSS_SECONDS), time, keeping, newIds);
    }

    public CloudManager(Lanes lanes, Rules rules, Time time, Persistence keeping, Supplier<DroneId> newIds) {
        this.lanes = lanes;
        this.rules = rules;
        this.time = time;
        this.clock = time.clock();
        this.controls = new ControlGate(registry, onlookers, time);
        this.store = keeping.drones();
        this.journal = keeping.journal();
        this.newIds = newIds;
        this.turns = keeping.commands();
        this.reception = new VehicleAdmission(registry, clock);
        this.gate = new CommandGate(registry, keeping.commands(), journal, time, everybody, new ZoneRules(zones));
        this.setpoints = new SetpointGate(registry, gate, time);
        ZoneWatch guard = new ZoneWatch(zones, new ZoneBreachExecutor(registry, gate, time), time);
        zones.onChange(change -> registry.all().forEach(guard::lookAgain));
        listeners.add(guard);
        this.leases = new DroneControl.Persistence(keeping.leases(), journal);
        EpochAllocator epochs =
                new EpochAllocator(keeping.leases(), task -> journal.write("more epochs", task, () -> {}));
        this.leaseMachine = new LeaseMachine(rules.leases(), epochs::next);
        this.losses = new ParameterOverrideRegistry(
                keeping.owners(), journal, rules.lossSeconds(), new ReturnHeightAllocator(registry));
        store.drones()
                .forEach(record ->
                        manage(record, false, store.knownMission(record.id()).orElse(null)));
        keeping.leases()
                .leases()
                .forEach(lease -> registry.find(lease.drone()).ifPresent(drone -> {
                    drone.control().restore(lease);
                    drone.commandedFromHere(true);
                }));
    }

    /** The one door for commands. */
    public CommandGate gate() {
        return gate;
    }

    /** The one door for setpoints. */
    public SetpointGate setpoints() {
        return setpoints;
    }

    /** Where control of drones is taken, asked for and given back. */
    public ControlGate controls() {
        return controls;
    }

    /** The zones that bind drones; whoever keeps them puts them in. */
    public ZoneRegistry zones() {
        return zones;
    }

    /** Hears of each drone that comes by itself before anybody can see it; set before the first one comes. */
    public void registerBy(BiConsumer<DroneId, LinkSession> newcomers) {
        registrar = newcomers;
    }

    public void addListener(CloudListener listener) {
        listeners.add(listener);
    }

    public void removeListener(CloudListener listener) {
        listeners.remove(listener);
    }

    public List<DroneState> drones() {
        return registry.all().stream().map(managed -> managed.drone().state()).toList();
    }

    public Optional<DroneState> drone(DroneId id) {
        return registry.find(id).map(managed -> managed.drone().state());
    }

    /** What a drone keeps on board beside its mission, as last heard; UNKNOWN when there is no such drone. */
    public OnboardStorage onBoard(DroneId id) {
        return registry.find(id).map(managed -> managed.drone().onBoard()).orElse(OnboardStorage.UNKNOWN);
    }

    /** The newest that a drone's sensors brought; nothing when there is no such drone. */
    public SensorSnapshot sensed(DroneId id) {
        return registry.find(id).map(managed -> managed.drone().sensed()).orElse(SensorSnapshot.NOTHING);
    }

    /** What is known of what a drone does without the cloud; nothing when there is no such drone. */
    public CloudLossState cloudLoss(DroneId id) {
        return registry.find(id).map(managed -> managed.preparation().state()).orElse(CloudLossState.UNKNOWN);
    }

    /** What the owners of drones that were removed since had set, and was not put back. */
    public List<ParameterOverrides> outstandingOverrides() {
        return losses.all().stream()
                .filter(values -> registry.find(values.drone()).isEmpty())
                .sorted(Comparator.comparing(ParameterOverrides::since))
                .toList();
    }

    /** The drone that a vehicle would be taken for by what it says of itself alone. */
    public Optional<DroneId> recognise(DroneKey key, Identification identification) {
        return registry.claimedBy(key, identification.hardwareUid()).map(ManagedDrone::id);
    }

    /** Finds the drone that a session speaks for, or makes one, or keeps it outside. Blocks only for the registry. */
    public synchronized ClaimResult admit(Claim claim) {
        ClaimDecision verdict = reception.judge(claim);
        if (verdict instanceof ClaimDecision.Quarantined apart) {
            return new ClaimResult.NotAdmitted(apart.why());
        }
        ManagedDrone drone = verdict instanceof ClaimDecision.Known known ? known.drone() : enrol(claim);
        drone.promise(claim.proof());
        drone.lane().execute(() -> {
            drone.attach(claim.session(), claim);
            // A session begins with a message of its vehicle.
            drone.received();
            remember(drone);
        });
        return new ClaimResult.Bound(new BoundLink(drone, claim.session(), registrations));
    }

    /** Vehicles that wait to be let in, longest first. */
    public List<WaitingVehicle> waiting() {
        return reception.waiting();
    }

    /** Lets a waiting vehicle in as a drone of its own; it is in contact as soon as it is next heard. */
    public Optional<DroneState> admit(String waitingId, @Nullable String name) {
        return admit(waitingId, name, drone -> {});
    }

    /** The same; {@code before} hears of the new drone before anybody can see it. */
    public synchronized Optional<DroneState> admit(String waitingId, @Nullable String name, Consumer<DroneId> before) {
        return reception.remove(waitingId).map(waiting -> {
            DroneId id = newIds.get();
            before.accept(id);
            Identification said = waiting.identification();
            String label = name == null ? said.vehicle() + " " + waiting.key().systemId() : name;
            ManagedDrone drone = manage(
                    new DroneRecord(
                            id,
                            label,
                            waiting.key(),
                            waiting.transport(),
                            said,
                            waiting.isQuarantined() ? IdentityTrust.DISTINCT : IdentityTrust.UNPROVED,
                            clock.instant(),
                            null),
                    false,
                    null);
            remember(drone);
            return drone.drone().state();
        });
    }

    /** Takes a waiting vehicle off the list; it comes again when it is heard again. False when it was not there. */
    public boolean dismiss(String waitingId) {
        return reception.remove(waitingId).isPresent();
    }

    /** Tells everybody who looks at a drone a sentence about it; no sign of life. Does not wait. */
    public void publishMessage(DroneId id, Severity severity, String sentence) {
        registry.find(id).ifPresent(drone -> drone.lane().execute(() -> drone.publishMessage(severity, sentence)));
    }

    /** False when there is no such drone; returns once the new name is durable. */
    public boolean rename(DroneId id, String name) {
        Optional<ManagedDrone> found = registry.find(id);
        found.ifPresent(drone -> {
            CompletableFuture<CompletableFuture<Void>> kept = new CompletableFuture<>();
            // On the lane, so that no older record of this drone can be written after it.
            drone.lane().execute(AuditedCall.carried(() -> {
                drone.rename(name);
                kept.complete(keepName(drone));
            }));
            Void unused = time.join(kept.thenCompose(written -> written), LONGEST_WRITE);
        });
        return found.isPresent();
    }

    private CompletableFuture<Void> keepName(ManagedDrone drone) {
        if (drone.drone().state().replay()) {
            return CompletableFuture.completedFuture(null);
        }
        DroneRecord record = drone.drone().record();
        return journal.written("the name of " + record.name(), () -> store.save(record));
    }

    /** Forgets a drone; refused with a sentence while it is in contact. */
    public Optional<String> forget(DroneId id) {
        Optional<ManagedDrone> found = registry.find(id);
        if (found.isEmpty()) {
            return Optional.of("There is no drone " + id + ".");
        }
        ManagedDrone drone = found.get();
        DroneState state = drone.drone().state();
        if (!state.replay()) {
            if (state.link().state() != LinkState.LOST) {
                return Optional.of("The drone is in contact; only a lost drone can be removed.");
            }
            store.delete(id);
            losses.kept(id)
                    .ifPresent(
                            left -> LOG.warn("{} was removed; what its owner had set is not put back: {}", id, left));
        }
        drop(drone);
        return Optional.empty();
    }

    private void drop(ManagedDrone drone) {
        if (registry.remove(drone)) {
            drone.lane().execute(() -> drone.lane().removeTimedTask(drone));
            everybody.droneRemoved(drone.id());
        }
    }

    private ManagedDrone enrol(Claim claim) {
        LinkSession session = claim.session();
        DroneId id = claim.proof() instanceof IdentityProof.OfLink link && link.drone() != null
                ? link.drone()
                : newIds.get();
        registrar.accept(id, session);
        DroneRecord record = new DroneRecord(
                id, session.label(), session.key(), session.transport(), claim.identification(), clock.instant());
        ManagedDrone drone = manage(record, session.replay(), null);
        drone.madeForSession();
        return drone;
    }

    private ManagedDrone manage(DroneRecord record, boolean replay, @Nullable KnownMission known) {
        MissionTracker mission = new MissionTracker(known, now -> {
            if (!replay) {
                journal.write(
                        "the mission of " + record.name(), () -> store.saveKnownMission(record.id(), now), () -> {});
            }
        });
        Lane lane = lanes.of(record.id());
        DroneControl control = new DroneControl(record.id(), leaseMachine, leases, clock, time::nanos);
        ManagedDrone drone = new ManagedDrone(
                new DroneProjection(record, replay, mission, clock),
                lane,
                rules.watchdog(),
                everybody,
                control,
                this::newSetpointForwarder);
        ReturnWatch returning = new ReturnWatch(drone, gate, new ZoneRules(zones), time);
        LinkWatch links = new LinkWatch(drone, gate, new ZoneRules(zones), rules.leases(), time);
        drone.watchedBy(new ControlWatch(drone, gate, rules.leases(), onlookers, everybody, returning, links, time));
        if (!replay) {
            drone.preparedBy(new CloudLossPreparation(drone, gate, losses, clock));
        }
        registry.add(drone);
        lane.execute(() -> lane.addTimedTask(drone));
        return drone;
    }

    private SetpointForwarder newSetpointForwarder(ManagedDrone drone) {
        return new SetpointForwarder(
                drone,
                new SetpointForwarder.SteeringLog(turns, journal, everybody, time),
                (braked, epoch) -> ControlWatch.holdIfMoving(gate, braked, epoch));
    }

    private void remember(ManagedDrone drone) {
        if (!drone.drone().state().replay()) {
            DroneRecord record = drone.drone().record();
            journal.write("the record of " + record.name(), () -> store.save(record), () -> {});
        }
    }

    /** Access of a drone's link session to the cloud manager's registry and store of drones. */
    private final class Registered implements BoundLink.Registrations {
        @Override
        public boolean contains(ManagedDrone drone) {
            return registry.contains(drone);
        }

        @Override
        public void remember(ManagedDrone drone) {
            CloudManager.this.remember(drone);
        }

        @Override
        public void drop(ManagedDrone drone) {
            CloudManager.this.drop(drone);
        }

        @Override
        public void forget(ManagedDrone nobody) {
            CloudManager.this.drop(nobody);
            journal.write("that " + nobody.id() + " was nobody", () -> store.delete(nobody.id()), () -> {});
        }
    }
}
