package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.dronemap.core.access.Role;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.ScriptedPeer;
import org.dronemap.ws.lab.ZoneFixtures;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Each way by which a drone that nobody has comes down, as it truly flies it. */
class ReturnFlightTest {
    private static final long RTL = 6;
    private static final long LAND = 9;
    private static final int PLANE_GUIDED = 15;
    private static final int PLANE_LOITER = 12;
    private static final int PLANE_RTL = 11;
    private static final int DO_SET_MODE = 176;
    private static final int DO_LAND_START = 189;
    private static final double HEIGHT = 20;
    private static final Duration LEFT = Duration.ofSeconds(80);
    private static final Duration DOWN = Duration.ofMinutes(3);
    private static final Geodetic FIELD = new Geodetic(47.3977, 8.5456);

    private final Laboratory lab = new Laboratory(1);
    private final Pilot ann = lab.pilot("ann", Role.OPERATOR);
    private final Pilot chief = lab.pilot("chief", Role.SUPERVISOR);

    @AfterEach
    void close() {
        lab.close();
    }

    private LabDrone flown(double north) {
        LabDrone drone = lab.copter();
        ann.takesOff(drone, HEIGHT);
        lab.until("it is up", Duration.ofSeconds(40), () -> drone.height() > HEIGHT - 1);
        ann.fliesTo(drone, drone.place(north, 0), HEIGHT);
        Geodetic there = drone.place(north, 0);
        lab.until("it is there", Duration.ofMinutes(2), () -> drone.distanceTo(there) < 2);
        return drone;
    }

    private static boolean isDownAt(LabDrone drone, double north) {
        return drone.isDown() && drone.distanceTo(drone.place(north, 0)) < 4;
    }

    @Test
    void returnsWhereNothingSpeaksAgainstIt() {
        LabDrone drone = flown(60);

        lab.until("it returns", LEFT, () -> drone.mode() == RTL);
        lab.until("it is down at home", DOWN, () -> isDownAt(drone, 0));
    }

    @Test
    void landsWhereItIsWhenAZoneIsInItsWay() {
        LabDrone drone = flown(80);
        var unused = lab.server()
                .zones()
                .add(chief.principal(), ZoneFixtures.circle("Crowd", drone.place(40, 0), 15, drone, "hold"));

        lab.until("it lands", LEFT, () -> drone.mode() == LAND);
        lab.until("it is down there", DOWN, () -> isDownAt(drone, 80));
        assertThat(drone.isTold("It does not return:")).isTrue();
        assertThat(drone.isTold("It lands where it is.")).isTrue();
    }

    @Test
    void fliesToTheNearestProvedPlaceWithTooLittleEnergyForTheWayHome() {
        LabDrone drone = flown(60);
        Geodetic far = drone.place(2_000, 0);
        ann.does(drone, CommandRequests.setHome(far.latitudeDegrees(), far.longitudeDegrees(), drone.groundAmsl()));
        drone.craft().battery().setRemainingPercent(15);

        lab.until("it is down where it stood before", LEFT.plus(DOWN), () -> isDownAt(drone, 0));
        assertThat(drone.isTold("It flies to a place where it has stood before and lands there."))
                .isTrue();
    }

    @Test
    void landsWithTooLittleEnergyForAnyPlace() {
        LabDrone drone = flown(300);
        drone.craft().battery().setRemainingPercent(7);

        lab.until("it lands without waiting", Duration.ofSeconds(40), () -> drone.mode() == LAND);
        lab.until("it is down there", DOWN, () -> isDownAt(drone, 300));
    }

    @Test
    void isDownWithoutAPosition() {
        LabDrone drone = flown(60);
        drone.craft().navigation().setReceiving(false);

        lab.until("it is down", LEFT.plus(DOWN), drone::isDown);
    }

    /** Says where it is, and carries out changes of mode, but not that one. */
    private ScriptedPeer peer(int type, int refused) {
        ScriptedPeer peer =
                lab.peer(77, ScriptedPeer.Kind.vehicle(type, 3), (self, frame) -> obey(self, frame, refused));
        peer.isIn(type == 1 ? PLANE_GUIDED : 4);
        peer.isInTheAir();
        double[] flown = {0};
        var unused = lab.time()
                .worker("where the peer is", 1)
                .every(Duration.ofMillis(500), Duration.ofMillis(500), () -> {
                    flown[0] += 1e-5;
                    peer.says(new GlobalPositionInt(
                            0,
                            (int) ((FIELD.latitudeDegrees() + 0.005 + flown[0]) * 1e7),
                            (int) (FIELD.longitudeDegrees() * 1e7),
                            540_000,
                            52_000,
                            0,
                            0,
                            0,
                            0));
                });
        lab.until(
                "it is known where it is",
                Duration.ofSeconds(30),
                () -> peer.known()
                        .filter(state -> state.capabilities().known() && state.position() != null && state.airborne())
                        .isPresent());
        return peer;
    }

    private static void obey(ScriptedPeer peer, Frame frame, int refused) {
        if (frame.messageId() != CommandLong.ID) {
            return;
        }
        CommandLong order = CommandLong.decode(frame);
        boolean sets = order.command() == DO_SET_MODE;
        if (order.command() == DO_LAND_START || (sets && (int) order.param2() == refused)) {
            peer.acknowledges(order.command(), ScriptedPeer.FAILED);
        } else if (sets) {
            peer.acknowledges(order.command(), ScriptedPeer.ACCEPTED);
            peer.isIn((long) order.param2());
        } else {
            peer.acknowledges(order.command(), ScriptedPeer.UNSUPPORTED);
        }
    }

    @Test
    void landsWhenItRefusesToReturn() {
        ScriptedPeer copter = peer(2, (int) RTL);
        ann.does(copter, CommandRequests.setMode("BRAKE"));

        lab.until("it lands", LEFT.plusSeconds(30), () -> copter.customMode() == LAND);
    }

    @Test
    void aPlaneWithoutALandingSequenceReturnsAndSaysThatItCircles() {
        ScriptedPeer plane = peer(1, -1);
        ann.does(plane, CommandRequests.setMode("LOITER"));
        assertThat(plane.customMode()).isEqualTo(PLANE_LOITER);

        lab.until("it returns", LEFT.plusSeconds(30), () -> plane.customMode() == PLANE_RTL);
        assertThat(plane.orders(DO_LAND_START))
                .as("its landing sequence comes first")
                .isNotEmpty();
        assertThat(plane.known().orElseThrow().messages())
                .anyMatch(message -> message.text().contains("circles there"));
    }
}
