package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.dronemap.core.access.Role;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.MissionRunFlight;
import org.dronemap.ws.plan.PlanRequest;
import org.dronemap.ws.run.RunView;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** A drone of a mission run falls silent and hovers on: nobody is sent to where it may still be. */
class SilentPlaceFlightTest {
    private static final long LOITER = 5;
    private static final double HOLD_SECONDS = 15;
    private static final double THERE_METERS = 1;
    private static final int WAYPOINTS = 12;

    private final Laboratory lab = new Laboratory(1);
    private final List<LabDrone> drones = lab.copters(3);
    private final LabDrone silent = drones.get(0);
    private final Separation apart = new Separation(drones);

    @AfterEach
    void end() {
        lab.close();
    }

    @Test
    void itsPlaceIsFilledOnlyWhenItIsKnownToBeFree() {
        MissionRunFlight run = MissionRunFlight.begins(
                        lab,
                        lab.pilot("chief", Role.SUPERVISOR),
                        drones,
                        waypoints(),
                        new MissionRunFlight.Manner("automatic", "rtl", null))
                .awaitsAll("flying");
        String held = lab.untilSeen("it hovers at a waypoint", Duration.ofMinutes(3), () -> {
            apart.look();
            return run.next(silent).stream()
                    .limit(1)
                    .filter(id -> isAt(run.waypoint(id)))
                    .findFirst();
        });

        silent.wire().cut();
        silent.switchedTo(LOITER);
        staysUp(Duration.ofSeconds(50));
        RunView.WaypointView waits = run.waypoint(held);
        assertThat(waits.state()).as(run.view().explanations().toString()).isEqualTo("waiting");
        assertThat(waits.why())
                .contains(silent.state().name() + ", which was last heard there and may still be there until ");
        staysUp(Duration.ofSeconds(10));
        silent.wire().mend();
        lab.untilSeen(
                "it takes part again",
                Duration.ofSeconds(20),
                () -> run.stage(silent).equals("flying"));
        isFlownToItsEnd(run);
    }

    private List<PlanRequest.WaypointRequest> waypoints() {
        return IntStream.range(0, WAYPOINTS)
                .mapToObj(n -> MissionRunFlight.waypoint(
                        silent.place((1 + n % 4) * 30, (n / 4 - 1) * 30), silent.groundAmsl() + 20, HOLD_SECONDS, null))
                .toList();
    }

    private void staysUp(Duration howLong) {
        lab.throughout("they are apart", howLong, () -> {
            apart.look();
            return silent.height() > 15;
        });
    }

    private void isFlownToItsEnd(MissionRunFlight run) {
        RunView over = lab.untilSeen("the run is over", Duration.ofMinutes(20), () -> {
            apart.look();
            return Optional.of(run.view()).filter(view -> view.state().equals("over"));
        });
        assertThat(over.counts().visited()).isEqualTo(WAYPOINTS);
        assertThat(apart.least()).as(apart.words()).isGreaterThanOrEqualTo(1);
        assertThat(over.counts().replans()).as(over.explanations().toString()).isLessThan(WAYPOINTS);
        assertThat(run.decidesTheSameAgain()).isTrue();
    }

    private boolean isAt(RunView.WaypointView waypoint) {
        return silent.distanceTo(MissionRunFlight.place(waypoint)) < THERE_METERS
                && Math.abs(silent.amsl() - waypoint.altitudeAmsl()) < THERE_METERS;
    }
}
