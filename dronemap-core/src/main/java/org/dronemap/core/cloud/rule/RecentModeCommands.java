package org.dronemap.core.cloud.rule;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Contention;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.Capabilities.Steering;

/**
 * Commands to one drone that just ended and may still change its mode, so that no pilot is suspected of it. Any thread.
 */
public final class RecentModeCommands {
    private static final long EFFECT_NANOS = Duration.ofSeconds(5).toNanos();
    private static final int MOST = 16;

    private final Deque<Ended> ended = new ArrayDeque<>();

    private record Ended(Command command, long nanos) {}

    /** {@code disarmed}: for certain, when it ended. */
    public synchronized void ended(Command command, boolean disarmed, long nowNanos) {
        if (!moves(command, disarmed)) {
            return;
        }
        if (ended.size() == MOST) {
            ended.removeFirst();
        }
        ended.addLast(new Ended(command, nowNanos));
    }

    public synchronized List<Command> at(long nowNanos) {
        return ended.stream()
                .filter(one -> nowNanos - one.nanos() < EFFECT_NANOS)
                .map(Ended::command)
                .toList();
    }

    /** Uploads too: they may hold a drone that flies its mission, but no drone that stands. */
    private static boolean moves(Command command, boolean disarmed) {
        Contention contention = command.kind().contention();
        return contention.newerWins() || (contention == Contention.TRANSFER && !disarmed);
    }

    /** Whether that command may put a vehicle that {@code can} this into a mode. */
    public static boolean mayLeadTo(Command command, String mode, Capabilities can) {
        Steering by = can.steering(mode).orElse(null);
        return switch (command.kind().movement()) {
            case NONE, CHANGES_SPEED -> false;
            case CHANGES_MODE -> ((Command.SetMode) command).mode().equals(mode);
            case STANDS, TAKES_MISSION ->
                by == null || by.acceptsCommands() || (by == Steering.STICKS && mayStandIn(mode, can));
            case CLIMBS, GOES, GOES_ON_ITS_MAP, TURNS -> by == null || by.acceptsCommands();
            case FLIES_MISSION -> by == null || by.acceptsCommands() || by == Steering.MISSION;
            case COMES_DOWN -> by == null || by.isSafe() || by == Steering.MISSION;
        };
    }

    /** Vehicles without a mode to stand in are put into one for sticks; others at most into the usual one. */
    private static boolean mayStandIn(String mode, Capabilities can) {
        return !can.steering().containsValue(Steering.STANDS)
                || can.mode(Steering.STICKS).equals(Optional.of(mode));
    }
}
