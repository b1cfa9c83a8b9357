package org.dronemap.cognitive.operation.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.dronemap.cognitive.operation.run.model.ReplanCause;
import org.dronemap.cognitive.operation.run.model.ReplanProposal;
import org.dronemap.cognitive.operation.run.model.RunExplanation;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunOrder;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.replan.ReplanResult;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** What people read of a changed plan is what the journal has of it. */
class ExplanationsTest {
    @ParameterizedTest
    @EnumSource(RunOrder.ApprovalMode.class)
    void tellOfAPlanWhatTheJournalHasOfIt(RunOrder.ApprovalMode mode) {
        RunTestBench fleet = eventful(mode);
        Set<RunTrigger> told = EnumSet.noneOf(RunTrigger.class);
        RunState before = fleet.first;
        for (int i = 0; i < fleet.journal.size(); i++) {
            RunState after = fleet.decisions.get(i).next();
            if (fleet.journal.get(i) instanceof RunInput.ReplanEnded input && input.result() != null) {
                for (RunExplanation each : since(before, after)) {
                    told.add(each.trigger());
                    tells(each, before, input.result());
                }
            }
            before = after;
        }
        assertThat(told).contains(RunTrigger.CRASHED, RunTrigger.WAYPOINTS_ADDED);
    }

    @Test
    void tellNoFiguresWhereNothingWasPlanned() {
        RunTestBench fleet = eventful(RunOrder.ApprovalMode.AUTOMATIC);
        assertThat(fleet.state.explanations())
                .filteredOn(each -> each.trigger() == RunTrigger.START || each.trigger() == RunTrigger.ENDED)
                .hasSize(2)
                .allMatch(each -> each.moved().isEmpty() && each.before() == null && each.after() == null);
    }

    private static void tells(RunExplanation told, RunState before, ReplanResult result) {
        ReplanCause first = before.request().first();
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

    private static List<RunExplanation> since(RunState before, RunState after) {
        int last = before.explanations().stream()
                .mapToInt(RunExplanation::number)
                .max()
                .orElse(0);
        return after.explanations().stream()
                .filter(each -> each.number() > last)
                .toList();
    }

    /** A drone falls, and waypoints are added. */
    private static RunTestBench eventful(RunOrder.ApprovalMode mode) {
        RunTestBench fleet = RunFixtures.fleet(
                RunFixtures.problem(3, 30, 1, false), 1, mode, MissionCloudLossPolicy.RETURN_TO_LAUNCH);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);
        fleet.vehicle(1).falling = true;
        answered(fleet, 30);
        RunFixtures.addTwoWaypoints(fleet);
        answered(fleet, 30);
        fleet.flyToTheEnd();
        return fleet;
    }

    private static void answered(RunTestBench fleet, double seconds) {
        for (double t = 0; t < seconds; t++) {
            fleet.fly(1);
            ReplanProposal open = fleet.state.proposal();
            if (open != null) {
                fleet.wish(new RunInput.AnswerProposal(fleet.now, "Ann", open.number(), true));
            }
        }
    }
}
