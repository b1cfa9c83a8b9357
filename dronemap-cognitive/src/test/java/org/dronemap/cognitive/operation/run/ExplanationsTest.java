package org.dronemap.cognitive.operation.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.dronemap.cognitive.replan.Replanned;
import org.dronemap.core.command.CloudLoss;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** What people read of a changed plan is what the journal has of it. */
class ExplanationsTest {
    @ParameterizedTest
    @EnumSource(RunOrder.Mode.class)
    void tellOfAPlanWhatTheJournalHasOfIt(RunOrder.Mode mode) {
        TestFleet fleet = eventful(mode);
        Set<Trigger> told = EnumSet.noneOf(Trigger.class);
        RunState before = fleet.first;
        for (int i = 0; i < fleet.journal.size(); i++) {
            RunState after = fleet.decisions.get(i).next();
            if (fleet.journal.get(i) instanceof RunInput.Replanned input && input.result() != null) {
                for (Explanation each : since(before, after)) {
                    told.add(each.trigger());
                    tells(each, before, input.result());
                }
            }
            before = after;
        }
        assertThat(told).contains(Trigger.CRASHED, Trigger.WAYPOINTS_ADDED);
    }

    @Test
    void tellNoFiguresWhereNothingWasPlanned() {
        TestFleet fleet = eventful(RunOrder.Mode.AUTOMATIC);
        assertThat(fleet.state.explanations())
                .filteredOn(each -> each.trigger() == Trigger.START || each.trigger() == Trigger.ENDED)
                .hasSize(2)
                .allMatch(each -> each.moved().isEmpty() && each.before() == null && each.after() == null);
    }

    private static void tells(Explanation told, RunState before, Replanned result) {
        Cause first = before.request().first();
        assertThat(told.trigger()).isEqualTo(first.trigger());
        assertThat(told.drone()).isEqualTo(first.drone());
        assertThat(told.moved()).isEqualTo(result.changes().moved());
        assertThat(told.before()).isEqualTo(result.before());
        assertThat(told.after()).isEqualTo(result.after());
        assertThat(told.words())
                .contains(first.words())
                .contains(String.format(
                        Locale.ROOT, "back in %.0f s; before,", result.after().longestSeconds()))
                .contains(
                        String.format(Locale.ROOT, "in %.0f s.", result.before().longestSeconds()));
        result.changes().moved().forEach(moved -> assertThat(told.words()).contains(moved.waypoint()));
    }

    private static List<Explanation> since(RunState before, RunState after) {
        int last = before.explanations().stream()
                .mapToInt(Explanation::number)
                .max()
                .orElse(0);
        return after.explanations().stream()
                .filter(each -> each.number() > last)
                .toList();
    }

    /** A drone falls, and waypoints are added. */
    private static TestFleet eventful(RunOrder.Mode mode) {
        TestFleet fleet = Runs.fleet(Runs.problem(3, 30, 1, false), 1, mode, CloudLoss.RETURN_TO_LAUNCH);
        fleet.flyUntil(() -> fleet.state.count(Target.State.VISITED) >= 3, 600);
        fleet.vehicle(1).falling = true;
        answered(fleet, 30);
        Runs.addTwoWaypoints(fleet);
        answered(fleet, 30);
        fleet.flyToTheEnd();
        return fleet;
    }

    private static void answered(TestFleet fleet, double seconds) {
        for (double t = 0; t < seconds; t++) {
            fleet.fly(1);
            Proposal open = fleet.state.proposal();
            if (open != null) {
                fleet.wish(new RunInput.Answer(fleet.now, "Ann", open.number(), true));
            }
        }
    }
}
