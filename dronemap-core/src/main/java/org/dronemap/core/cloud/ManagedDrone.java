package org.dronemap.core.cloud;

import java.time.Duration;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Function;
import org.dronemap.core.cloud.lane.Lane;
import org.dronemap.core.cloud.lane.LinkPace;
import org.dronemap.core.cloud.lane.Liveness;
import org.dronemap.core.cloud.lane.Watchdog;
import org.dronemap.core.cloud.listener.CloudListener;
import org.dronemap.core.cloud.outlook.Outlook;
import org.dronemap.core.cloud.rule.FlightFacts;
import org.dronemap.core.cloud.rule.RecentModeCommands;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.IdentityEvidence;
import org.dronemap.core.drone.IdentityTrust;
import org.dronemap.core.drone.LinkReport;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.LinkStatus;
import org.dronemap.core.drone.ReturnHeight;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.event.DroneEvent;
import org.jspecify.annotations.Nullable;

/**
 * The cloud's live object for one drone: its state, link, liveness and control. Owned by its lane, except where a
 * method says otherwise.
 */
final class ManagedDrone implements Lane.TimedTask {
    private static final long JUST_NANOS = 120_000_000_000L;

    private final DroneProjection drone;
    private final Lane lane;
    private final Liveness liveness;
    private final CloudListener listener;
    private final DroneControl control;
    private final long madeNanos;
    private volatile boolean enrolled;
    private volatile boolean part;
    private volatile long promisedNanos;
    private volatile @Nullable String promisedIdentity;
    private final RecentModeCommands recentModeCommands = new RecentModeCommands();
    /** After a standstill of the process, until what came meanwhile has been read. */
    private static final long BLIND_NANOS = 2_000_000_000L;

    private boolean commandedFromHere;
    private long blindUntilNanos;
    private volatile @Nullable Outlook outlook;
    private @Nullable LinkSession session;
    private boolean replayEnded;
    private Lane.TimedTask watch = () -> {};
    private boolean componentChanged;
    private boolean modeOfOtherComponent;
    private Runnable modeChanged = () -> {};
    private volatile FlightPreparation preparation = FlightPreparation.NONE;
    private final SetpointForwarder setpoints;

    ManagedDrone(
            DroneProjection drone,
            Lane lane,
            Watchdog watchdog,
            CloudListener listener,
            DroneControl control,
            Function<ManagedDrone, SetpointForwarder> helm) {
        this.drone = drone;
        this.lane = lane;
        this.liveness = new Liveness(watchdog);
        this.listener = listener;
        this.control = control;
        this.madeNanos = lane.activeNanos();
        this.promisedNanos = madeNanos - Long.MAX_VALUE / 2;
        this.blindUntilNanos = madeNanos;
        this.setpoints = helm.apply(this);
    }

    DroneProjection drone() {
        return drone;
    }

    DroneId id() {
        return drone.state().id();
    }

    Lane lane() {
        return lane;
    }

    /** Who commands it. Any thread. */
    DroneControl control() {
        return control;
    }

    /** Who steers it. */
    SetpointForwarder setpoints() {
        return setpoints;
    }

    /** Ticks along with it, and hears of each other mode before anybody else does. */
    void watchedBy(ControlWatch control) {
        watch = control;
        modeChanged = control::modeChanged;
    }

    /** Has it do something when it does not hear the cloud any more. */
    void preparedBy(FlightPreparation preparation) {
        this.preparation = preparation;
    }

    /** What it is prepared by. Any thread for what that tells. */
    FlightPreparation preparation() {
        return preparation;
    }

    /** What it was told lately. Any thread. */
    RecentModeCommands recentModeCommands() {
        return recentModeCommands;
    }

    /** Whether this cloud was the last that said how it moves, as far as is known. */
    boolean isCommandedFromHere() {
        return commandedFromHere;
    }

    /** In the air by what this cloud last said, and not on its way home or through a mission. */
    boolean isUncontrolledInAir() {
        DroneState state = drone.state();
        return commandedFromHere
                && FlightFacts.isFlying(state)
                && !FlightFacts.isInMission(state)
                && !state.capabilities().isSafe(state.mode());
    }

    void commandedFromHere(boolean now) {
        commandedFromHere = now;
    }

    /** What becomes of it; null: it is not in the air. Any thread. */
    @Nullable
    Outlook outlook() {
        return outlook;
    }

    void outlook(@Nullable Outlook now) {
        outlook = now;
    }

    /** Something about it changed that its own state does not hold. */
    void news() {
        drone.touch();
        listener.droneChanged(drone.state());
    }

    /** The way down; empty when no link ever came up since the start. */
    Optional<VehicleChannel> channel() {
        return session == null || session.replay() ? Optional.empty() : Optional.of(session.channel());
    }

    /** A session was found to speak for this drone, and showed this for it. */
    void attach(LinkSession newer, Claim claim) {
        LinkSession before = session;
        boolean carriedOn = before != null && before.channel().supersedes(newer.channel());
        session = before != null && carriedOn ? newer.by(before.channel()) : newer;
        componentChanged |= before != null && !carriedOn && newer.channel().isOtherComponent(before.channel());
        drone.attach(newer, standing(claim.evidence(), claim.proof()));
        listener.droneChanged(drone.state());
    }

    /** The mode that is just told is the first of another component of the vehicle: no change of mode. */
    boolean isFirstModeOfOtherComponent() {
        return modeOfOtherComponent;
    }

    void proved(IdentityProof proof) {
        drone.standing(standing(proof.evidence(), proof));
        listener.droneChanged(drone.state());
    }

    private IdentityTrust standing(IdentityEvidence evidence, @Nullable IdentityProof proof) {
        String identity = proof instanceof IdentityProof.OfLink link ? link.identity() : null;
        return drone.state().standing().with(evidence, identity);
    }

    /** News of an old session are nobody's news. */
    boolean isAttachedTo(LinkSession candidate) {
        return session != null && session.channel() == candidate.channel();
    }

    /** Any thread. */
    boolean speaksFrom(DroneKey key) {
        LinkStatus link = drone.state().link();
        return link.key().equals(key) || link.others().contains(key);
    }

    /** It is no old acquaintance, but was made for the session that comes first. */
    void madeForSession() {
        enrolled = true;
    }

    /** Somebody was just found to speak for it, and will be heard on its lane at once. Any thread. */
    void promise(@Nullable IdentityProof proof) {
        promisedNanos = lane.activeNanos();
        if (proof instanceof IdentityProof.OfLink link) {
            promisedIdentity = link.identity();
        }
    }

    /** It came with this key before, is just coming with it, or is what the key was made for. Any thread. */
    boolean hasLinkIdentity(String identity) {
        return identity.equals(id().value())
                || identity.equals(promisedIdentity)
                || identity.equals(drone.state().standing().linkIdentity());
    }

    /** What spoke for it was a part of a vehicle, whose hardware is not the vehicle's. */
    void becamePart() {
        part = true;
        if (drone.state().standing().strongest() == IdentityEvidence.HARDWARE) {
            drone.standing(IdentityTrust.UNPROVED);
        }
        Identification said = drone.state().identification();
        drone.apply(new DroneEvent.Identified(
                new Identification(said.kind(), said.autopilot(), said.vehicle(), said.firmware(), null),
                drone.state().capabilities()));
        listener.droneChanged(drone.state());
    }

    /** Made for a vehicle a moment ago, that showed nothing but its address; or for a part of one. Any thread. */
    boolean isOnlyJustKnown() {
        DroneState state = drone.state();
        return enrolled
                && (part || lane.activeNanos() - madeNanos < JUST_NANOS)
                && state.standing().equals(IdentityTrust.UNPROVED)
                && state.identification().hardwareUid() == null;
    }

    /** For how long nothing was heard. Any thread. */
    long silenceNanos() {
        long now = lane.activeNanos();
        return Math.min(liveness.silence(now), now - promisedNanos);
    }

    void received() {
        received(LinkPace.UNCHANGED);
    }

    void received(LinkPace pace) {
        liveness.received(pace, lane.activeNanos());
        if (pace != LinkPace.UNCHANGED) {
            drone.seldom(liveness.patience());
        }
        drone.received();
        if (replayEnded || drone.state().link().state() != LinkState.LIVE) {
            judge();
        }
    }

    void accept(DroneEvent event) {
        if (event instanceof DroneEvent.ModeReported) {
            modeOfOtherComponent = componentChanged;
            componentChanged = false;
        }
        received();
        String mode = drone.state().mode();
        ReturnHeight before = drone.state().returnHeight();
        drone.apply(event);
        ReturnHeight height = drone.state().returnHeight();
        if (height != null && !height.equals(before)) {
            preparation.returnsAt(height.meters());
        }
        if (!Objects.equals(mode, drone.state().mode())) {
            // Who has chosen that mode is seen before anybody acts on it.
            modeChanged.run();
        }
        modeOfOtherComponent = false;
        listener.droneChanged(drone.state());
    }

    void linkChanged(LinkReport report) {
        drone.reached(report);
        listener.droneChanged(drone.state());
    }

    /** Its recording is over. */
    void replayEnded() {
        replayEnded = true;
        judge();
    }

    void publishMessage(Severity severity, String text) {
        publishMessage(severity, text, null);
    }

    void publishMessage(Severity severity, String text, @Nullable String about) {
        drone.publishMessage(severity, text, about);
        listener.droneChanged(drone.state());
    }

    void forgetMessages() {
        drone.forgetMessages();
        listener.droneChanged(drone.state());
    }

    void rename(String name) {
        drone.rename(name);
        listener.droneChanged(drone.state());
    }

    @Override
    public void advance() {
        judge();
        boolean aged = drone.publishAges();
        if (drone.publishReception() || aged) {
            listener.droneChanged(drone.state());
        }
        if (liveness.probeDue(lane.activeNanos())) {
            channel().ifPresent(VehicleChannel::probe);
        }
        if (isStateUnknown()) {
            return;
        }
        watch.advance();
        preparation.advance();
        setpoints.advance();
    }

    /** Somebody may have taken it meanwhile: what says so is read before anything is done by what was known before. */
    @Override
    public void stoodStill(Duration how) {
        blindUntilNanos = lane.activeNanos() + BLIND_NANOS;
    }

    /** What it does now is not known: the process has stood still. */
    boolean isStateUnknown() {
        return lane.activeNanos() - blindUntilNanos < 0;
    }

    private void judge() {
        LinkState before = drone.state().link().state();
        LinkState now = replayEnded ? LinkState.ENDED : liveness.judge(lane.activeNanos());
        if (!drone.linkState(now)) {
            return;
        }
        if (now == LinkState.LOST) {
            drone.publishMessage(Severity.CRITICAL, "Contact lost.");
        } else if (before == LinkState.LOST && now == LinkState.LIVE) {
            drone.publishMessage(Severity.NOTICE, "Contact is there.");
        }
        listener.droneChanged(drone.state());
    }
}
