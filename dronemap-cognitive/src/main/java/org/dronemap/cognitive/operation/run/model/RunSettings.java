package org.dronemap.cognitive.operation.run.model;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.Objective;
import org.dronemap.cognitive.problem.PlanningRules;
import org.dronemap.cognitive.problem.UniformWind;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * Settings of a mission run: zones, wind, objective, rules, approval mode and time to search.
 *
 * @param pool null: its drones were named
 */
@Stored(names = "barriers wind objective rules mode onCloudLoss seed search pool", later = "pool")
public record RunSettings(
        List<Barrier> barriers,
        UniformWind wind,
        Objective objective,
        PlanningRules rules,
        RunOrder.ApprovalMode mode,
        MissionCloudLossPolicy onCloudLoss,
        long seed,
        Duration search,
        @Nullable RunPool pool) {
    public RunSettings {
        barriers = List.copyOf(barriers);
    }

    public static RunSettings of(RunOrder order) {
        return new RunSettings(
                order.problem().barriers(),
                order.problem().wind(),
                order.problem().objective(),
                order.problem().rules(),
                order.mode(),
                order.onCloudLoss(),
                order.seed(),
                order.search(),
                order.upTo() == null ? null : new RunPool(order.upTo(), null));
    }

    public RunSettings with(Barrier barrier) {
        List<Barrier> all = new ArrayList<>(barriers);
        all.add(barrier);
        return new RunSettings(all, wind, objective, rules, mode, onCloudLoss, seed, search, pool);
    }

    public RunSettings with(RunPool other) {
        return new RunSettings(barriers, wind, objective, rules, mode, onCloudLoss, seed, search, other);
    }
}
