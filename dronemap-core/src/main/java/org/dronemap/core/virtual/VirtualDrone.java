package org.dronemap.core.virtual;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.organisation.OrganisationId;
import org.jspecify.annotations.Nullable;

/**
 * A virtual drone: what a user owns and plans with; real drones of the warehouse serve it when it flies.
 *
 * @param owner the name of the user it belongs to, as it was then
 * @param account of that user
 * @param organisation the owner's; only its drones serve
 * @param runs the last time that its mission was asked for: one run for each share of it; none: it was never started
 * @param recalled drones that fell silent while they served it and are to be called home when they are heard again
 */
public record VirtualDrone(
        VirtualDroneId id,
        String name,
        String owner,
        String account,
        OrganisationId organisation,
        VirtualPlan plan,
        List<VirtualRun> runs,
        List<DroneId> recalled,
        Instant createdAt) {
    public VirtualDrone {
        runs = List.copyOf(runs);
        recalled = List.copyOf(recalled);
    }

    public DroneRequirements needs() {
        return plan.needs();
    }

    /** As planned; null: none yet. */
    public @Nullable Mission mission() {
        return plan.mission();
    }

    public VirtualDrone with(List<VirtualRun> next) {
        return new VirtualDrone(id, name, owner, account, organisation, plan, next, recalled, createdAt);
    }

    /** That share, counted from 0, goes on so. */
    public VirtualDrone with(int share, VirtualRun next) {
        List<VirtualRun> all = new ArrayList<>(runs);
        all.set(share, next);
        return with(all);
    }

    public VirtualDrone with(String newName, VirtualPlan planned) {
        return new VirtualDrone(id, newName, owner, account, organisation, planned, runs, recalled, createdAt);
    }

    public VirtualDrone recalling(DroneId drone) {
        List<DroneId> all = new ArrayList<>(recalled);
        all.remove(drone);
        all.add(drone);
        return new VirtualDrone(id, name, owner, account, organisation, plan, runs, all, createdAt);
    }

    public VirtualDrone home(DroneId drone) {
        List<DroneId> rest =
                recalled.stream().filter(other -> !other.equals(drone)).toList();
        return new VirtualDrone(id, name, owner, account, organisation, plan, runs, rest, createdAt);
    }

    /** The drones that serve it, in the order of its shares. */
    public List<DroneId> bound() {
        return runs.stream().map(VirtualRun::boundTo).filter(Objects::nonNull).toList();
    }

    /** Some of it waits for a drone. */
    public boolean isWaiting() {
        return runs.stream().anyMatch(VirtualRun::isWaiting);
    }

    /** From being asked for to the end of all shares. */
    public boolean isUnderWay() {
        return runs.stream().anyMatch(run -> !run.stage().isOver());
    }

    /** That drone could not go on with one of its shares, and is not asked again yet. */
    public boolean avoids(DroneState drone, Instant now) {
        return runs.stream().anyMatch(run -> VirtualRunMachine.avoids(run, drone, now));
    }
}
