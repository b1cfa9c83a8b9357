package org.dronemap.core.zone;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.EmergencyStop;
import org.dronemap.core.command.GoToLocal;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.command.SetRallyPoints;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.mission.RallyPoint;
import org.dronemap.core.parameter.ParameterValue;
import org.junit.jupiter.api.Test;

class FlightBoundsTest {
    private static final AltitudeBand LOW = new AltitudeBand(null, 50.0, Altitude.Reference.HOME);
    private static final FlightBounds NEAR = new FlightBounds(ZoneFixtures.square(true, 0, 0), AltitudeBand.ALL);
    private static final DroneState FLYING = ZoneFixtures.flying(ZoneFixtures.HOME, 20);

    @Test
    void keepGoTosAndMissionsInTheirArea() {
        assertThat(why(NEAR, goTo(0.0005, 20))).isEqualTo("nothing");
        assertThat(why(NEAR, goTo(0.002, 20)))
                .isEqualTo("The way from where the drone is to the place leaves the bounds after 111 m.");
        assertThat(why(NEAR, upload(0.0005))).isEqualTo("nothing");
        assertThat(why(NEAR, upload(0.002))).contains("from item 1 to item 2 leaves the bounds");
    }

    @Test
    void keepFlightsUnderTheirCeilingAndOverTheirFloorWithoutAnArea() {
        FlightBounds low = new FlightBounds(null, LOW);
        FlightBounds high = new FlightBounds(null, new AltitudeBand(15.0, null, Altitude.Reference.HOME));

        assertThat(why(low, goTo(5, 50))).isEqualTo("nothing");
        assertThat(why(low, goTo(0, 51))).contains("over the ceiling of the bounds at 50 m above home");
        assertThat(why(low, new Command.TakeOff(60))).contains("over the ceiling of the bounds");
        assertThat(why(high, goTo(0, 10))).contains("under the floor of the bounds at 15 m above home");
        assertThat(why(high, goTo(0, 15))).isEqualTo("nothing");
    }

    @Test
    void neverKeepADroneFromLandingReturningOrHolding() {
        DroneState outside = ZoneFixtures.flying(ZoneFixtures.at(0.01, 0), 90);
        FlightBounds both = new FlightBounds(ZoneFixtures.square(true, 0, 0), LOW);

        for (Command safe : List.of(
                new Command.Land(),
                new Command.ReturnToLaunch(),
                new Command.Hold(),
                new Command.PauseMission(),
                new Command.SetMode("RTL"))) {
            assertThat(ZoneRules.whyNot(List.of(both), "the bounds", outside, safe))
                    .as(safe.summary())
                    .isEmpty();
        }
    }

    @Test
    void startNoMissionOnBoardThatNobodyKnows() {
        assertThat(why(NEAR, new Command.StartMission(MissionCloudLossPolicy.CONTINUE)))
                .isEqualTo("Which mission is on the vehicle is not known; so the way cannot be checked against the"
                        + " bounds.");
    }

    @Test
    void sendNoDroneToAPlaceOfAMapThatLiesNobodyKnowsWhere() {
        assertThat(why(NEAR, new GoToLocal(1, 2, null)))
                .isEqualTo("Where the vehicle's own map lies on the Earth is not known; so the way cannot be checked"
                        + " against the bounds.");
        assertThat(why(NEAR, new EmergencyStop())).isEqualTo("nothing");
    }

    @Test
    void keepTheHomeAndTheRallyPointsInTheirArea() {
        Altitude high = Altitude.aboveHome(100);

        assertThat(why(NEAR, new Command.SetHome(ZoneFixtures.at(0.01, 0), high)))
                .startsWith("The new home begins outside the bounds");
        assertThat(why(NEAR, new Command.SetHome(ZoneFixtures.HOME, high))).isEqualTo("nothing");
        assertThat(why(NEAR, new Command.SetHome(null, null))).isEqualTo("nothing");
        assertThat(why(
                        NEAR,
                        new SetRallyPoints(List.of(
                                new RallyPoint(ZoneFixtures.HOME, 30), new RallyPoint(ZoneFixtures.at(0.01, 0), 30)))))
                .startsWith("Rally point 2 begins outside the bounds");
    }

    @Test
    void keepTheHomeWhereItIsThatTheirHeightsAreMeasuredFrom() {
        AltitudeBand aboveSea = new AltitudeBand(null, 600.0, Altitude.Reference.AMSL);
        Command here = new Command.SetHome(null, null);
        Command higher = new Command.SetHome(ZoneFixtures.HOME, Altitude.aboveHome(100));

        assertThat(why(new FlightBounds(NEAR.area(), LOW), higher))
                .isEqualTo("The heights of the bounds are measured from home; so home cannot be moved.");
        assertThat(why(new FlightBounds(null, LOW), here)).contains("home cannot be moved");
        assertThat(why(new FlightBounds(null, aboveSea), higher)).isEqualTo("nothing");
    }

    @Test
    void letNobodyWriteParametersThatSayHowHighItComesHome() {
        Command climbs = new Command.SetParameters(List.of(new ParameterValue("RTL_ALT", 12_000)));

        assertThat(why(NEAR, climbs)).startsWith("Parameters say where a drone flies by itself");
        assertThat(ZoneRules.whyNot(List.of(), "the bounds", FLYING, climbs)).isEmpty();
    }

    @Test
    void letADroneFlyNoWayOfItsOwnThatNobodyKnows() {
        assertThat(why(NEAR, new Command.SetMode("CIRCLE")))
                .isEqualTo("Where it flies in CIRCLE is not known; so it cannot be checked against the bounds.");
        assertThat(why(NEAR, new Command.SetMode("GUIDED"))).isEqualTo("nothing");
    }

    @Test
    void allHold() {
        assertThat(ZoneRules.whyNot(
                        List.of(NEAR, new FlightBounds(ZoneFixtures.square(true, 0.0005, 0), AltitudeBand.ALL)),
                        "the bounds",
                        FLYING,
                        goTo(0.0012, 20)))
                .isPresent();
        assertThat(ZoneRules.whyNot(List.of(), "the bounds", FLYING, goTo(5, 20)))
                .isEmpty();
    }

    @Test
    void tellWhatTheyForbidFromWhatNobodyCanCheck() {
        Command climbs = new Command.SetParameters(List.of(new ParameterValue("RTL_ALT", 12_000)));
        Command higher = new Command.SetHome(ZoneFixtures.HOME, Altitude.aboveHome(100));

        assertThat(List.of(goTo(0.002, 20), goTo(0.000999, 20), climbs))
                .allSatisfy(command -> assertThat(kind(NEAR, command)).isEqualTo(RouteObjection.Kind.FORBIDDEN));
        assertThat(kind(new FlightBounds(null, LOW), higher)).isEqualTo(RouteObjection.Kind.FORBIDDEN);
        assertThat(kind(new FlightBounds(null, LOW), goTo(0, 51))).isEqualTo(RouteObjection.Kind.FORBIDDEN);

        Command onBoard = new Command.StartMission(MissionCloudLossPolicy.CONTINUE);
        assertThat(List.of(goTo(20, 20), onBoard, new GoToLocal(1, 2, null), new Command.SetMode("CIRCLE")))
                .allSatisfy(command -> assertThat(kind(NEAR, command)).isEqualTo(RouteObjection.Kind.NOT_CHECKABLE));
    }

    private static RouteObjection.Kind kind(FlightBounds bounds, Command command) {
        return ZoneRules.whyNot(List.of(bounds), "the bounds", FLYING, command)
                .orElseThrow()
                .kind();
    }

    @Test
    void areNoAreaToStayOutOf() {
        FenceArea keepOut = ZoneFixtures.square(false, 0, 0);

        assertThatThrownBy(() -> new FlightBounds(keepOut, AltitudeBand.ALL)).hasMessageContaining("stay within");
    }

    private static String why(FlightBounds bounds, Command command) {
        return ZoneRules.whyNot(List.of(bounds), "the bounds", FLYING, command)
                .map(RouteObjection::sentence)
                .orElse("nothing");
    }

    private static Command goTo(double north, double meters) {
        return new Command.GoTo(ZoneFixtures.at(north, 0), Altitude.aboveHome(meters));
    }

    private static Command upload(double north) {
        return new Command.UploadMission(new Mission(List.of(waypoint(0), waypoint(north))));
    }

    private static MissionItem waypoint(double north) {
        return new MissionItem.Waypoint(ZoneFixtures.at(north, 0), Altitude.aboveHome(20), 0);
    }
}
