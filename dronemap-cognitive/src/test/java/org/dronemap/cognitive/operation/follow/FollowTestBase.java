package org.dronemap.cognitive.operation.follow;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.cognitive.follow.StandOffSide;
import org.dronemap.cognitive.operation.follow.FollowInput.Observation;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.operation.ChosenDrone;
import org.dronemap.core.operation.OperationAction;
import org.dronemap.core.operation.OperationDecision;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.ReporterState;
import org.dronemap.core.separation.Separation;
import org.jspecify.annotations.Nullable;

/** One follow with a drone that is as a test says, at the time that the test says. */
abstract class FollowTestBase {
    static final Instant ZERO = Instant.parse("2026-05-01T12:00:00Z");
    static final Geodetic HOME = new Geodetic(47.3977, 8.5456);
    static final FollowOrder.RelativePlace BEHIND = new FollowOrder.RelativePlace(new StandOffSide.Behind(), 8, 15);
    private static final FollowInput.ModeMeaning MODES = new FollowInput.ModeMeaning("GUIDED", false);
    static final Observation GROUND =
            led(new Observation(null, 0, false, false, true, false, "GUIDED", 90, 0.0, null, null));
    static final Observation ARMED =
            led(new Observation(null, 0, true, false, true, false, "GUIDED", 90, 0.0, null, null));
    static final Observation AIR =
            led(new Observation(null, 0, true, true, true, false, "GUIDED", 90, 300.0, null, null));
    static final Observation HOMING =
            led(new Observation(null, 0, true, true, false, true, "RTL", 90, 300.0, null, null));

    final FollowOperation follow = new FollowOperation(Separation.USUAL);
    final List<Command> given = new ArrayList<>();
    FollowState state = FollowState.begin(
            new OperationId("follow-1"),
            new FollowOrder(
                    new ChosenDrone(new DroneId("d1"), "Falcon", HOME, 488, "Falcon was chosen."),
                    HOME,
                    BEHIND,
                    12,
                    60),
            ZERO);
    double now;

    @Nullable
    Instant sighted;

    @Nullable
    ReporterState reach;

    /** Of a copter in its mode. */
    static Observation led(Observation look) {
        return look.with(new FollowInput.ModeMeaning("GUIDED", "RTL".equals(look.mode())));
    }

    static Observation air(FollowInput.ControlRestriction grip) {
        return new Observation(null, 0, true, true, true, false, "GUIDED", 90, 300.0, grip, MODES);
    }

    Instant at() {
        return ZERO.plusMillis(Math.round(now * 1_000));
    }

    void take(FollowInput input) {
        OperationDecision<FollowState, FollowInput> decision = follow.decide(state, input);
        state = decision.next();
        for (OperationAction<FollowInput> action : decision.actions()) {
            given.add(((OperationAction.SendCommand<FollowInput>) action).command());
        }
    }

    void seen(Observation look) {
        seen(look, null);
    }

    void seen(Observation look, @Nullable String unsteered) {
        now += 0.1;
        take(new FollowInput.Observed(at(), look, sighted, reach, unsteered));
    }

    /** For so long, with a position each time. */
    void heard(Observation look, double seconds) {
        for (double passed = 0; passed < seconds; passed += 0.1) {
            sighted = at();
            seen(look);
        }
    }

    void silent(Observation look, double seconds) {
        for (double passed = 0; passed < seconds; passed += 0.1) {
            seen(look);
        }
    }

    void ends(Outcome outcome) {
        FollowState.IssuedCommand errand = state.issuedCommand();
        assertThat(errand).isNotNull();
        take(new FollowInput.CommandEnded(at(), state.drone(), errand.command(), outcome));
        now += 1;
    }

    void succeeds() {
        ends(new Outcome.Succeeded());
    }

    void start() {
        take(new FollowInput.Start(at(), "mia"));
        Observation pilots = led(new Observation(null, 0, false, false, false, false, "LOITER", 90, 0.0, null, null));
        seen(pilots);
        succeeds();
        seen(pilots);
        succeeds();
        seen(GROUND);
        succeeds();
        seen(ARMED);
        succeeds();
        seen(AIR);
    }
}
