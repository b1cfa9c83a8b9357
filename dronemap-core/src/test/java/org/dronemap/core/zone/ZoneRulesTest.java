package org.dronemap.core.zone;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.MissionPhase;
import org.dronemap.core.drone.MissionProgress;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.mission.LandingPlace;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;
import org.junit.jupiter.api.Test;

class ZoneRulesTest {
    private static final Command START = new Command.StartMission(MissionCloudLossPolicy.CONTINUE);

    private final ZoneRegistry book = new ZoneRegistry();
    private final ZoneRules rules = new ZoneRules(book);

    @Test
    void forbidsAGoToThroughANoFlyZoneAndSaysWhereItEnters() {
        book.put(List.of(ZoneFixtures.zone(ZoneFixtures.square(false, 0.005, 0))));

        assertThat(why(ZoneFixtures.flying(ZoneFixtures.HOME, 20), goTo(0.01, 0, 20)))
                .isEqualTo(
                        "The way from where the drone is to the place enters the no-fly zone “Airport” after 445 m.");
        assertThat(why(ZoneFixtures.flying(ZoneFixtures.HOME, 20), goTo(0.01, 0.003, 20)))
                .isEqualTo("nothing");
    }

    @Test
    void forbidsToPassANoFlyZoneWithinAHandsBreadth() {
        book.put(List.of(ZoneFixtures.zone(ZoneFixtures.square(false, 0.005, 0))));

        assertThat(why(ZoneFixtures.flying(ZoneFixtures.at(0, 0.0010013), 20), goTo(0.01, 0.0010013, 20)))
                .isEqualTo("The way from where the drone is to the place passes within 0.1 m (0.3 m are needed) of the"
                        + " no-fly zone “Airport”.");
    }

    @Test
    void letsADroneFlyOverANoFlyZoneThatEndsBelow() {
        book.put(List.of(ZoneFixtures.zone(
                ZoneFixtures.square(false, 0.005, 0), new AltitudeBand(null, 60.0, Altitude.Reference.HOME))));

        assertThat(why(ZoneFixtures.flying(ZoneFixtures.HOME, 80), goTo(0.01, 0, 61)))
                .isEqualTo("nothing");
        assertThat(why(ZoneFixtures.flying(ZoneFixtures.HOME, 80), goTo(0.01, 0, 60)))
                .isEqualTo("The way from where the drone is to the place enters the no-fly zone “Airport” (up to 60 m"
                        + " above home) after 445 m.");
    }

    @Test
    void comparesHeightsAboveHomeWithHeightsAboveTheSea() {
        book.put(List.of(ZoneFixtures.zone(
                ZoneFixtures.square(false, 0.005, 0), new AltitudeBand(500.0, 600.0, Altitude.Reference.AMSL))));

        assertThat(why(ZoneFixtures.flying(ZoneFixtures.HOME, 40), goTo(0.01, 0, 40)))
                .isEqualTo("nothing");
        assertThat(why(ZoneFixtures.flying(ZoneFixtures.HOME, 40), goTo(0.01, 0, 60)))
                .contains("(from 500 to 600 m above sea level)");
    }

    @Test
    void namesTheItemsOfAMission() {
        book.put(List.of(ZoneFixtures.zone(ZoneFixtures.square(false, 0.005, 0))));
        Command upload = new Command.UploadMission(new Mission(List.of(
                new MissionItem.TakeOff(20),
                waypoint(0, 0.005),
                waypoint(0.01, 0.005),
                waypoint(0.01, 0),
                waypoint(0, 0),
                new MissionItem.Land())));

        assertThat(why(ZoneFixtures.onGround(ZoneFixtures.HOME), upload))
                .isEqualTo("The way from item 4 to item 5 enters the no-fly zone “Airport” after 445 m.");
    }

    @Test
    void checksTheWayToWhereAMissionLands() {
        book.put(List.of(ZoneFixtures.zone(ZoneFixtures.square(false, 0.005, 0))));
        Geodetic field = ((MissionItem.Waypoint) waypoint(0, 0)).point();
        Command upload = new Command.UploadMission(new Mission(List.of(
                new MissionItem.TakeOff(20),
                waypoint(0, 0.005),
                waypoint(0.01, 0.005),
                waypoint(0.01, 0),
                new MissionItem.Land(LandingPlace.levelWithHome(field)))));

        assertThat(why(ZoneFixtures.onGround(ZoneFixtures.HOME), upload))
                .isEqualTo("The way from item 4 to item 5 enters the no-fly zone “Airport” after 445 m.");
    }

    @Test
    void checksTheWayHomeAtTheEndOfAMission() {
        book.put(List.of(ZoneFixtures.zone(ZoneFixtures.square(false, 0.005, 0))));
        Command upload = new Command.UploadMission(new Mission(List.of(
                new MissionItem.TakeOff(20),
                waypoint(0, 0.005),
                waypoint(0.01, 0.005),
                waypoint(0.01, 0),
                new MissionItem.ReturnToLaunch())));

        assertThat(why(ZoneFixtures.onGround(ZoneFixtures.HOME), upload))
                .isEqualTo("The return of item 5 from item 4 home enters the no-fly zone “Airport” after 445 m.");
    }

    @Test
    void checksTheTakeOffWhereTheDroneStands() {
        book.put(List.of(ZoneFixtures.zone(
                ZoneFixtures.square(false, 0, 0), new AltitudeBand(30.0, null, Altitude.Reference.HOME))));

        assertThat(why(ZoneFixtures.onGround(ZoneFixtures.HOME), new Command.TakeOff(20)))
                .isEqualTo("nothing");
        assertThat(why(ZoneFixtures.onGround(ZoneFixtures.HOME), new Command.TakeOff(30)))
                .isEqualTo("The take-off begins inside the no-fly zone “Airport” (from 30 m above home upwards).");
    }

    @Test
    void keepsADroneInsideItsArea() {
        book.put(List.of(ZoneFixtures.zone(
                ZoneFixtures.square(true, 0, 0), new AltitudeBand(10.0, 50.0, Altitude.Reference.HOME))));
        DroneState drone = ZoneFixtures.flying(ZoneFixtures.HOME, 20);

        assertThat(why(ZoneFixtures.onGround(ZoneFixtures.HOME), new Command.TakeOff(50)))
                .isEqualTo("nothing");
        assertThat(why(drone, goTo(0.0009, 0.0009, 20))).isEqualTo("nothing");
        assertThat(why(drone, goTo(0.002, 0, 20)))
                .isEqualTo("The way from where the drone is to the place leaves the zone “Airport” after 111 m.");
        assertThat(why(drone, goTo(0, 0, 51)))
                .isEqualTo("The way from where the drone is to the place reaches 51 m above home, over the ceiling of"
                        + " the zone “Airport” at 50 m above home.");
        assertThat(why(drone, goTo(0, 0, 9)))
                .isEqualTo("The way from where the drone is to the place goes down to 9 m above home, under the floor"
                        + " of the zone “Airport” at 10 m above home.");
        assertThat(why(ZoneFixtures.flying(ZoneFixtures.at(0.003, 0), 20), goTo(0, 0, 20)))
                .startsWith("The way from where the drone is to the place begins outside the zone “Airport”, 222 m");
    }

    @Test
    void keepsADroneInsideACircle() {
        book.put(List.of(ZoneFixtures.zone(new FenceArea.Circle(true, ZoneFixtures.HOME, 100))));
        DroneState drone = ZoneFixtures.flying(ZoneFixtures.HOME, 20);

        assertThat(why(drone, goTo(0.00089, 0, 20))).isEqualTo("nothing");
        assertThat(why(drone, goTo(0.002, 0, 20)))
                .isEqualTo("The way from where the drone is to the place leaves the zone “Airport” after 100 m.");
    }

    @Test
    void seesACircleInTheWay() {
        book.put(List.of(ZoneFixtures.zone(new FenceArea.Circle(false, ZoneFixtures.at(0.005, 0), 100))));
        DroneState drone = ZoneFixtures.flying(ZoneFixtures.HOME, 20);

        assertThat(why(drone, goTo(0.01, 0, 20))).endsWith("enters the no-fly zone “Airport” after 456 m.");
        assertThat(why(drone, goTo(0.01, 0.003, 20))).isEqualTo("nothing");
    }

    @Test
    void checksAcrossTheDateLine() {
        book.put(List.of(ZoneFixtures.zone(new FenceArea.Polygon(
                false,
                List.of(
                        new Geodetic(-17.001, 179.999),
                        new Geodetic(-17.001, -179.999),
                        new Geodetic(-16.999, -179.999),
                        new Geodetic(-16.999, 179.999))))));
        DroneState west = ZoneFixtures.flying(new Geodetic(-17, 179.99), 20);
        DroneState east = ZoneFixtures.flying(new Geodetic(-17, -179.99), 20);

        Altitude height = Altitude.aboveHome(20);
        assertThat(why(west, new Command.GoTo(new Geodetic(-17, -179.99), height)))
                .contains("after 958 m");
        assertThat(why(east, new Command.GoTo(new Geodetic(-17, 179.99), height)))
                .contains("after 958 m");
        assertThat(why(east, new Command.GoTo(new Geodetic(-17, -179.995), height)))
                .isEqualTo("nothing");
    }

    @Test
    void checksTheMissionOnBoardBeforeItStartsHoweverItIsStarted() {
        book.put(List.of(ZoneFixtures.zone(ZoneFixtures.square(false, 0.005, 0))));
        DroneState drone = carrying(ZoneFixtures.HOME, FlightPhase.ON_GROUND, null, waypoint(0.01, 0));

        assertThat(why(drone, START)).contains("to item 1 enters the no-fly zone");
        assertThat(why(drone, new Command.SetMode("AUTO"))).contains("to item 1 enters the no-fly zone");
        assertThat(why(drone, new Command.SetMode("GUIDED"))).isEqualTo("nothing");
    }

    @Test
    void checksOnlyWhatIsLeftOfAMissionThatGoesOn() {
        book.put(List.of(ZoneFixtures.zone(ZoneFixtures.square(false, 0.005, 0))));
        MissionItem[] items = {waypoint(0, 0), waypoint(0.01, 0), waypoint(0.012, 0)};

        assertThat(why(carrying(ZoneFixtures.at(0.01, 0), FlightPhase.IN_AIR, 2, items), START))
                .isEqualTo("nothing");
        assertThat(why(carrying(ZoneFixtures.HOME, FlightPhase.IN_AIR, 2, items), START))
                .contains("from where the drone is to item 3 enters");
    }

    @Test
    void refusesWhatItCannotCheck() {
        DroneState odd = carrying(
                ZoneFixtures.HOME, FlightPhase.ON_GROUND, null, new MissionItem.Other("loiter turns at 47, 8, 20.0 m"));
        assertThat(why(odd, START)).isEqualTo("nothing");

        book.put(List.of(ZoneFixtures.zone(ZoneFixtures.square(false, 0.005, 0))));

        assertThat(why(odd, START))
                .isEqualTo("What item 1 (loiter turns at 47, 8, 20.0 m) does to the way is not known; so the way"
                        + " cannot be checked against the zones that bind this flight, such as the no-fly zone"
                        + " “Airport”.");
        assertThat(why(ZoneFixtures.onGround(null), new Command.TakeOff(20)))
                .startsWith("Where the drone is, is not known; so the way cannot be checked");
    }

    @Test
    void neverKeepsADroneFromComingDownOrHome() {
        book.put(List.of(ZoneFixtures.zone(ZoneFixtures.square(false, 0, 0))));
        DroneState drone = ZoneFixtures.flying(ZoneFixtures.HOME, 20);

        assertThat(why(drone, new Command.ReturnToLaunch())).isEqualTo("nothing");
        assertThat(why(drone, new Command.Land())).isEqualTo("nothing");
        assertThat(why(drone, new Command.Hold())).isEqualTo("nothing");
        assertThat(rules.homewardDoubt("bob", drone, ZoneFixtures.NOW)).isPresent();
    }

    @Test
    void bindsOnlyWhomItNames() {
        FenceArea shape = ZoneFixtures.square(false, 0.005, 0);
        Command through = goTo(0.01, 0, 20);
        DroneState drone = ZoneFixtures.flying(ZoneFixtures.HOME, 20);

        book.put(List.of(
                ZoneFixtures.zone(shape, AltitudeBand.ALL, new ZoneBinding.OfUser("ann"), ZoneValidity.ALWAYS)));
        assertThat(why(drone, through)).isEqualTo("nothing");
        book.put(List.of(
                ZoneFixtures.zone(shape, AltitudeBand.ALL, new ZoneBinding.OfUser("bob"), ZoneValidity.ALWAYS)));
        assertThat(why(drone, through)).contains("enters");
        book.put(List.of(ZoneFixtures.zone(
                shape, AltitudeBand.ALL, new ZoneBinding.OfDrone(new DroneId("other")), ZoneValidity.ALWAYS)));
        assertThat(why(drone, through)).isEqualTo("nothing");
        book.put(List.of(ZoneFixtures.zone(
                shape, AltitudeBand.ALL, new ZoneBinding.OfDrone(ZoneFixtures.DRONE), ZoneValidity.ALWAYS)));
        assertThat(why(drone, through)).contains("enters");
        book.remove("z1");
        assertThat(why(drone, through)).isEqualTo("nothing");
    }

    @Test
    void countsZonesThatBeginWhileItFlies() {
        FenceArea shape = ZoneFixtures.square(false, 0.005, 0);
        Command through = goTo(0.01, 0, 20);
        DroneState drone = ZoneFixtures.flying(ZoneFixtures.HOME, 20);

        book.put(List.of(inForce(shape, Duration.ofMinutes(59))));
        assertThat(why(drone, through)).contains("enters");
        book.put(List.of(inForce(shape, Duration.ofMinutes(61))));
        assertThat(why(drone, through)).isEqualTo("nothing");
        book.put(List.of(ZoneFixtures.zone(
                shape, AltitudeBand.ALL, ZoneBinding.EVERYBODY, new ZoneValidity(null, ZoneFixtures.NOW))));
        assertThat(why(drone, through)).isEqualTo("nothing");
    }

    private static Zone inForce(FenceArea shape, Duration after) {
        return ZoneFixtures.zone(
                shape, AltitudeBand.ALL, ZoneBinding.EVERYBODY, new ZoneValidity(ZoneFixtures.NOW.plus(after), null));
    }

    private String why(DroneState drone, Command command) {
        return rules.whyNot("bob", drone, command, ZoneFixtures.NOW)
                .map(RouteObjection::sentence)
                .orElse("nothing");
    }

    private static Command goTo(double north, double east, double meters) {
        return new Command.GoTo(ZoneFixtures.at(north, east), Altitude.aboveHome(meters));
    }

    private static MissionItem waypoint(double north, double east) {
        return new MissionItem.Waypoint(ZoneFixtures.at(north, east), Altitude.aboveHome(20), 0);
    }

    private static DroneState carrying(Geodetic point, FlightPhase phase, Integer current, MissionItem... items) {
        MissionProgress mission =
                new MissionProgress(List.of(items), null, current, MissionPhase.PAUSED, List.of(), null);
        return ZoneFixtures.drone(point, phase == FlightPhase.ON_GROUND ? 0 : 20, phase, mission);
    }
}
