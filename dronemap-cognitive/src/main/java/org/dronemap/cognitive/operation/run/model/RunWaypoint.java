package org.dronemap.cognitive.operation.run.model;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * The state of a waypoint in a mission run: which drone has it, visits, and the results of its tasks.
 *
 * @param drone whose it is, while it is {@link State#ASSIGNED} or {@link State#RESERVED}
 * @param visits the first is the one that counts; a further one only by a drone that was out of contact
 * @param reason why nobody visits it, as a sentence; null: somebody will, or did
 * @param leftOut for that reason the newest plan has nobody for it; the next one tries again
 * @param refusedBy drones whose vehicles do not fly what is to be done there
 * @param reports what became of the parts of its task; of those that nobody was seen to begin there is none
 */
@Stored(names = "waypoint state drone visits reason leftOut reports refusedBy", later = "refusedBy")
public record RunWaypoint(
        Waypoint waypoint,
        State state,
        @Nullable DroneId drone,
        List<Visit> visits,
        @Nullable String reason,
        boolean leftOut,
        List<Report> reports,
        List<DroneId> refusedBy) {
    /** The state of a waypoint in the run. */
    @Stored(names = "WAITING ASSIGNED RESERVED VISITED UNSERVED CANCELLED")
    public enum State {
        /** Nobody's yet. */
        WAITING,
        ASSIGNED,
        /** Of a drone that is not heard and may still fly there. */
        RESERVED,
        VISITED,
        UNSERVED,
        CANCELLED;

        /** Nothing will become of it any more. */
        public boolean isSettled() {
            return compareTo(VISITED) >= 0;
        }
    }

    /** {@code at}: when that was learned. */
    @Stored(names = "drone at")
    public record Visit(DroneId drone, Instant at) {}

    /**
     * The result of one part of a waypoint's task.
     *
     * @param at when it was learned
     * @param photo the number of the picture that it came to
     * @param words a sentence
     */
    @Stored(names = "part drone result at photo words")
    public record Report(
            int part,
            DroneId drone,
            Result result,
            Instant at,
            @Nullable Integer photo,
            String words) {
        /** The result of the part: under way, done, not known, or not available from the drone. */
        @Stored(names = "UNDER_WAY DONE NOT_KNOWN NOT_AVAILABLE")
        public enum Result {
            UNDER_WAY,
            DONE,
            /** The drone was told, and nothing shows what came of it. */
            NOT_KNOWN,
            /** Nothing of the kind is told by the drone. */
            NOT_AVAILABLE
        }
    }

    public RunWaypoint {
        reports = List.copyOf(reports);
        visits = List.copyOf(visits);
        refusedBy = List.copyOf(refusedBy);
    }

    public static RunWaypoint waiting(Waypoint waypoint) {
        return new RunWaypoint(waypoint, State.WAITING, null, List.of(), null, false, List.of(), List.of());
    }

    public String id() {
        return waypoint.id();
    }

    public boolean isTwice() {
        return visits.size() > 1;
    }

    public RunWaypoint to(State next, @Nullable DroneId whose, @Nullable String why) {
        return new RunWaypoint(waypoint, next, whose, visits, why, false, reports, refusedBy);
    }

    public RunWaypoint leftOut(@Nullable String why) {
        return new RunWaypoint(waypoint, State.WAITING, null, visits, why, true, reports, refusedBy);
    }

    /** That drone does not fly it, nor is it planned for it again. */
    public RunWaypoint refusedBy(DroneId one) {
        List<DroneId> refused = new ArrayList<>(refusedBy);
        refused.add(one);
        return new RunWaypoint(waypoint, state, drone, visits, reason, leftOut, reports, refused);
    }

    public Optional<Report> report(int part) {
        return reports.stream().filter(report -> report.part() == part).findFirst();
    }

    /** In the place of what was reported of that part before. */
    public RunWaypoint with(Report newer) {
        List<Report> all = new ArrayList<>(
                reports.stream().filter(report -> report.part() != newer.part()).toList());
        all.add(newer);
        all.sort(Comparator.comparingInt(Report::part));
        return new RunWaypoint(waypoint, state, drone, visits, reason, leftOut, all, refusedBy);
    }

    /** Somewhere else, where nothing was done yet. */
    public RunWaypoint with(Waypoint other) {
        return new RunWaypoint(other, state, drone, visits, leftOut ? null : reason, false, List.of(), List.of());
    }

    public boolean isVisitedBy(DroneId by) {
        return state == State.VISITED
                && visits.stream().anyMatch(visit -> visit.drone().equals(by));
    }

    /** Whoever it is: the same drone does not count twice. */
    public RunWaypoint visited(DroneId by, Instant at) {
        if (visits.stream().anyMatch(visit -> visit.drone().equals(by))) {
            return this;
        }
        List<Visit> all = new ArrayList<>(visits);
        all.add(new Visit(by, at));
        return new RunWaypoint(waypoint, State.VISITED, null, all, null, false, reports, refusedBy);
    }
}
