package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.dronemap.core.access.Role;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.junit.jupiter.api.Test;

class MissionFlightTest {
    @Test
    void aCopterFliesAMissionAndComesHome() {
        try (Laboratory lab = new Laboratory(1)) {
            LabDrone copter = lab.copter();
            Pilot ann = lab.pilot("ann", Role.OPERATOR);
            ann.plans(copter, 20, copter.place(60, 0), copter.place(60, 40))
                    .does(copter, CommandRequests.setMode("GUIDED"))
                    .does(copter, CommandRequests.arm())
                    .does(copter, CommandRequests.startMission(null));

            lab.until(
                    "it is at the far corner",
                    Duration.ofMinutes(1),
                    () -> copter.distanceTo(copter.place(60, 40)) < 2);
            assertThat(copter.height()).isBetween(18.0, 22.0);
            lab.until("it is down again", Duration.ofMinutes(2), copter::isDown);
            assertThat(copter.away()).isLessThan(2);
        }
    }
}
