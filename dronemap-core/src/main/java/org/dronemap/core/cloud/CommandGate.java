package org.dronemap.core.cloud;

import java.time.Clock;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.RejectedExecutionException;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.lane.InternalFaults;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.cloud.listener.CloudListener;
import org.dronemap.core.cloud.rule.CommandRules;
import org.dronemap.core.cloud.rule.CommandTracker;
import org.dronemap.core.cloud.rule.ControlRules;
import org.dronemap.core.cloud.rule.RecentModeCommands;
import org.dronemap.core.cloud.rule.RoleRules;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandDigest;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandPhase;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.CommandStore;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.time.Time;
import org.dronemap.core.zone.RouteObjection;
import org.dronemap.core.zone.ZoneRules;
import org.jspecify.annotations.Nullable;

/**
 * The single entry point for all commands: checks, stores the intent, sends, and ensures exactly one outcome. Any
 * thread; what is under way belongs to the drone's lane.
 */
public final class CommandGate {
    static final String GATE = "gate";

    private final DroneRegistry registry;
    private final CommandStore store;
    private final CommandIntentWriter intents;
    private final Time time;
    private final Clock clock;
    private final CloudListener listener;
    private final ZoneRules zones;
    private final PendingCommands underway = new PendingCommands();
    private final CommandDispatcher dispatch;

    /** What safety rules are called in the log, and their face. */
    static final Source SAFETY = new Source(new Principal("dronemap", Role.SUPERVISOR), "rule");

    /**
     * Origin of a command: the caller and the interface (REST, stream …) that was used.
     *
     * @param epoch of the control that the client believes to have; null: says nothing
     * @param operation what the cloud conducts for that user and commands this; null: the user does
     */
    public record Source(
            Principal principal, String face, @Nullable Long epoch, LeaseHolder.@Nullable Operation operation) {
        public Source(Principal principal, String face) {
            this(principal, face, null, null);
        }

        public Source(Principal principal, String face, @Nullable Long epoch) {
            this(principal, face, epoch, null);
        }
    }

    CommandGate(
            DroneRegistry registry,
            CommandStore store,
            StoreWriter journal,
            Time time,
            CloudListener listener,
            ZoneRules zones) {
        this.zones = zones;
        this.registry = registry;
        this.store = store;
        this.intents = new CommandIntentWriter(store, journal, time);
        this.time = time;
        this.clock = time.clock();
        this.listener = listener;
        this.dispatch = new CommandDispatcher(underway, this::whyNotThere, journal, store, time, listener);
    }

    /**
     * Asks for a command. The answer is its record: refused already, or under way. The same id again answers with the
     * record it has and acts no second time.
     *
     * @throws UnknownDroneException when there is no such drone
     */
    public CommandRecord submit(Source source, DroneId drone, CommandId id, Command command) {
        return submit(source, drone, id, command, command);
    }

    /** The same where {@code command} was made of what was {@code asked} and of what is known of the drone now. */
    public CommandRecord submit(Source source, DroneId drone, CommandId id, Command command, Command asked) {
        ManagedDrone managed = registry.find(drone).orElseThrow(() -> new UnknownDroneException(drone));
        Optional<CommandRecord> same = given(id, command);
        if (same.isPresent()) {
            return same.get();
        }
        CommandRecord record = intent(source, drone, id, command, asked);
        Optional<Refusal> why = whyNot(source.principal(), managed.drone().state(), command);
        if (why.isPresent()) {
            return refuse(record, why.get());
        }
        ControlClearance passage = managed.control().enter(source, command);
        if (passage instanceof ControlClearance.Refused closed) {
            return refuse(record, closed.why());
        }
        return begin(managed, command, record, (ControlClearance.Cleared) passage, source.principal());
    }

    /** The same id before. What brings to safety asks no store first: whether its id is new, its intent tells. */
    private Optional<CommandRecord> given(CommandId id, Command command) {
        return ControlRules.bringsToSafety(command)
                ? Optional.ofNullable(underway.find(id))
                        .map(entry -> entry.open().published())
                : find(id);
    }

    private CommandRecord begin(
            ManagedDrone managed,
            Command command,
            CommandRecord given,
            ControlClearance.Cleared passage,
            Principal principal) {
        PendingCommand entry = underway(managed, command, given, passage, principal);
        PendingCommand earlier = underway.add(entry);
        return earlier == null
                ? send(entry, entry.open().record())
                : earlier.open().published();
    }

    private PendingCommand underway(
            ManagedDrone managed,
            Command command,
            CommandRecord given,
            ControlClearance.Cleared passage,
            Principal principal) {
        CommandRecord record = passage.epoch() == null ? given : given.withEpoch(passage.epoch());
        CommandTracker open = new CommandTracker(command, record, managed.lane().activeNanos(), time.nanos());
        return new PendingCommand(open, managed, passage, principal, new CompletableFuture<>());
    }

    /**
     * What a rule of safety commands while nobody has control; whoever takes it ends this. Does not wait. Empty: somebody has
     * control.
     */
    Optional<CommandTracker> submitForSafety(ManagedDrone managed, Command command) {
        return submitForSafety(managed, command, null);
    }

    /** The same, also while somebody has the control of this epoch still. */
    Optional<CommandTracker> submitForSafety(ManagedDrone managed, Command command, @Nullable Long epoch) {
        Principal rule = SAFETY.principal();
        return managed.control().enterForSafety(rule, command, epoch).map(passage -> {
            CommandRecord given = intent(SAFETY, managed.id(), new CommandId(time.newId()), command, command);
            PendingCommand entry = underway(managed, command, given, passage, rule);
            underway.add(entry);
            // Neither the lane nor the drone waits for the disk.
            intents.writeLater(entry.open().record());
            dispatch(entry);
            return entry.open();
        });
    }

    /** Why this principal cannot give that command now; empty when it can. */
    public Optional<Refusal> whyNot(Principal principal, DroneState drone, Command command) {
        return InternalFaults.judging(
                command.summary(),
                () -> RoleRules.whyNot(principal, drone, command.needs())
                        .or(() -> CommandRules.whyNot(drone, command))
                        .or(() -> whyNotThere(principal, drone, command)));
    }

    /** Why the zones, or the bounds of a key, speak against it. */
    Optional<Refusal> whyNotThere(Principal principal, DroneState drone, Command command) {
        return zones.whyNot(principal.name(), drone, command, clock.instant())
                .map(CommandGate::byZone)
                .or(() -> ZoneRules.whyNot(principal.scope().bounds(), "the bounds of this access key", drone, command)
                        .map(CommandGate::byKey));
    }

    private static Refusal byZone(RouteObjection why) {
        OutcomeCode code = switch (why.kind()) {
            case FORBIDDEN -> OutcomeCode.ZONE_FORBIDS;
            case NOT_CHECKABLE -> OutcomeCode.ZONE_NOT_CHECKABLE;
        };
        return new Refusal(code, why.sentence());
    }

    private static Refusal byKey(RouteObjection why) {
        OutcomeCode code = switch (why.kind()) {
            case FORBIDDEN -> OutcomeCode.KEY_BOUNDS_FORBID;
            case NOT_CHECKABLE -> OutcomeCode.KEY_BOUNDS_NOT_CHECKABLE;
        };
        return new Refusal(code, why.sentence());
    }

    public Optional<CommandRecord> find(CommandId id) {
        PendingCommand now = underway.find(id);
        return now != null ? Optional.of(now.open().published()) : store.command(id);
    }

    /** The record once the command has ended; completes at once for one that has. */
    public CompletableFuture<CommandRecord> end(CommandId id) {
        PendingCommand now = underway.find(id);
        if (now != null) {
            return now.end().copy();
        }
        return store.command(id)
                .map(CompletableFuture::completedFuture)
                .orElseGet(() ->
                        CompletableFuture.failedFuture(new IllegalArgumentException("there is no command " + id)));
    }

    /** Newest first, as written. */
    public List<CommandRecord> commandsOf(DroneId drone, int limit) {
        return store.commandsOf(drone, limit).stream()
                .map(written -> find(written.id()).orElse(written))
                .toList();
    }

    private CommandRecord intent(Source source, DroneId drone, CommandId id, Command command, Command asked) {
        return new CommandRecord(
                id,
                drone,
                source.principal().name(),
                source.face(),
                command.kind().word(),
                command.summary(),
                clock.instant(),
                CommandPhase.SENT,
                null,
                null,
                null,
                null,
                CommandDigest.of(source.principal().account(), asked));
    }

    private CommandRecord refuse(CommandRecord record, Refusal why) {
        CommandRecord refused = record.ended(new Outcome.Refused(GATE, why), clock.instant());
        if (!store.begin(refused)) {
            return store.command(record.id()).orElse(refused);
        }
        listener.commandChanged(refused);
        return refused;
    }

    private CommandRecord send(PendingCommand entry, CommandRecord record) {
        try {
            if (!intents.write(entry.open().command(), record)) {
                underway.remove(entry);
                return store.command(record.id()).orElse(record);
            }
        } catch (RuntimeException e) {
            underway.remove(entry);
            throw e;
        }
        dispatch(entry);
        return entry.open().published();
    }

    /** To the drone's lane. */
    private void dispatch(PendingCommand entry) {
        listener.commandChanged(entry.open().record());
        try {
            entry.drone().lane().execute(() -> dispatch.perform(entry));
        } catch (RejectedExecutionException e) {
            dispatch.end(entry, new Outcome.Failed("The server is overloaded; nothing was sent."));
        }
    }

    // From here on: the drone's lane.

    /** What a rule has a vehicle do beside what it is told by others, by that passage. */
    PendingCommand begin(ManagedDrone managed, Command command, ControlClearance.Cleared passage) {
        CommandRecord given = intent(SAFETY, managed.id(), new CommandId(time.newId()), command, command);
        PendingCommand entry = underway(managed, command, given, passage, SAFETY.principal());
        underway.add(entry);
        intents.writeLater(entry.open().record());
        listener.commandChanged(entry.open().record());
        return entry;
    }

    /** Carries out what is under way. */
    CommandDispatcher dispatch() {
        return dispatch;
    }

    /** Ends what was given under control that somebody else has now. */
    void stopOutdated(ManagedDrone drone) {
        dispatch.stopOutdated(drone);
    }

    /** What else writes parameters of that drone now, as people call it. */
    Optional<String> writingParameters(PendingCommand except) {
        return underway.writingParameters(except);
    }

    /** Whether zones let it fly home at that height, from where it stands. */
    boolean mayFlyHomeAt(DroneState drone, double meters) {
        Position here = drone.position();
        return here == null
                || here.point() == null
                || zones.whyNot(
                                SAFETY.principal().name(),
                                drone,
                                new Command.GoTo(here.point(), Altitude.aboveHome(meters)),
                                clock.instant())
                        .isEmpty();
    }

    /** Something that was given under the control of now is under way. */
    boolean isBusy(ManagedDrone drone) {
        return underway.isBusy(drone);
    }

    /** What is under way and says where to fly, as people call it. Any thread. */
    Optional<String> manoeuvre(ManagedDrone drone) {
        return underway.manoeuvre(drone);
    }

    /** The transfer with that drone that another one would be refused for, as people call it. Any thread. */
    public Optional<String> transfer(DroneId drone) {
        return registry.find(drone).flatMap(underway::transfer);
    }

    /** A change to that mode now may be our own doing. */
    boolean mayHaveChangedTo(ManagedDrone drone, String mode, Capabilities can) {
        return underway.mayLeadTo(drone, mode, can)
                || drone.recentModeCommands().at(drone.lane().activeNanos()).stream()
                        .anyMatch(command -> RecentModeCommands.mayLeadTo(command, mode, can));
    }
}
