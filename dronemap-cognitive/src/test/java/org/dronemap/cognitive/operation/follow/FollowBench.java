package org.dronemap.cognitive.operation.follow;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.cognitive.follow.Apart;
import org.dronemap.cognitive.follow.Side;
import org.dronemap.cognitive.operation.follow.FollowInput.Look;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.operation.Action;
import org.dronemap.core.operation.Decision;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.Reach;
import org.jspecify.annotations.Nullable;

/** One follow with a drone that is as a test says, at the time that the test says. */
abstract class FollowBench {
    static final Instant ZERO = Instant.parse("2026-05-01T12:00:00Z");
    static final Geodetic HOME = new Geodetic(47.3977, 8.5456);
    static final FollowOrder.Place BEHIND = new FollowOrder.Place(new Side.Behind(), 8, 15);
    private static final FollowInput.Modes MODES = new FollowInput.Modes("GUIDED", false);
    static final Look GROUND = led(new Look(null, 0, false, false, true, false, "GUIDED", 90, 0.0, null, null));
    static final Look ARMED = led(new Look(null, 0, true, false, true, false, "GUIDED", 90, 0.0, null, null));
    static final Look AIR = led(new Look(null, 0, true, true, true, false, "GUIDED", 90, 300.0, null, null));
    static final Look HOMING = led(new Look(null, 0, true, true, false, true, "RTL", 90, 300.0, null, null));

    final Follow follow = new Follow(Apart.USUAL);
    final List<Command> given = new ArrayList<>();
    FollowState state = FollowState.begin(
            new OperationId("follow-1"),
            new FollowOrder(
                    new FollowOrder.Chosen(new DroneId("d1"), "Falcon", HOME, 488, "Falcon was chosen."),
                    HOME,
                    BEHIND,
                    12,
                    60),
            ZERO);
    double now;

    @Nullable
    Instant sighted;

    @Nullable
    Reach reach;

    /** Of a copter in its mode. */
    static Look led(Look look) {
        return look.with(new FollowInput.Modes("GUIDED", "RTL".equals(look.mode())));
    }

    static Look air(FollowInput.Grip grip) {
        return new Look(null, 0, true, true, true, false, "GUIDED", 90, 300.0, grip, MODES);
    }

    Instant at() {
        return ZERO.plusMillis(Math.round(now * 1_000));
    }

    void take(FollowInput input) {
        Decision<FollowState, FollowInput> decision = follow.decide(state, input);
        state = decision.next();
        for (Action<FollowInput> action : decision.actions()) {
            given.add(((Action.Give<FollowInput>) action).command());
        }
    }

    void seen(Look look) {
        seen(look, null);
    }

    void seen(Look look, @Nullable String unsteered) {
        now += 0.1;
        take(new FollowInput.Looked(at(), look, sighted, reach, unsteered));
    }

    /** For so long, with a position each time. */
    void heard(Look look, double seconds) {
        for (double passed = 0; passed < seconds; passed += 0.1) {
            sighted = at();
            seen(look);
        }
    }

    void silent(Look look, double seconds) {
        for (double passed = 0; passed < seconds; passed += 0.1) {
            seen(look);
        }
    }

    void ends(Outcome outcome) {
        FollowState.Errand errand = state.errand();
        assertThat(errand).isNotNull();
        take(new FollowInput.CommandEnded(at(), state.drone(), errand.command(), outcome));
        now += 1;
    }

    void succeeds() {
        ends(new Outcome.Succeeded());
    }

    void start() {
        take(new FollowInput.Start(at(), "mia"));
        Look pilots = led(new Look(null, 0, false, false, false, false, "LOITER", 90, 0.0, null, null));
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
