package org.dronemap.core.conduct;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.separation.FlightIntent;
import org.dronemap.core.separation.SeparationBoard;
import org.dronemap.core.time.Time;

/**
 * Keeps drones that no operation has on the ground until they rise into nobody's way. Any thread; a wait holds no thread.
 */
public final class TakeOffClearance {
    private static final Duration BETWEEN_LOOKS = Duration.ofMillis(250);
    /** What was put down before one of them has begun is seen by the next one. */
    private static final long ROUNDS_TO_SEE = 2;

    private final SeparationBoard board;
    private final Time time;

    public TakeOffClearance(SeparationBoard board, Time time) {
        this.board = board;
        this.time = time;
    }

    /**
     * Completes as soon as that drone may rise; from then on others wait for it until {@link #forget}.
     *
     * @param items its mission
     * @param stopped it shall not rise any more: then it need not wait either
     * @param blocked is run once it has to wait for another drone
     */
    public CompletableFuture<Boolean> await(
            DroneId drone, List<MissionItem> items, CompletableFuture<?> stopped, Runnable blocked) {
        long asked = board.rounds();
        if (asked == 0) {
            return CompletableFuture.completedFuture(true);
        }
        FlightIntent intent = new FlightIntent(
                FlightIntent.Step.RISE, items, null, true, time.clock().instant());
        board.intend(key(drone), Map.of(drone, intent));
        return look(drone, asked + ROUNDS_TO_SEE, stopped, blocked);
    }

    private CompletableFuture<Boolean> look(DroneId drone, long round, CompletableFuture<?> stopped, Runnable blocked) {
        boolean free = board.giveWay(drone).isEmpty();
        if ((free && board.rounds() >= round) || stopped.isDone()) {
            return CompletableFuture.completedFuture(true);
        }
        if (!free) {
            blocked.run();
        }
        Runnable next = free ? blocked : () -> {};
        return time.within(new CompletableFuture<Boolean>(), BETWEEN_LOOKS, true)
                .thenCompose(later -> look(drone, round, stopped, next));
    }

    /** It is in the air, or stays on the ground. */
    public void forget(DroneId drone) {
        board.intend(key(drone), Map.of());
    }

    private static String key(DroneId drone) {
        return "take-off of " + drone;
    }
}
