package org.dronemap.cognitive.operation.run.model;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.dronemap.cognitive.plan.Plan;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * The order that a mission run begins with: problem, accepted plan, drones and settings.
 *
 * @param id its commands are named after it: at most 48 characters, without dots
 * @param plan the accepted one, which the independent checker found no fault with
 * @param members all drones of the problem
 * @param search how long a better plan is looked for when something changes
 * @param upTo so many drones of the pool fly it, which the cloud chooses; null: they were named
 */
public record RunOrder(
        OperationId id,
        PlanningProblem problem,
        Plan plan,
        List<Member> members,
        ApprovalMode mode,
        MissionCloudLossPolicy onCloudLoss,
        long seed,
        Duration search,
        Instant at,
        @Nullable Integer upTo) {
    private static final Duration LONGEST_SEARCH = Duration.ofMinutes(1);

    /** A drone as people know it, and what it is: how a mission ends depends on that. */
    public record Member(DroneId drone, String name, VehicleKind kind) {}

    /** The approval mode: who decides on a changed plan. */
    @Stored(names = "AUTOMATIC ASK_FIRST")
    public enum ApprovalMode {
        AUTOMATIC,
        /** Somebody is asked; what is unsafe for one drone is acted on all the same. */
        ASK_FIRST
    }

    /** By drones that were named. */
    public RunOrder(
            OperationId id,
            PlanningProblem problem,
            Plan plan,
            List<Member> members,
            ApprovalMode mode,
            MissionCloudLossPolicy onCloudLoss,
            long seed,
            Duration search,
            Instant at) {
        this(id, problem, plan, members, mode, onCloudLoss, seed, search, at, null);
    }

    public RunOrder {
        members = List.copyOf(members);
        if (!id.value().matches("[A-Za-z0-9_-]{1,48}")) {
            throw new IllegalArgumentException("a run is named by 1 to 48 letters, digits, '_' and '-': " + id);
        }
        if (search.isNegative() || search.compareTo(LONGEST_SEARCH) > 0) {
            throw new IllegalArgumentException("a search takes 0 to 60 s: " + search);
        }
        List<DroneId> known = members.stream().map(Member::drone).toList();
        problem.crafts().forEach(craft -> {
            if (!known.contains(craft.id())) {
                throw new IllegalArgumentException("the drone " + craft.id() + " is no member of the run");
            }
        });
    }
}
