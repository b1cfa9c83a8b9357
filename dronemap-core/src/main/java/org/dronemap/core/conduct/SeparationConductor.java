package org.dronemap.core.conduct;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.UnknownDroneException;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.lease.ControlState;
import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.core.separation.AirspacePicture;
import org.dronemap.core.separation.DroneFix;
import org.dronemap.core.separation.FlightIntent;
import org.dronemap.core.separation.GiveWay;
import org.dronemap.core.separation.Handling;
import org.dronemap.core.separation.Separation;
import org.dronemap.core.separation.SeparationBoard;
import org.dronemap.core.separation.SeparationDecision;
import org.dronemap.core.separation.SeparationGuard;
import org.dronemap.core.separation.SeparationOrder;
import org.dronemap.core.separation.TrackedDrone;
import org.dronemap.core.separation.VelocityEstimates;
import org.dronemap.core.separation.Yielding;
import org.dronemap.core.time.Time;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Looks at all drones four times a second, whoever flies them, and has those that operations command give way to others. Its
 * commands go through the gate under the control of the drone's own operation.
 */
public final class SeparationConductor implements AutoCloseable {
    /** The way in that commands come by which keep drones apart. */
    public static final String FACE = "separation";

    private static final Logger LOG = LoggerFactory.getLogger(SeparationConductor.class);
    private static final Duration RHYTHM = Duration.ofMillis(250);

    private final CloudManager cloud;
    private final SeparationBoard board;
    private final Separation least;
    private final Time time;
    private final Clock clock;
    private final DroneGateway crew;
    private final LinkLossTimer silence;
    private final VelocityEstimates velocities = new VelocityEstimates();
    private final SeenPaces paces = new SeenPaces();
    private final ExecutionThread thread;
    private volatile @Nullable String trouble;
    // Owned by the thread.
    private Map<DroneId, Yielding> yielding = Map.of();
    /** Of which it was found out once whether they stood for others before the process began. */
    private final Set<DroneId> examined = new HashSet<>();

    /** {@code least}: what is kept between any two drones. */
    public SeparationConductor(CloudManager cloud, SeparationBoard board, Separation least, Time time) {
        this.cloud = cloud;
        this.board = board;
        this.least = least;
        this.time = time;
        this.clock = time.clock();
        this.crew = new DroneGateway(cloud, FACE);
        this.silence = new LinkLossTimer(time::nanos);
        this.thread = new ExecutionThread(time, "separation");
    }

    public void start() {
        thread.every(RHYTHM, this::turn);
    }

    public Duration busyFor() {
        return thread.busyFor();
    }

    private void turn() {
        try {
            look();
            trouble = null;
        } catch (RuntimeException e) {
            if (trouble == null) {
                LOG.error("Drones could not be kept apart in this turn; the next one tries again", e);
            }
            trouble = "Drones are not kept apart: " + e.getMessage();
        }
    }

    /** Why drones are not kept apart now, as a sentence; empty: they are. Any thread. */
    public Optional<String> trouble() {
        return Optional.ofNullable(trouble);
    }

    private void look() {
        Instant now = clock.instant();
        Map<DroneId, FlightIntent> intents = board.intents();
        List<TrackedDrone> drones = new ArrayList<>();
        Map<DroneId, LeaseHolder.Operation> holders = new HashMap<>();
        Set<DroneId> seen = new HashSet<>();
        for (DroneState state : cloud.drones()) {
            if (state.replay()) {
                continue;
            }
            seen.add(state.id());
            DroneFix fix = velocities.of(state);
            paces.observe(state, fix);
            FlightIntent intent = intents.get(state.id());
            if (!state.airborne() && intent == null) {
                continue;
            }
            LeaseHolder.Operation holder = holder(state.id());
            if (holder != null) {
                holders.put(state.id(), holder);
            }
            drones.add(tracked(state, intent, holder));
        }
        velocities.retainOnly(seen);
        paces.retainOnly(seen);
        examined.retainAll(seen);
        restore(drones, now);
        AirspacePicture picture =
                new AirspacePicture(now, drones, least, (drone, goTo) -> mayGo(holders.get(drone.id()), drone, goTo));
        SeparationDecision decision = SeparationGuard.decide(picture, yielding);
        yielding = decision.yielding();
        board.publish(decision.giveWays(), decision.silent());
        decision.orders().forEach(order -> send(holders.get(order.to()), order));
    }

    private TrackedDrone tracked(
            DroneState state, @Nullable FlightIntent intent, LeaseHolder.@Nullable Operation holder) {
        Handling handling = holder == null ? Handling.FOREIGN : intent == null ? Handling.STEERED : Handling.COMMANDED;
        boolean counts = holder != null || (intent != null && intent.countsForAnybody());
        return new TrackedDrone(
                state,
                silence(state),
                counts ? intent : null,
                handling,
                holder != null && board.isPlanned(holder.id()) ? holder.id() : null,
                velocities.velocity(state.id()),
                isManual(state, handling) ? paces.manual(state) : paces.of(state));
    }

    private static boolean isManual(DroneState state, Handling handling) {
        Optional<Steering> steering = state.capabilities().steering(state.mode());
        return handling == Handling.FOREIGN
                && (steering.isEmpty() || steering.get().waitsForSomebody());
    }

    /** Since it was heard last; after a restart since the process began at least. */
    private Duration silence(DroneState state) {
        Duration lost = silence.of(state);
        Instant lastHeard = state.link().lastHeard();
        if (lost.isZero() && state.link().state() != LinkState.LOST) {
            return Duration.ZERO;
        }
        Duration unheard = lastHeard == null ? lost : Duration.between(lastHeard, clock.instant());
        return unheard.compareTo(lost) > 0 ? unheard : lost;
    }

    private LeaseHolder.@Nullable Operation holder(DroneId drone) {
        ControlState control = cloud.controls().control(drone);
        return control.tenure() != null && control.tenure().holder() instanceof LeaseHolder.Operation operation
                ? operation
                : null;
    }

    private boolean mayGo(LeaseHolder.@Nullable Operation holder, TrackedDrone drone, Command.GoTo goTo) {
        return holder != null && crew.refusal(holder, drone.state(), goTo).isEmpty();
    }

    private void send(LeaseHolder.@Nullable Operation holder, SeparationOrder order) {
        if (holder == null) {
            return;
        }
        try {
            crew.command(holder, order.to(), new CommandId(time.newId()), order.command());
            LOG.info("{}", order.why());
        } catch (UnknownDroneException removed) {
            LOG.info("{} was removed before it could give way", order.to());
        } catch (RuntimeException e) {
            // Asked for again by the next turn that sees the conflict.
            LOG.error("{} could not be told to give way", order.to(), e);
        }
    }

    /** Who was told to give way before a restart stands still for that; it goes on when all is clear. */
    private void restore(List<TrackedDrone> drones, Instant now) {
        Map<DroneId, Yielding> known = new HashMap<>(yielding);
        for (TrackedDrone drone : drones) {
            boolean looksLikeIt = drone.handling() == Handling.COMMANDED && drone.isStandingLive();
            if (!looksLikeIt || !examined.add(drone.id())) {
                continue;
            }
            List<CommandRecord> last = cloud.gate().commandsOf(drone.id(), 1);
            if (!last.isEmpty() && last.get(0).face().equals(FACE)) {
                known.putIfAbsent(drone.id(), Yielding.restored(GiveWay.toAnother(drone.id(), now)));
            }
        }
        yielding = known;
    }

    @Override
    public void close() {
        thread.close();
    }
}
