package org.dronemap.ws.lab;

import java.time.Duration;
import org.dronemap.core.access.Role;
import org.dronemap.ws.service.CommandRequest;
import org.junit.jupiter.api.Test;

class TmpPerfTest {
    @Test
    void perf() {
        for (int i = 0; i < 12; i++) {
            long began = System.nanoTime();
            try (Laboratory lab = new Laboratory(1)) {
                LabDrone copter = lab.copter();
                long made = System.nanoTime();
                Pilot ann = lab.pilot("ann", Role.OPERATOR);
                ann.plans(copter, 20, copter.place(60, 0), copter.place(60, 40))
                        .does(copter, CommandRequest.setMode("GUIDED"))
                        .does(copter, CommandRequest.simple("arm"))
                        .does(copter, CommandRequest.startMission(null));
                System.out.println("PERF started " + copter.words() + copter.vehicle().autopilot().plan().items().size());
                lab.until("it is up", Duration.ofMinutes(2), () -> copter.height() > 10);
                lab.until("it is down again", Duration.ofMinutes(2), copter::isDown);
                long flown = System.nanoTime();
                System.out.println("PERF " + (made - began) / 1_000_000 + " " + (flown - made) / 1_000_000 + " ms for "
                        + lab.time().nanos() / 1e9 + " s, frames " + lab.frames() + " " + lab.sum());
            }
        }
    }
}
