package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.Home;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.sim.physics.LocalFrame;
import org.dronemap.ws.command.CommandRequest;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.LabVehicleLink;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.LinkTap;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.VehicleSpec;
import org.dronemap.ws.problem.InvalidInput;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Home, turns, pictures and relays; judged by what the vehicle itself did. */
class HomeAndPayloadTest {
    private static final String AUTOPILOTS = "org.dronemap.ws.lab.VehicleSpec#autopilots";
    private static final int DO_SET_HOME = 179;

    private final Laboratory lab = new Laboratory(1);
    private final Pilot ann = lab.pilot("ann", Role.OPERATOR);

    @AfterEach
    void close() {
        lab.close();
    }

    private LabDrone drone(VehicleSpec kit) {
        return lab.ready(lab.add(kit));
    }

    /** Where the vehicle itself has its home: degrees times 1e7, and millimetres above sea level. */
    private static List<Long> homeOf(LabDrone drone) {
        LocalFrame home = drone.craft().home();
        return List.of(
                Math.round(home.latitude() * 1e7),
                Math.round(home.longitude() * 1e7),
                Math.round(home.altitudeAmsl() * 1e3));
    }

    private static CommandRequest homeHere() {
        return CommandRequests.setHome();
    }

    private static String payload(LabDrone drone) {
        return drone.vehicle().autopilot().payload().words();
    }

    @ParameterizedTest
    @MethodSource(AUTOPILOTS)
    void homeGoesWhereItIsPutAndIsShownThere(VehicleSpec kit) {
        LabDrone drone = drone(kit);
        drone.wire().is(new LabVehicleLink.Quality(0.1, Duration.ofMillis(100), Duration.ofMillis(200)));
        ann.does(drone, CommandRequests.setHome(47.4012, 8.5501, 501.0));
        assertThat(homeOf(drone)).containsExactly(474_012_000L, 85_501_000L, 501_000L);
        lab.until(
                "it is shown",
                Duration.ofSeconds(30),
                () -> new Home(new Geodetic(47.4012, 8.5501), 501)
                        .equals(drone.state().home()));

        ann.does(drone, CommandRequests.setHome(47.4013, 8.5502, 502.0));
        assertThat(homeOf(drone)).containsExactly(474_013_000L, 85_502_000L, 502_000L);

        ann.does(drone, homeHere());
        Geodetic here = Objects.requireNonNull(
                Objects.requireNonNull(drone.state().position()).point());
        LocalFrame home = drone.craft().home();
        assertThat(home.latitude()).isCloseTo(here.latitudeDegrees(), within(1e-5));
        assertThat(home.longitude()).isCloseTo(here.longitudeDegrees(), within(1e-5));
        ann.does(drone, CommandRequests.readHome());
    }

    @ParameterizedTest
    @MethodSource(AUTOPILOTS)
    void halfAHomeIsRefusedBeforeAnythingIsSent(VehicleSpec kit) {
        LabDrone drone = drone(kit);
        List<Long> before = homeOf(drone);
        LinkTap tap = drone.wire().tap();

        InvalidInput half = catchThrowableOfType(
                InvalidInput.class, () -> ann.give(drone, CommandRequests.setHome(47.4, null, null)));

        assertThat(half.field()).isEqualTo("longitude");
        lab.goOn(Duration.ofSeconds(3));
        assertThat(tap.told(CommandInt.ID, CommandInt::decode)).noneMatch(order -> order.command() == DO_SET_HOME);
        assertThat(tap.told(CommandLong.ID, CommandLong::decode)).noneMatch(order -> order.command() == DO_SET_HOME);
        assertThat(homeOf(drone)).isEqualTo(before);
    }

    @ParameterizedTest
    @MethodSource(AUTOPILOTS)
    void everyPictureIsOneOnTheVehicle(VehicleSpec kit) {
        LabDrone drone = drone(kit);

        ann.does(drone, CommandRequests.takePicture()).does(drone, CommandRequests.takePicture());

        assertThat(payload(drone)).contains("pictures 2 ");
    }

    @Test
    void everySwitchedRelayIsOneOnTheVehicle() {
        LabDrone drone = lab.copter();
        ann.does(drone, CommandRequests.takePicture()).does(drone, CommandRequests.takePicture());

        ann.does(drone, CommandRequests.setRelay(1, "on")).does(drone, CommandRequests.setRelay(4, "toggle"));
        assertThat(payload(drone)).isEqualTo("pictures 2 relays on: 1 4");

        ann.does(drone, CommandRequests.setRelay(1, "off"));
        assertThat(payload(drone)).isEqualTo("pictures 2 relays on: 4");

        CommandView.OutcomeView missing = Objects.requireNonNull(
                ann.outcome(drone, CommandRequests.setRelay(9, "on")).outcome());
        assertThat(missing.result()).isEqualTo("refused");
        assertThat(missing.by()).isEqualTo("vehicle");
        assertThat(payload(drone)).isEqualTo("pictures 2 relays on: 4");
    }

    @Test
    void aVehicleWithoutRelaysIsNotAskedToSwitchOne() {
        LabDrone px4 = drone(VehicleSpec.PX4);

        assertThat(ann.refusal(px4, CommandRequests.setRelay(1, "on"))).contains("cannot switch a relay");
    }

    @Test
    void aTurnIsFlownAtARateAndTheWayRoundThatWasAskedFor() {
        LabDrone copter = lab.copter();
        ann.takesOff(copter, 10);
        lab.until("it is up", Duration.ofSeconds(60), () -> copter.height() > 9);
        double before = heading(copter);

        CommandView turn = ann.give(copter, CommandRequests.turn(-270.0));

        List<Double> passed = new ArrayList<>();
        lab.until("it has turned three quarters to the left", Duration.ofSeconds(40), () -> {
            double turned = ((before - heading(copter)) % 360 + 360) % 360;
            passed.add(turned);
            return turned >= 268 && turned <= 272;
        });
        ann.succeeds(turn);
        assertThat(passed).anyMatch(turned -> turned > 60 && turned < 200);
        assertThat(passed).filteredOn(turned -> turned > 280 && turned < 350).isEmpty();
    }

    private static double heading(LabDrone copter) {
        return Objects.requireNonNull(
                Objects.requireNonNull(copter.state().motion()).headingDegrees());
    }
}
