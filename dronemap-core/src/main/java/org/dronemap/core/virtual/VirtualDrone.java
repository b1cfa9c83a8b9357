package org.dronemap.core.virtual;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.organisation.OrganisationId;
import org.jspecify.annotations.Nullable;

/**
 * A virtual drone: what a user owns and plans with; a real drone of the warehouse serves it when it flies.
 *
 * @param owner the name of the user it belongs to, as it was then
 * @param account of that user
 * @param organisation the owner's; only its drones serve
 * @param mission as planned; null: none yet
 * @param run the last one; null: it was never started
 * @param recalled drones that fell silent while they served it and are to be called home when they are heard again
 */
public record VirtualDrone(
        VirtualDroneId id,
        String name,
        String owner,
        String account,
        OrganisationId organisation,
        DroneRequirements needs,
        @Nullable Mission mission,
        @Nullable VirtualRun run,
        List<DroneId> recalled,
        Instant createdAt) {
    public VirtualDrone {
        recalled = List.copyOf(recalled);
    }

    public VirtualDrone with(@Nullable VirtualRun next) {
        return new VirtualDrone(id, name, owner, account, organisation, needs, mission, next, recalled, createdAt);
    }

    public VirtualDrone with(String newName, DroneRequirements newNeeds, @Nullable Mission planned) {
        return new VirtualDrone(id, newName, owner, account, organisation, newNeeds, planned, run, recalled, createdAt);
    }

    public VirtualDrone recalling(DroneId drone) {
        List<DroneId> all = new ArrayList<>(recalled);
        all.remove(drone);
        all.add(drone);
        return new VirtualDrone(id, name, owner, account, organisation, needs, mission, run, all, createdAt);
    }

    public VirtualDrone home(DroneId drone) {
        List<DroneId> rest =
                recalled.stream().filter(other -> !other.equals(drone)).toList();
        return new VirtualDrone(id, name, owner, account, organisation, needs, mission, run, rest, createdAt);
    }

    /** The drone that serves it; null: none. */
    public @Nullable DroneId boundTo() {
        VirtualRunAssignment assignment = run == null ? null : run.assignment();
        return assignment == null ? null : assignment.drone();
    }

    public boolean isWaiting() {
        return run != null && run.stage() == VirtualRunStage.QUEUED;
    }

    /** From being asked for to the end. */
    public boolean isUnderWay() {
        return run != null && !run.stage().isOver();
    }
}
