package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.Objective;
import org.dronemap.cognitive.problem.Rules;
import org.dronemap.cognitive.problem.Wind;
import org.dronemap.core.command.CloudLoss;
import org.dronemap.core.stored.Stored;

/** Settings of a run: zones, wind, objective, rules, approval mode and time to search. */
@Stored(names = "barriers wind objective rules mode onCloudLoss seed search")
public record Setting(
        List<Barrier> barriers,
        Wind wind,
        Objective objective,
        Rules rules,
        RunOrder.Mode mode,
        CloudLoss onCloudLoss,
        long seed,
        Duration search) {
    public Setting {
        barriers = List.copyOf(barriers);
    }

    static Setting of(RunOrder order) {
        return new Setting(
                order.problem().barriers(),
                order.problem().wind(),
                order.problem().objective(),
                order.problem().rules(),
                order.mode(),
                order.onCloudLoss(),
                order.seed(),
                order.search());
    }

    Setting with(Barrier barrier) {
        List<Barrier> all = new ArrayList<>(barriers);
        all.add(barrier);
        return new Setting(all, wind, objective, rules, mode, onCloudLoss, seed, search);
    }
}
