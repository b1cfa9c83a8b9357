package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.LabVehicleLink;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.LinkFrameLog;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.VehicleSpec;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Each kind of link carries a flight, also when it breaks or its address changes in the air. */
class LinkFlightTest {
    private static final double METERS = 8;
    private static final String DEVICE = "/dev/ttyUSB0";

    private final Laboratory lab = new Laboratory(1);
    private final Pilot ann = lab.pilot("ann", Role.OPERATOR);
    private final LabDrone copter = lab.add(VehicleSpec.COPTER);

    @AfterEach
    void close() {
        lab.close();
    }

    static Stream<LabVehicleLink.Kind> kinds() {
        return Stream.of(
                LabVehicleLink.Kind.serial(DEVICE),
                LabVehicleLink.Kind.UDP,
                LabVehicleLink.Kind.TCP,
                LabVehicleLink.Kind.WEBSOCKET,
                LabVehicleLink.Kind.dtls("copter"));
    }

    private void takesOff() {
        ann.takesOff(copter, METERS);
        lab.until("it hovers", Duration.ofSeconds(30), () -> copter.height() > METERS - 1);
    }

    private void goesAndLands() {
        ann.fliesTo(copter, copter.place(22, 0), METERS);
        lab.until("it is there", Duration.ofMinutes(1), () -> copter.distanceTo(copter.place(22, 0)) < 2);
        ann.does(copter, CommandRequests.land());
        lab.until("it is down", Duration.ofMinutes(1), copter::isDown);
        lab.until(
                "the server knows",
                Duration.ofSeconds(5),
                () -> Boolean.FALSE.equals(copter.state().armed()));
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void everyKindOfLinkCarriesAFlight(LabVehicleLink.Kind kind) {
        copter.wire().is(kind);
        LinkFrameLog log = copter.wire().log();
        lab.ready(copter);

        takesOff();
        goesAndLands();

        assertThat(copter.state().link().transport()).isEqualTo(kind.transport());
        assertThat(copter.state().link().key().address()).isEqualTo(kind.host());
        assertThat(copter.state().link().key().port()).isEqualTo(copter.wire().port());
        assertThat(copter.wire().port() == 0).isEqualTo(kind.host().equals(DEVICE));
        assertThat(copter.wire().counts().framesIn()).isGreaterThan(100);
        assertThat(log.frames(false)).hasSizeGreaterThan(10);
        assertThat(copter.wire().counts().lost()).isZero();
        // The vehicle greets as an autopilot does, with a line of text before the first frame.
        assertThat(copter.wire().counts().brokenBytes()).isLessThan(100);
    }

    @Test
    void aConnectionThatBreaksInFlightIsThereAgainForWhatWasCommandedMeanwhile() {
        copter.wire().is(LabVehicleLink.Kind.TCP);
        lab.ready(copter);
        takesOff();

        copter.wire().cut();
        copter.wire().reconnect();
        var unused = lab.time().worker("the other side", 1).after(Duration.ofSeconds(2), copter.wire()::mend);
        // Given while there is no connection: it is sent again when there is one.
        ann.does(copter, CommandRequests.hold());
        ann.does(copter, CommandRequests.setMode("GUIDED"));

        goesAndLands();
        assertThat(copter.state().link().transport()).isEqualTo("tcp");
        assertThat(lab.server().house().cloud().drones()).hasSize(1);
    }

    @Test
    void aDtlsVehicleIsKeptWhenItsAddressChangesInFlight() {
        copter.wire().is(LabVehicleLink.Kind.dtls("roaming copter"));
        lab.ready(copter);
        takesOff();
        int before = copter.wire().port();

        for (int i = 0; i < 3; i++) {
            copter.wire().move();
            ann.does(copter, CommandRequests.hold());
            ann.does(copter, CommandRequests.setMode("GUIDED"));
        }
        goesAndLands();

        assertThat(copter.wire().port()).isNotEqualTo(before);
        assertThat(lab.server().house().cloud().drones()).hasSize(1);
    }
}
