package org.dronemap.core.cloud;

import java.time.Clock;
import java.util.Optional;
import org.dronemap.core.access.Principal;
import org.dronemap.core.cloud.lane.InternalFaults;
import org.dronemap.core.cloud.lane.Lane;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.cloud.listener.CloudListener;
import org.dronemap.core.cloud.rule.CommandRules;
import org.dronemap.core.cloud.rule.CommandTimeoutWatch;
import org.dronemap.core.cloud.rule.CommandTracker;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandKind;
import org.dronemap.core.command.CommandPhase;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.CommandStore;
import org.dronemap.core.command.Contention;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.time.Time;
import org.jspecify.annotations.Nullable;

/**
 * Sends commands that were accepted and stored to their vehicles, each until it has its one outcome. On the drones'
 * lanes.
 */
final class CommandDispatcher {
    private static final Refusal NO_LINK = new Refusal(OutcomeCode.LINK_MISSING, "There is no link to the drone.");

    private final PendingCommands underway;
    private final RouteCheck judge;
    private final StoreWriter journal;
    private final CommandStore store;
    private final Time time;
    private final Clock clock;
    private final CloudListener listener;

    /** Check of a command against the zones and the flight bounds of an access key; gives the reason for a refusal. */
    interface RouteCheck {
        Optional<Refusal> whyNotThere(Principal principal, DroneState drone, Command command);
    }

    CommandDispatcher(
            PendingCommands underway,
            RouteCheck judge,
            StoreWriter journal,
            CommandStore store,
            Time time,
            CloudListener listener) {
        this.underway = underway;
        this.judge = judge;
        this.journal = journal;
        this.store = store;
        this.time = time;
        this.clock = time.clock();
        this.listener = listener;
    }

    /** Ends what was given under control that somebody else has now. */
    void stopOutdated(ManagedDrone drone) {
        for (PendingCommand entry : underway.of(drone)) {
            if (entry.open().record().outcome() == null && entry.isOutdated()) {
                abort(entry, outdated(entry));
            }
        }
    }

    private void endOutdated(PendingCommand entry) {
        end(entry, outdated(entry));
    }

    private static Outcome outdated(PendingCommand entry) {
        return new Outcome.Superseded("Control has changed hands. "
                + entry.drone().control().control().sentence());
    }

    void perform(PendingCommand entry) {
        if (entry.isOutdated()) {
            endOutdated(entry);
            return;
        }
        if (!entry.open().record().face().equals(CommandGate.SAFETY.face())
                && entry.open().isLate(time.nanos())) {
            end(entry, CommandTracker.LATE);
            return;
        }
        VehicleChannel channel = channel(entry);
        if (channel == null) {
            return;
        }
        Refusal busy = supersedeOlder(entry, channel);
        if (busy != null) {
            end(entry, new Outcome.Refused(CommandGate.GATE, busy));
            return;
        }
        if (entry.open().command().kind().contention() == Contention.FLIGHT) {
            entry.drone().setpoints().commanded(entry.open().record().summary());
        }
        Lane.TimedTask guard = guard(entry);
        long since = entry.drone().lane().activeNanos();
        if (!entry.drone().preparation().delays(entry, () -> sendPrepared(entry, guard, since))) {
            send(entry, guard, channel);
        }
    }

    /** What a rule has to do with the vehicle while something else waits for that. */
    void performFirst(PendingCommand entry) {
        VehicleChannel channel = channel(entry);
        if (channel != null) {
            send(entry, guard(entry), channel);
        }
    }

    /** After what came first: what has changed meanwhile is judged anew, and waiting for that made nothing late. */
    private void sendPrepared(PendingCommand entry, Lane.TimedTask guard, long since) {
        if (entry.open().record().outcome() != null) {
            return;
        }
        long waited = entry.drone().lane().activeNanos() - since;
        if (entry.isOutdated()) {
            endOutdated(entry);
        } else if (entry.open().isLate(time.nanos() - waited)) {
            end(entry, CommandTracker.LATE);
        } else {
            VehicleChannel channel = channel(entry);
            if (channel != null) {
                send(entry, guard, channel);
            }
        }
    }

    /** The way down, if the command may go it now; else the command has ended. */
    private @Nullable VehicleChannel channel(PendingCommand entry) {
        DroneState now = entry.drone().drone().state();
        Command command = entry.open().command();
        Optional<Refusal> why = InternalFaults.judging(
                command.summary(),
                () -> CommandRules.whyNot(now, command).or(() -> judge.whyNotThere(entry.principal(), now, command)));
        Optional<VehicleChannel> channel = entry.drone().channel();
        if (why.isPresent() || channel.isEmpty()) {
            end(entry, new Outcome.Refused(CommandGate.GATE, why.orElse(NO_LINK)));
            return null;
        }
        return channel.get();
    }

    private Lane.TimedTask guard(PendingCommand entry) {
        Lane.TimedTask guard =
                new CommandTimeoutWatch(entry.open(), entry.drone().lane(), outcome -> abort(entry, outcome));
        entry.drone().lane().addTimedTask(guard);
        return guard;
    }

    private void send(PendingCommand entry, Lane.TimedTask guard, VehicleChannel channel) {
        Command command = entry.open().command();
        if (command.kind().purpose() != CommandKind.Purpose.READ) {
            entry.drone().commandedFromHere(true);
        }
        InternalFaults.doing(
                        command.summary(), () -> channel.perform(entry.mandate(), command, new Reporter(entry, guard)))
                .ifPresent(fault -> abort(entry, new Outcome.Refused(CommandGate.GATE, fault)));
    }

    /** Nothing more of it goes out. */
    void abort(PendingCommand entry, Outcome outcome) {
        entry.drone()
                .channel()
                .ifPresent(channel -> channel.cancel(entry.open().record().id()));
        end(entry, outcome);
    }

    /** Newer flight commands replace older ones; of all others the first one goes on. */
    private @Nullable Refusal supersedeOlder(PendingCommand entry, VehicleChannel channel) {
        Contention contention = entry.open().command().kind().contention();
        for (PendingCommand other : underway.before(entry)) {
            if (!contention.newerWins()) {
                return contention == Contention.TRANSFER
                        ? new Refusal(
                                OutcomeCode.TRANSFER_UNDER_WAY,
                                "Another mission transfer with this drone is under way; wait for its end.")
                        : new Refusal(
                                OutcomeCode.COMMAND_UNDER_WAY,
                                "Wait for the end of what is under way: "
                                        + other.open().record().summary() + ".");
            }
            channel.cancel(other.open().record().id());
            end(
                    other,
                    new Outcome.Superseded(
                            "Replaced by: " + entry.open().record().summary() + "."));
        }
        return null;
    }

    void end(PendingCommand entry, Outcome outcome) {
        CommandRecord before = entry.open().record();
        if (before.outcome() != null) {
            return;
        }
        if (!(outcome instanceof Outcome.Refused)) {
            boolean disarmed =
                    Boolean.FALSE.equals(entry.drone().drone().state().armed());
            entry.drone()
                    .recentModeCommands()
                    .ended(
                            entry.open().command(),
                            disarmed,
                            entry.drone().lane().activeNanos());
        }
        if (entry.isUnderControl()) {
            // Idle counts from here.
            entry.drone().control().apply(new LeaseEvent.TimeAdvanced(true, false));
        }
        CommandRecord done = before.ended(outcome, clock.instant());
        entry.open().ended(done, entry.drone().lane().activeNanos());
        journal.write("the outcome of " + done.summary(), () -> store.finish(done), () -> {
            entry.open().written();
            listener.commandChanged(done);
            underway.remove(entry);
            entry.end().complete(done);
        });
        entry.drone().preparation().ended(entry, outcome);
    }

    /** Receiver of the vehicle channel's reports on one command; updates the command's record. */
    private final class Reporter implements VehicleChannel.Report {
        private final PendingCommand entry;
        private final Lane.TimedTask guard;

        Reporter(PendingCommand entry, Lane.TimedTask guard) {
            this.entry = entry;
            this.guard = guard;
        }

        @Override
        public void accepted() {
            update(entry.open().record().withPhase(CommandPhase.ACCEPTED));
        }

        @Override
        public void progress(int done, int total) {
            update(entry.open().record().withProgress(new CommandRecord.Progress(done, total)));
        }

        @Override
        public void ended(Outcome outcome) {
            entry.drone().lane().removeTimedTask(guard);
            end(entry, outcome);
        }

        private void update(CommandRecord newer) {
            if (entry.open().record().outcome() == null) {
                entry.open().update(newer, entry.drone().lane().activeNanos());
                listener.commandChanged(newer);
            }
        }
    }
}
