package org.dronemap.core.cloud;

import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicReference;
import org.dronemap.core.cloud.lane.Lane;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.cloud.listener.CloudListener;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandPhase;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.CommandStore;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.lease.Lease;
import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.core.time.Time;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Sends the newest setpoint to one drone, and stops the drone once no more setpoints come. Each turn at the helm, from
 * its first setpoint to its last, is one entry of the log of commands. Setpoints come from any thread, of which only
 * the newest waits; everything else belongs to the drone's lane.
 */
final class SetpointForwarder implements Lane.TimedTask {
    private static final Logger LOG = LoggerFactory.getLogger(SetpointForwarder.class);
    /** No setpoint counts for longer. */
    static final long EXPIRES_NANOS = 500_000_000L;
    /** A vehicle is told to stand still more than once, since nothing is answered. */
    private static final long STILL_AGAIN_NANOS = 150_000_000L;

    private static final int STILL_TIMES = 3;
    private static final SendAuthority SAFETY = new SendAuthority(null, null, "dronemap", EpochGuard.NONE);

    private final ManagedDrone drone;
    private final SteeringLog log;
    private final HoldAction brake;
    private final AtomicReference<@Nullable PendingSetpoint> newest = new AtomicReference<>();
    // Owned by the lane.
    private final SetpointRefusalFilter refusals = new SetpointRefusalFilter();
    private @Nullable SteeringSession turn;
    private @Nullable Setpoint still;
    private int stillLeft;
    private long stillNanos;

    /** Store and writer for records of steering sessions, and the listener that is notified of them. */
    record SteeringLog(CommandStore store, StoreWriter journal, CloudListener listener, Time time) {}

    /** Stops a vehicle that does not stand by itself once nobody steers it. */
    interface HoldAction {
        /** On the drone's lane; {@code epoch} is that of the control under which it was steered. */
        void hold(ManagedDrone drone, @Nullable Long epoch);
    }

    /** A setpoint with who says it, and by what right. */
    record PendingSetpoint(
            CommandGate.Source source, ControlClearance.Cleared passage, Setpoint setpoint, long receivedNanos) {
        boolean goesOn(PendingSetpoint earlier) {
            return source.principal().name().equals(earlier.source.principal().name())
                    && source.face().equals(earlier.source.face())
                    && setpoint.summary().equals(earlier.setpoint.summary());
        }
    }

    /** One source at the helm. */
    private static final class SteeringSession {
        private final CommandRecord record;
        private PendingSetpoint last;
        private long lastNanos;

        SteeringSession(CommandRecord record, PendingSetpoint first, long nowNanos) {
            this.record = record;
            this.last = first;
            this.lastNanos = nowNanos;
        }
    }

    SetpointForwarder(ManagedDrone drone, SteeringLog log, HoldAction brake) {
        this.drone = drone;
        this.log = log;
        this.brake = brake;
    }

    /** Takes a setpoint in the place of one that still waits; false when the lane has no room. Any thread. */
    boolean offer(PendingSetpoint word) {
        if (newest.getAndSet(word) != null) {
            return true;
        }
        try {
            drone.lane().execute(this::steer);
            return true;
        } catch (RejectedExecutionException e) {
            newest.set(null);
            return false;
        }
    }

    /** That source steers no more, because of this; no-op when it does not steer. Any thread. */
    void stopSteering(CommandGate.Source source, Outcome why) {
        try {
            drone.lane().execute(() -> {
                SteeringSession now = turn;
                if (now != null && isOf(now.record, source)) {
                    newest.set(null);
                    end(now, why, true);
                }
            });
        } catch (RejectedExecutionException e) {
            LOG.warn("The lane of {} had no room to hear that nobody steers; it will see in half a second", drone.id());
        }
    }

    /**
     * That source may not steer so, because of this: if it did, it does no more. Written down, but not each time again, and not
     * of hands that are off the sticks. Any thread.
     */
    void refused(CommandGate.Source source, Setpoint setpoint, Outcome.Refused why) {
        try {
            drone.lane().execute(() -> {
                boolean isNews =
                        refusals.isNews(source, why.reason(), log.time().nanos());
                SteeringSession now = turn;
                if (now != null && isOf(now.record, source)) {
                    newest.set(null);
                    end(now, why, true);
                } else if (isNews && !setpoint.isStill()) {
                    CommandRecord refused = record(source, setpoint, null)
                            .ended(why, log.time().clock().instant());
                    log.journal()
                            .write(
                                    "who may not steer " + drone.id(),
                                    () -> log.store().begin(refused),
                                    () -> log.listener().commandChanged(refused));
                }
            });
        } catch (RejectedExecutionException e) {
            LOG.warn("The lane of {} had no room to hear why somebody may not steer: {}", drone.id(), why.reason());
        }
    }

    private static boolean isOf(CommandRecord record, CommandGate.Source source) {
        return record.by().equals(source.principal().name()) && record.face().equals(source.face());
    }

    private void steer() {
        PendingSetpoint word = newest.getAndSet(null);
        VehicleChannel channel = drone.channel().orElse(null);
        boolean late = word != null && log.time().nanos() - word.receivedNanos() > EXPIRES_NANOS;
        if (word == null || late || channel == null || !word.passage().fence().isOpen()) {
            return;
        }
        SteeringSession now = turn;
        if (now != null && !(word.goesOn(now.last) && now.last.passage().fence().isOpen())) {
            end(now, new Outcome.Superseded("Replaced by: " + word.setpoint().summary() + "."), false);
            now = null;
        }
        if (now == null) {
            now = begin(word);
        }
        still = null;
        drone.commandedFromHere(true);
        now.last = word;
        now.lastNanos = log.time().nanos();
        channel.steer(
                new SendAuthority(
                        now.record.id(),
                        word.passage().epoch(),
                        now.record.by(),
                        word.passage().fence()),
                word.setpoint());
    }

    private SteeringSession begin(PendingSetpoint word) {
        CommandRecord record =
                record(word.source(), word.setpoint(), word.passage().epoch());
        SteeringSession begun = new SteeringSession(record, word, log.time().nanos());
        turn = begun;
        log.journal()
                .write(
                        "who steers " + drone.id(),
                        () -> log.store().begin(record),
                        () -> log.listener().commandChanged(record));
        return begun;
    }

    private CommandRecord record(CommandGate.Source source, Setpoint setpoint, @Nullable Long epoch) {
        return new CommandRecord(
                new CommandId("steer-" + log.time().newId()),
                drone.id(),
                source.principal().name(),
                source.face(),
                "Steer",
                setpoint.summary(),
                log.time().clock().instant(),
                CommandPhase.ACCEPTED,
                null,
                null,
                null,
                epoch);
    }

    /**
     * Somebody else has control, or nobody: what was begun under the earlier one is over. A pilot who has it is not disturbed by
     * sticks in the middle.
     */
    void controlChanged() {
        Lease tenure = drone.control().control().tenure();
        boolean pilots = tenure != null && tenure.holder() instanceof LeaseHolder.Pilot;
        if (pilots) {
            still = null;
        }
        SteeringSession now = turn;
        if (now != null && !now.last.passage().fence().isOpen()) {
            end(
                    now,
                    new Outcome.Superseded("Control has changed hands. "
                            + drone.control().control().sentence()),
                    !pilots);
        }
    }

    /** A command now says where to fly. */
    void commanded(String summary) {
        newest.set(null);
        still = null;
        SteeringSession now = turn;
        if (now != null) {
            end(now, new Outcome.Superseded("Replaced by: " + summary + "."), false);
        }
    }

    private void end(SteeringSession ending, Outcome outcome, boolean standStill) {
        turn = null;
        CommandRecord done = ending.record.ended(outcome, log.time().clock().instant());
        log.journal()
                .write(
                        "that somebody steers " + drone.id() + " no more",
                        () -> log.store().finish(done),
                        () -> log.listener().commandChanged(done));
        if (standStill) {
            Setpoint said = ending.last.setpoint().still();
            still = said;
            stillLeft = STILL_TIMES;
            sendStandStill();
            if (!standsBySpeeds(said)) {
                brake.hold(drone, ending.last.passage().epoch());
            }
        }
    }

    /** What has no modes goes by the speeds that it is told, and stands by zeros. */
    private boolean standsBySpeeds(Setpoint said) {
        return said instanceof Setpoint.Velocity
                && drone.drone().state().capabilities().modes().isEmpty();
    }

    private void sendStandStill() {
        Setpoint saying = still;
        if (saying == null) {
            return;
        }
        stillNanos = log.time().nanos();
        stillLeft--;
        drone.channel().ifPresent(channel -> channel.steer(SAFETY, saying));
        if (stillLeft == 0) {
            still = null;
        }
    }

    @Override
    public void advance() {
        long now = log.time().nanos();
        SteeringSession steering = turn;
        if (steering != null && now - steering.lastNanos > EXPIRES_NANOS) {
            end(
                    steering,
                    new Outcome.TimedOut("Nothing more came for half a second; the vehicle was told to stand still."),
                    true);
        } else if (still != null && now - stillNanos > STILL_AGAIN_NANOS) {
            sendStandStill();
        }
    }
}
