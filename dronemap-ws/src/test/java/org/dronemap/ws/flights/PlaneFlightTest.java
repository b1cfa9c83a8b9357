package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.dronemap.core.access.Role;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.WingedSpecs;
import org.junit.jupiter.api.Test;

/** What a person does with an ArduPlane, which cannot stop in the air. */
class PlaneFlightTest {
    private static final Duration CLIMB = Duration.ofMinutes(1);

    private static LabDrone flying(Laboratory lab, Pilot ann) {
        LabDrone plane = lab.ready(lab.add(WingedSpecs.PLANE));
        assertThat(plane.state().identification().vehicle()).startsWith("ArduPlane");
        ann.does(plane, CommandRequests.setMode("TAKEOFF")).does(plane, CommandRequests.arm());
        lab.until("it is up", CLIMB, () -> plane.height() > 45);
        return plane;
    }

    @Test
    void itTakesOffByItsModeAndCirclesAtHomeWhenItReturns() {
        try (Laboratory lab = new Laboratory(1)) {
            Pilot ann = lab.pilot("ann", Role.OPERATOR);
            LabDrone plane = flying(lab, ann);

            ann.does(plane, CommandRequests.returnToLaunch());
            lab.until("it is home", Duration.ofMinutes(2), () -> plane.away() < 130 && plane.height() > 95);
            lab.throughout("it circles there", Duration.ofMinutes(1), () -> plane.away() < 140 && plane.height() > 90);
        }
    }
}
