package org.dronemap.cognitive.operation.run;

import java.time.Instant;
import java.util.List;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.VehicleKind;
import org.jspecify.annotations.Nullable;

/**
 * One drone of the run.
 *
 * @param craft as planned with; where it is when something is planned anew is looked at then
 * @param since when it came to this stage
 * @param orders the waypoints that it is to visit, in order, without those that it has visited
 * @param sortie what it has on board, or is about to get on the ground; null: nothing yet
 * @param passed how many items of that are behind it
 * @param next what it is about to get in the air in its place
 * @param errand the command that is under way
 * @param failures how often the present step failed
 * @param note why it is not flying its waypoints, as a sentence
 * @param signs what has been noticed of it and may pass
 */
public record RunDrone(
        Craft craft,
        String name,
        VehicleKind kind,
        DroneStage stage,
        Instant since,
        List<String> orders,
        @Nullable Sortie sortie,
        int passed,
        @Nullable Sortie next,
        @Nullable Errand errand,
        int failures,
        @Nullable String note,
        Signs signs) {
    /** A command that it was given; {@code asOf}: when. */
    public record Errand(CommandId command, Kind kind, Instant asOf) {
        /** What it is for. */
        public enum Kind {
            UPLOAD,
            MODE,
            ARM,
            START,
            HOLD,
            HOME,
            DISARM
        }
    }

    /**
     * What lasts.
     *
     * @param falling since when it falls, or leans as nothing that flies does
     * @param astray since when it is off its path
     * @param silentUntil till then it may still fly, and what is reserved for it stays so
     * @param lastPlace where it was when it was heard last
     * @param yields for which drone it waits
     * @param warned it was said that it is late
     */
    public record Signs(
            @Nullable Instant falling,
            @Nullable Instant astray,
            @Nullable Instant silentUntil,
            @Nullable Place lastPlace,
            @Nullable DroneId yields,
            boolean warned) {
        public static final Signs NONE = new Signs(null, null, null, null, null, false);
    }

    public RunDrone {
        orders = List.copyOf(orders);
    }

    public DroneId id() {
        return craft.id();
    }

    /** What it will have been given last. */
    @Nullable
    Sortie latest() {
        return next == null ? sortie : next;
    }
}
