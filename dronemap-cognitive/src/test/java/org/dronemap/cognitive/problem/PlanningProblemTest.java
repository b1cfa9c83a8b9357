package org.dronemap.cognitive.problem;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.Collections;
import java.util.List;
import java.util.Set;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.separation.Separation;
import org.dronemap.core.zone.AltitudeBand;
import org.junit.jupiter.api.Test;

/** What cannot be planned with is refused by name, with the range that is allowed. */
class PlanningProblemTest {
    private final Craft craft = PlanningFixtures.craft(0, 0, 0);
    private final Waypoint waypoint = PlanningFixtures.waypoint(0, 100, 0);

    private static void refuses(ThrowingCallable making, String sentence) {
        assertThatIllegalArgumentException().isThrownBy(making).withMessage(sentence);
    }

    @Test
    void refusesFiguresOutOfRange() {
        refuses(
                () -> new Place(PlanningFixtures.point(0, 0), 10_001),
                "altitudeAmslMeters must be -500 to 10000: 10001");
        refuses(
                () -> new Place(PlanningFixtures.point(0, 0), Double.NaN),
                "altitudeAmslMeters must be -500 to 10000: NaN");
        refuses(() -> new UniformWind(-1, 0), "wind metersPerSecond must be 0 to 100: -1");
        refuses(() -> new UniformWind(1, 361), "wind fromDegrees must be 0 to 360: 361");
        refuses(() -> new Task(-0.5, Set.of()), "serviceSeconds must be 0 to 86400: -0.5");
        refuses(() -> new TimeWindow(5, 4), "closesSeconds must be at least opensSeconds (5.0): 4.0");
        refuses(() -> new EnergyBudget(-1, 0), "remainingJoules must be at least 0: -1");
        refuses(() -> craft.withLinkQuality(1.5), "linkQuality must be 0 to 1: 1.5");
        refuses(() -> new Speeds(10, 2, 1, 0.5, 9, 2), "greatest airspeed must be 10 to 300: 9");
        refuses(() -> new Speeds(10, 2, 1, 0.5, 12, 0), "acceleration must be above 0: 0");
        refuses(() -> new Power(-1, 0, 0), "hover power must be 0 to 1000000: -1");
        refuses(
                () -> new Objective(0, Objective.Measure.JOULES, 0, false),
                "longestWeight and sumWeight must not both be 0");
        refuses(
                () -> new Waypoint("w", waypoint.place(), Task.FLY_THROUGH, 0, TimeWindow.ALWAYS),
                "priority must be 0.001 to 1000: 0");
        refuses(() -> new PlanningRules(Separation.USUAL, 2, 3, 5), "leastLinkQuality must be 0 to 1: 2");
        refuses(() -> new Start(waypoint.place(), true, Double.POSITIVE_INFINITY), """
                readySeconds must be 0 to %s: Infinity""".formatted(Double.MAX_VALUE));
    }

    @Test
    void refusesProblemsThatAreNone() {
        refuses(() -> PlanningProblem.of(List.of(waypoint), List.of()), "number of drones must be 1 to 1000: 0");
        Barrier circle = new Barrier(
                "the pond", new FenceArea.Circle(false, PlanningFixtures.point(0, 0), 10), AltitudeBand.ALL, Set.of());
        refuses(
                () -> PlanningProblem.of(List.of(waypoint), List.of(craft))
                        .withBarriers(Collections.nCopies(251, circle)),
                "number of corners of all zones must be 0 to 4000: 4016");
        refuses(
                () -> PlanningProblem.of(List.of(waypoint, waypoint), List.of(craft)),
                "the waypoint w0 is named twice");
        refuses(() -> PlanningProblem.of(List.of(), List.of(craft, craft)), "the drone d0 is named twice");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> PlanningProblem.of(List.of(PlanningFixtures.waypoint(7, 300_000, 0)), List.of(craft)))
                .withMessageStartingWith("metres from the first drone to waypoint w7 must be 0 to 200000: ");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> PlanningProblem.of(
                        List.of(Waypoint.at("pole", new Place(new Geodetic(86, 8), 0))), List.of(craft)))
                .withMessage("latitude of waypoint pole must be -85 to 85: 86");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Barrier(
                        "the bow",
                        new FenceArea.Polygon(
                                false,
                                List.of(
                                        PlanningFixtures.point(0, 0),
                                        PlanningFixtures.point(100, 100),
                                        PlanningFixtures.point(100, 0),
                                        PlanningFixtures.point(0, 100))),
                        AltitudeBand.ALL,
                        Set.of()))
                .withMessageStartingWith("the bow: The edge of the area crosses or touches itself");
    }

    @Test
    void hasFiguresForEveryKindOfVehicleAndSaysThatTheyAreAssumed() {
        for (VehicleKind kind : VehicleKind.values()) {
            assertThat(Performance.of(kind).assumed()).isTrue();
        }
        assertThat(PlanningFixtures.copter().assumed()).isFalse();
    }

    @Test
    void takesCoptersToFlyAsFastAsTheirAutopilotIsDelivered() {
        VehicleKind copter = VehicleKind.MULTICOPTER;

        assertThat(Performance.of(copter, "ArduPilot").speeds().cruise()).isEqualTo(10);
        assertThat(Performance.of(copter, "PX4").speeds().cruise()).isEqualTo(5);
        assertThat(Performance.of(copter, "PX4").assumed()).isTrue();
        assertThat(Performance.of(copter, "another one")).isEqualTo(Performance.of(copter));
        assertThat(Performance.of(VehicleKind.ROVER, "PX4")).isEqualTo(Performance.of(VehicleKind.ROVER));
    }

    @Test
    void knowsWhoCanDoWhat() {
        Task photo = new Task(3, Set.of(Skill.of(Capability.TAKE_PICTURE)));

        assertThat(craft.can(photo)).isFalse();
        assertThat(craft.withSkills(photo.needs()).can(photo)).isTrue();
        assertThat(craft.can(Task.FLY_THROUGH)).isTrue();
        assertThat(PlanningProblem.of(List.of(), List.of(craft)).trusts(craft.withLinkQuality(0.4)))
                .isFalse();
    }

    @Test
    void countsWattHoursAndWind() {
        assertThat(EnergyBudget.ofWattHours(50, 10).rangeJoules()).isEqualTo(144_000);
        assertThat(new EnergyBudget(5, 10).rangeJoules()).isZero();
        assertThat(new UniformWind(4, 90).eastMetersPerSecond()).isCloseTo(-4, within(1e-9));
        assertThat(new UniformWind(4, 180).northMetersPerSecond()).isCloseTo(4, within(1e-9));
    }

    @Test
    void wheelsNeitherTakeOffNorLand() {
        Craft rover = Craft.atHome(
                new DroneId("rover"), PlanningFixtures.place(0, 0, 400), Performance.of(VehicleKind.ROVER));

        assertThat(rover.beginsWithTakeOff()).isFalse();
        assertThat(rover.lands()).isFalse();
        assertThat(craft.beginsWithTakeOff()).isTrue();
    }
}
