package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.Objects;
import org.dronemap.core.access.Role;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.operation.ReporterState;
import org.dronemap.ws.follow.FollowRequest.PlaceRequest;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.SimulatedPhone;
import org.dronemap.ws.lab.VehicleTrack;
import org.dronemap.ws.lab.ZoneFixtures;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Where a drone that follows does not go, and that it stands while its phone is away. */
class FollowBoundsTest {
    private static final double RADIUS = 12;
    private static final double LOWEST = 5;

    private final Laboratory lab = new Laboratory(1);
    private final LabDrone copter = lab.copter();

    @AfterEach
    void close() {
        lab.close();
    }

    private SimulatedPhone follows(double distance, double height) {
        SimulatedPhone phone = lab.phone(lab.pilot("ann", Role.OPERATOR), copter, 20, 0);
        phone.asks(copter, new PlaceRequest("behind", null, null, distance, height), 60)
                .starts();
        return phone.awaits("tracking", Duration.ofMinutes(1));
    }

    @Test
    void aDroneThatFollowsKeepsOutOfAZoneAndAboveTheLowestHeight() {
        Geodetic pond = copter.place(20, 60);
        lab.server()
                .zones()
                .add(
                        lab.pilot("chief", Role.SUPERVISOR).principal(),
                        ZoneFixtures.circle("Pond", pond, RADIUS, null, null));
        SimulatedPhone phone = follows(3, LOWEST);
        lab.goOn(Duration.ofSeconds(10));
        long since = lab.time().nanos();

        phone.walks(0, 4);
        lab.until(
                "the phone is in the middle",
                Duration.ofMinutes(1),
                () -> phone.place().longitudeDegrees() >= pond.longitudeDegrees());
        phone.walks(0, 0);
        lab.goOn(Duration.ofSeconds(20));
        phone.walks(0, 4);
        lab.goOn(Duration.ofSeconds(20));

        assertThat(phone.view().state()).isEqualTo("tracking");
        assertThat(copter.track().nearestOverGround(pond, since)).isGreaterThan(RADIUS);
        assertThat(copter.track().since(since))
                .extracting(VehicleTrack.Fix::height)
                .allSatisfy(height -> assertThat(height).isGreaterThan(LOWEST - 0.01));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            ASLEEP | asleep | The phone's page stands still: the screen is off, or something else is in front of it.
            CUT    | cut    | The phone cannot be reached: it has no network.
            GONE   | gone   | The phone's page was closed, or has crashed.
            """)
    void theDroneStandsWhileItsPhoneIsAwayAndGoesOnWhenItIsBack(ReporterState how, String reach, String words) {
        SimulatedPhone phone = follows(6, 10);
        phone.walks(1, 0);
        lab.goOn(Duration.ofSeconds(20));

        phone.isSilent();
        phone.isReached(how);
        lab.untilSeen(
                "that is told",
                Duration.ofSeconds(20),
                () -> Objects.requireNonNullElse(phone.view().note(), "").startsWith(words));
        assertThat(phone.view().now().reach()).isEqualTo(reach);
        lab.goOn(Duration.ofSeconds(4));
        long since = lab.time().nanos();
        lab.goOn(Duration.ofSeconds(25));
        assertThat(copter.track().strayed(since)).isLessThan(2);
        assertThat(phone.view().state()).isEqualTo("tracking");

        phone.speaksAgain();
        phone.isReached(ReporterState.SPEAKS);
        lab.untilSeen("that is told", Duration.ofSeconds(10), () -> phone.wasTold("The phone says again where it is."));
        lab.until("it is near again", Duration.ofMinutes(1), () -> copter.distanceTo(phone.place()) < 12);
        assertThat(phone.view().state()).isEqualTo("tracking");
    }
}
