package org.dronemap.core.cloud.rule;

import java.time.Duration;
import java.util.function.Consumer;
import org.dronemap.core.cloud.lane.Lane;
import org.dronemap.core.command.Outcome;

/** Ends a command with an unknown outcome when nothing was heard of it for 90 seconds. Owned by the drone's lane. */
public final class CommandTimeoutWatch implements Lane.TimedTask {
    /** No command goes without a sign for longer than this. */
    public static final Duration LONGEST_SILENCE = Duration.ofSeconds(90);

    private static final Outcome UNHEARD = new Outcome.Unknown(
            "Nothing was heard of it for " + LONGEST_SILENCE.toSeconds() + " s; look at the drone.");

    private final CommandTracker command;
    private final Lane lane;
    private final Consumer<Outcome> giveUp;

    public CommandTimeoutWatch(CommandTracker command, Lane lane, Consumer<Outcome> giveUp) {
        this.command = command;
        this.lane = lane;
        this.giveUp = giveUp;
    }

    @Override
    public void advance() {
        if (command.record().outcome() != null) {
            lane.removeTimedTask(this);
        } else if (command.silentFor(lane.activeNanos(), LONGEST_SILENCE.toNanos())) {
            lane.removeTimedTask(this);
            giveUp.accept(UNHEARD);
        }
    }

    /** What would follow now in flight was wanted then; what is read and written goes on. */
    @Override
    public void stoodStill(Duration how) {
        if (command.record().outcome() == null
                && command.command().kind().contention().newerWins()) {
            lane.removeTimedTask(this);
            giveUp.accept(new Outcome.Unknown("The server stood still for " + how.toSeconds()
                    + " s, so it was not gone on with; look at the drone."));
        }
    }
}
