package org.dronemap.core.cloud;

import java.time.Duration;

/** Ends a command that nobody says anything about any more, so that none is silently lost. Owned by the drone's lane. */
final class Overdue implements Lane.Ticker {
    /** No command goes without a sign for longer than this. */
    private static final long LONGEST_SILENCE_NANOS = Duration.ofSeconds(90).toNanos();

    private final OpenCommand command;
    private final Lane lane;
    private final Runnable giveUp;

    Overdue(OpenCommand command, Lane lane, Runnable giveUp) {
        this.command = command;
        this.lane = lane;
        this.giveUp = giveUp;
    }

    @Override
    public void tick() {
        if (command.record().outcome() != null) {
            lane.removeTicker(this);
        } else if (command.silentFor(lane.activeNanos(), LONGEST_SILENCE_NANOS)) {
            lane.removeTicker(this);
            giveUp.run();
        }
    }
}
