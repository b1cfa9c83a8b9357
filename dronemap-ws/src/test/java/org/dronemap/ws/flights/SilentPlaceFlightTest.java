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
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.plan.PlanRequest;
import org.dronemap.ws.run.RunView;
import org.junit.jupiter.api.Test;

/** A drone of a mission run falls silent and hovers on: nobody is sent to where it may still be. */
class SilentPlaceFlightTest {
    private static final long LOITER = 5;
    private static final double HOLD_SECONDS = 15;
    private static final double THERE_METERS = 1;

    @Test
    void itsPlaceIsFilledOnlyWhenItIsKnownToBeFree() {
        try (Laboratory lab = new Laboratory(1)) {
            Pilot chief = lab.pilot("chief", Role.SUPERVISOR);
            List<LabDrone> drones = lab.copters(3);
            LabDrone silent = drones.get(0);
            List<PlanRequest.WaypointRequest> waypoints = IntStream.range(0, 12)
                    .mapToObj(n -> MissionRunFlight.waypoint(
                            silent.place((1 + n % 4) * 30, (n / 4 - 1) * 30),
                            silent.groundAmsl() + 20,
                            HOLD_SECONDS,
                            null))
                    .toList();
            MissionRunFlight run = MissionRunFlight.begins(
                            lab, chief, drones, waypoints, new MissionRunFlight.Manner("automatic", "rtl", null))
                    .awaitsAll("flying");
            Separation apart = new Separation(drones);
            String held = lab.untilSeen("it hovers at a waypoint", Duration.ofMinutes(3), () -> {
                apart.look();
                return run.next(silent).stream()
                        .limit(1)
                        .filter(id -> isAt(silent, run.waypoint(id)))
                        .findFirst();
            });

            silent.wire().cut();
            silent.switchedTo(LOITER);
            lab.throughout("they are apart", Duration.ofSeconds(50), () -> {
                apart.look();
                return silent.height() > 15;
            });
            RunView.WaypointView waits = run.waypoint(held);
            assertThat(waits.state()).as(run.view().explanations().toString()).isEqualTo("waiting");
            assertThat(waits.why())
                    .contains(silent.state().name() + ", which was last heard there and may still be there until ");
            lab.throughout("they are apart", Duration.ofSeconds(10), () -> {
                apart.look();
                return silent.height() > 15;
            });
            silent.wire().mend();
            lab.untilSeen(
                    "it takes part again",
                    Duration.ofSeconds(20),
                    () -> run.stage(silent).equals("flying"));
            RunView over = lab.untilSeen("the run is over", Duration.ofMinutes(20), () -> {
                apart.look();
                return Optional.of(run.view()).filter(view -> view.state().equals("over"));
            });

            assertThat(over.counts().visited()).isEqualTo(12);
            assertThat(apart.least()).as(apart.words()).isGreaterThanOrEqualTo(1);
            assertThat(over.counts().replans())
                    .as(over.explanations().toString())
                    .isLessThan(12);
            assertThat(run.decidesTheSameAgain()).isTrue();
        }
    }

    private static boolean isAt(LabDrone drone, RunView.WaypointView waypoint) {
        return drone.distanceTo(MissionRunFlight.place(waypoint)) < THERE_METERS
                && Math.abs(drone.amsl() - waypoint.altitudeAmsl()) < THERE_METERS;
    }
}
