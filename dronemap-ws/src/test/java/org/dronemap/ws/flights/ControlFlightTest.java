package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.Set;
import org.dronemap.core.access.Role;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.control.ControlRequest;
import org.dronemap.ws.drone.ControlView;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RejectionKind;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** One user commands a drone at a time, and what becomes of it when that one is lost. */
class ControlFlightTest {
    private static final long GUIDED = 4;
    private static final long LOITER = 5;
    private static final long RTL = 6;
    private static final long BRAKE = 17;
    private static final Set<Long> HOLDING = Set.of(LOITER, BRAKE);

    private final Laboratory lab = new Laboratory(1);
    private final LabDrone copter = lab.copter();
    private final Pilot ann = lab.pilot("ann", Role.OPERATOR);
    private final Pilot chief = lab.pilot("chief", Role.SUPERVISOR);

    @BeforeEach
    void hover() {
        ann.takesOff(copter, 20);
        lab.until("it hovers", Duration.ofSeconds(30), () -> copter.height() > 19.5);
        assertThat(copter.mode()).isEqualTo(GUIDED);
    }

    @AfterEach
    void close() {
        lab.close();
    }

    @Test
    void theDroneOfAHolderWhoFallsSilentHoldsAndThenReturns() {
        Pilot bob = lab.pilot("bob", Role.OPERATOR);
        long epoch = ann.takesControl(copter).epoch();
        for (int beat = 0; beat < 20; beat++) {
            lab.goOn(Duration.ofSeconds(2));
            ann.controls(copter, new ControlRequest.Heartbeat(epoch));
        }
        ControlView kept = ann.control(copter);
        assertThat(kept.explicit()).isTrue();
        assertThat(copter.mode()).isEqualTo(GUIDED);
        Rejection refused = bob.rejection(copter, CommandRequests.setMode("LOITER"));
        assertThat(refused.kind()).isEqualTo(RejectionKind.CONFLICT);
        assertThat(refused.holder()).isEqualTo(kept.holder()).isEqualTo("ann");

        // Whether its program was killed or its network was cut: nothing of it comes any more.
        lab.throughout("it waits for the holder", Duration.ofMillis(5_900), () -> copter.mode() == GUIDED);
        lab.until("it holds", Duration.ofSeconds(2), () -> HOLDING.contains(copter.mode()));
        assertThat(ann.control(copter).state()).isEqualTo("free");
        lab.throughout("it holds", Duration.ofSeconds(27), () -> HOLDING.contains(copter.mode()));
        lab.until("it returns", Duration.ofSeconds(5), () -> copter.mode() == RTL);

        assertThat(ann.control(copter).state()).isEqualTo("free");
        assertThat(ann.commandsOf(copter).subList(0, 2))
                .extracting(CommandView::by)
                .containsOnly("dronemap");
        lab.until("it is down", Duration.ofMinutes(2), copter::isDown);
    }

    @Test
    void aSupervisorCallsBackWhatAnotherFliesAtAnyMoment() {
        ann.takesControl(copter);

        chief.does(copter, CommandRequests.hold());
        assertThat(HOLDING).contains(copter.mode());
        chief.does(copter, CommandRequests.returnToLaunch());
        assertThat(copter.mode()).isEqualTo(RTL);

        assertThat(chief.rejection(copter, CommandRequests.setMode("GUIDED")).kind())
                .isEqualTo(RejectionKind.CONFLICT);
        assertThat(ann.controls(copter, new ControlRequest.Release()).state()).isEqualTo("free");
    }

    @Test
    void thePilotAtTheVehicleGoesBeforeEverybody() {
        long taken = ann.takesControl(copter).epoch();
        copter.switchedTo(LOITER);
        lab.until(
                "the pilot has it",
                Duration.ofSeconds(3),
                () -> ann.control(copter).state().equals("pilot"));

        Rejection refused = ann.rejection(copter, CommandRequests.setMode("GUIDED"));
        assertThat(refused.kind()).isEqualTo(RejectionKind.CONFLICT);
        assertThat(refused.sentence()).contains("pilot");
        assertThat(copter.mode()).isEqualTo(LOITER);
        assertThat(ann.takesControl(copter).epoch()).isGreaterThan(taken);
        ann.does(copter, CommandRequests.setMode("GUIDED"));
        assertThat(copter.mode()).isEqualTo(GUIDED);
    }
}
