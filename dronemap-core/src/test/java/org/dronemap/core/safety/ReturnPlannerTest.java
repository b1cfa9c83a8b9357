package org.dronemap.core.safety;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.IdentityTrust;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.LinkStatus;
import org.dronemap.core.drone.MissionProgress;
import org.dronemap.core.drone.PayloadState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.ReturnHeight;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

class ReturnPlannerTest {
    private static final Instant NOW = Instant.parse("2026-03-04T05:06:07Z");
    private static final Geodetic HERE = new Geodetic(24.7, 46.7);
    /** 1.1 km away. */
    private static final Home HOME = new Home(new Geodetic(24.71, 46.7), 600);
    /** 110 m and 55 m away. */
    private static final LandingSite RALLY = new LandingSite(new Geodetic(24.701, 46.7), "a rally point");

    private static final LandingSite FIELD = new LandingSite(new Geodetic(24.6995, 46.7), "a field");
    private static final Set<Capability> ALL = Set.of(Capability.values());
    private static final OptionalDouble PLENTY = OptionalDouble.of(1_200);
    private static final OptionalDouble LITTLE = OptionalDouble.of(150);
    private static final OptionalDouble NOTHING = OptionalDouble.of(50);
    private static final String CROWD = "The way touches “Crowd”.";

    /** What some zones say. */
    private record FakeZoneCheck(
            Optional<String> againstReturn, Optional<String> againstFlying, Optional<String> againstLanding)
            implements ReturnPlanner.ZoneCheck {
        static final FakeZoneCheck NOTHING = new FakeZoneCheck(Optional.empty(), Optional.empty(), Optional.empty());

        @Override
        public Optional<String> against(Command.GoTo way) {
            return againstFlying;
        }
    }

    private static DroneState drone(Set<Capability> can, @Nullable Geodetic point) {
        return drone(can, point, null);
    }

    /** In the air. */
    static DroneState with(@Nullable Battery battery) {
        return drone(ALL, HERE, battery);
    }

    private static DroneState drone(Set<Capability> can, @Nullable Geodetic point, @Nullable Battery battery) {
        return drone(can, point, battery, null);
    }

    private static DroneState drone(
            Set<Capability> can, @Nullable Geodetic point, @Nullable Battery battery, @Nullable ReturnHeight height) {
        return new DroneState(
                new DroneId("drone-1"),
                "Copter 1",
                false,
                new LinkStatus(
                        new DroneKey("127.0.0.1", 14601, 1),
                        "udp",
                        LinkState.LIVE,
                        NOW,
                        LinkQuality.UNKNOWN,
                        List.of()),
                new Identification(VehicleKind.MULTICOPTER, "ArduPilot", "ArduCopter", "4.5.6", null),
                IdentityTrust.UNPROVED,
                new Capabilities(can, List.of("GUIDED")),
                "GUIDED",
                true,
                null,
                FlightPhase.IN_AIR,
                new Position(point, null, 20.0),
                null,
                null,
                null,
                battery,
                null,
                HOME,
                height,
                PayloadState.UNKNOWN,
                MissionProgress.UNKNOWN,
                List.of(),
                NOW,
                1,
                null);
    }

    private static ReturnPlanner.PlannedReturn next(
            OptionalDouble left, ReturnPlanner.ZoneCheck zones, ReturnOption... failed) {
        Set<ReturnOption> all = failed.length == 0 ? Set.of() : EnumSet.copyOf(List.of(failed));
        return ReturnPlanner.next(
                new ReturnPlanner.Situation(drone(ALL, HERE), left, List.of(RALLY, FIELD), all), zones);
    }

    private static ReturnPlanner.PlannedReturn without(Capability missing) {
        Set<Capability> can = EnumSet.allOf(Capability.class);
        can.remove(missing);
        return ReturnPlanner.next(
                new ReturnPlanner.Situation(drone(can, HERE), PLENTY, List.of(), Set.of()), FakeZoneCheck.NOTHING);
    }

    @Test
    void returnsWhereItCan() {
        assertThat(next(PLENTY, FakeZoneCheck.NOTHING).command()).isEqualTo(new Command.ReturnToLaunch());
        assertThat(next(OptionalDouble.empty(), FakeZoneCheck.NOTHING).command())
                .isEqualTo(new Command.ReturnToLaunch());
        ReturnPlanner.Situation untold = new ReturnPlanner.Situation(drone(ALL, null), PLENTY, List.of(), Set.of());
        assertThat(ReturnPlanner.next(untold, FakeZoneCheck.NOTHING).rung())
                .as("what it does not tell it may know")
                .isEqualTo(ReturnOption.RETURN);
    }

    @Test
    void fliesToTheNearestPlaceThatItsBatteryLastsForAtTheHeightThatItHas() {
        ReturnPlanner.PlannedReturn step = next(LITTLE, FakeZoneCheck.NOTHING);

        assertThat(step.command()).isEqualTo(new Command.GoTo(FIELD.point(), Altitude.aboveHome(20)));
        assertThat(step.place()).isEqualTo(FIELD);
        assertThat(step.why()).startsWith("Its battery lasts for about 150 s, and the way home takes about 3");
        assertThat(next(PLENTY, FakeZoneCheck.NOTHING, ReturnOption.RETURN).place())
                .isEqualTo(FIELD);
    }

    @Test
    void countsHowHighItWasToldToFlyHome() {
        OptionalDouble enough = OptionalDouble.of(400);
        DroneState low = drone(ALL, HERE, null, null);
        DroneState layered = drone(ALL, HERE, null, new ReturnHeight(120, 15));

        assertThat(ReturnPlanner.next(
                                new ReturnPlanner.Situation(low, enough, List.of(), Set.of()), FakeZoneCheck.NOTHING)
                        .rung())
                .isEqualTo(ReturnOption.RETURN);
        assertThat(ReturnPlanner.next(
                                new ReturnPlanner.Situation(layered, enough, List.of(), Set.of()),
                                FakeZoneCheck.NOTHING)
                        .rung())
                .as("up to its layer and down again takes longer than its battery lasts")
                .isEqualTo(ReturnOption.LAND);
    }

    @Test
    void landsWhereItIsWhenNoPlaceIsToBeHad() {
        assertThat(next(NOTHING, FakeZoneCheck.NOTHING).command()).isEqualTo(new Command.Land());
        assertThat(next(PLENTY, FakeZoneCheck.NOTHING, ReturnOption.RETURN, ReturnOption.ELSEWHERE)
                        .command())
                .isEqualTo(new Command.Land());
        assertThat(without(Capability.RETURN_TO_LAUNCH).command()).isEqualTo(new Command.Land());
        FakeZoneCheck nothingToBeAsked = new FakeZoneCheck(Optional.empty(), Optional.empty(), Optional.of(CROWD));
        Set<ReturnOption> refused = Set.of(ReturnOption.RETURN);
        ReturnPlanner.Situation nowhere =
                new ReturnPlanner.Situation(drone(ALL, null), PLENTY, List.of(FIELD), refused);
        assertThat(ReturnPlanner.next(nowhere, nothingToBeAsked).command()).isEqualTo(new Command.Land());
    }

    @Test
    void asksTheZonesForEachWay() {
        FakeZoneCheck home = new FakeZoneCheck(Optional.of(CROWD), Optional.empty(), Optional.empty());
        assertThat(next(PLENTY, home).rung()).isEqualTo(ReturnOption.ELSEWHERE);
        FakeZoneCheck allWays = new FakeZoneCheck(Optional.of(CROWD), Optional.of(CROWD), Optional.empty());
        assertThat(next(PLENTY, allWays).rung()).isEqualTo(ReturnOption.LAND);
        FakeZoneCheck everywhere = new FakeZoneCheck(Optional.of(CROWD), Optional.of(CROWD), Optional.of(CROWD));
        ReturnPlanner.PlannedReturn none = next(PLENTY, everywhere);
        assertThat(none.command()).isNull();
        assertThat(none.why()).contains("It does not return: " + CROWD, "It does not land here: " + CROWD);
        assertThat(next(NOTHING, everywhere).rung()).as("before it falls").isEqualTo(ReturnOption.LAND);
    }

    @Test
    void saysWhyNothingCanBeDone() {
        Set<Capability> nothing = Set.of(Capability.ARM);
        ReturnPlanner.PlannedReturn step = ReturnPlanner.next(
                new ReturnPlanner.Situation(drone(nothing, HERE), PLENTY, List.of(FIELD), Set.of()),
                FakeZoneCheck.NOTHING);

        assertThat(step.rung()).isNull();
        assertThat(step.why()).isEqualTo("It cannot return by itself. It cannot land by itself.");
    }

    @Test
    void hurriesWhenTheBatteryLastsOnlyJust() {
        DroneState far = drone(ALL, HERE);
        double needed = BatteryEndurance.secondsTo(far, HOME.point(), 30).orElseThrow();

        assertThat(ReturnPlanner.hurries(far, OptionalDouble.of(needed + 1), 2)).isTrue();
        assertThat(ReturnPlanner.hurries(far, OptionalDouble.of(needed + 3), 2)).isFalse();
        assertThat(ReturnPlanner.hurries(far, OptionalDouble.empty(), 2)).isFalse();
    }
}
