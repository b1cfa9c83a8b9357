package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.ManualControl;
import org.dronemap.mavlink.message.MissionClearAll;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionSetCurrent;
import org.dronemap.mavlink.message.ParamSet;
import org.dronemap.mavlink.message.RcChannelsOverride;
import org.dronemap.mavlink.message.SetMode;
import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.dronemap.mavlink.message.SetPositionTargetLocalNed;
import org.dronemap.sim.physics.LocalFrame;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.LabVehicleLink;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.LinkTraffic;
import org.dronemap.ws.lab.MissionRunFlight;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.VehicleSpec;
import org.dronemap.ws.lab.VehicleTrack;
import org.dronemap.ws.plan.PlanRequest;
import org.dronemap.ws.run.RunView;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** A mission run when something goes wrong, and when nothing does but the weather and the links. */
class RunFlightTest {
    private static final double NEAR_METERS = 5;
    private static final long LOITER = 5;
    private static final Set<Integer> QUESTIONS = Set.of(511, 512, 519, 520);
    private static final int[] ORDERS = {
        CommandLong.ID,
        CommandInt.ID,
        SetMode.ID,
        ParamSet.ID,
        ManualControl.ID,
        RcChannelsOverride.ID,
        MissionCount.ID,
        MissionItemInt.ID,
        MissionClearAll.ID,
        MissionSetCurrent.ID,
        SetPositionTargetGlobalInt.ID,
        SetPositionTargetLocalNed.ID
    };

    /** What a run says of a drone that it does not count on any more, or not for all that it was to do. */
    private static final Set<String> DOUBTS = Set.of(
            "lost",
            "gone",
            "crashed",
            "lowBattery",
            "wentHome",
            "cameDown",
            "removed",
            "offPath",
            "late",
            "commandFailed",
            "givenUp",
            "takenOver");

    private final Laboratory lab = new Laboratory(1);
    private final Pilot chief = lab.pilot("chief", Role.SUPERVISOR);

    @AfterEach
    void close() {
        lab.close();
    }

    @Test
    void othersFlyWhatAFallenDroneLeavesAndACrashOfTheServerChangesNothing() {
        List<LabDrone> drones = lab.copters(3);
        LabDrone fallen = drones.get(0);
        List<PlanRequest.WaypointRequest> waypoints = IntStream.range(0, 12)
                .mapToObj(n -> MissionRunFlight.waypoint(
                        fallen.place((1 + n % 4) * 30, (n / 4 - 1) * 30), fallen.groundAmsl() + 20))
                .toList();
        MissionRunFlight run = MissionRunFlight.begins(lab, chief, drones, waypoints, MissionRunFlight.Manner.ON)
                .awaitsAll("flying");
        lab.untilSeen(
                "it is on its way",
                Duration.ofMinutes(2),
                () -> !run.of(fallen, "visited").isEmpty());
        List<String> left = run.of(fallen, "assigned");
        fallen.craft().failMotor();
        lab.untilSeen(
                "it is given up",
                Duration.ofSeconds(30),
                () -> run.stage(fallen).equals("crashed"));

        lab.crashServer();
        lab.goOn(Duration.ofSeconds(3));
        lab.startServer();
        RunView over = run.end();

        assertThat(over.counts().visited()).isEqualTo(12);
        assertThat(over.waypoints())
                .allSatisfy(one -> assertThat(run.missed(one)).isLessThan(NEAR_METERS));
        assertThat(left).isNotEmpty();
        assertThat(over.waypoints().stream()
                        .filter(one ->
                                !one.visits().get(0).drone().equals(fallen.id().value()))
                        .map(RunView.WaypointView::id))
                .containsAnyElementsOf(left);
        assertThat(over.explanations())
                .extracting(RunView.ExplanationView::trigger)
                .contains("crashed", "restarted");
        assertThat(run.decidesTheSameAgain()).isTrue();
    }

    @Test
    void whatAPilotTakesADroneFromAnotherFliesAtTheSameHeightAndNobodyOrdersItAbout() {
        LabDrone stays = lab.add(VehicleSpec.COPTER, new LocalFrame(47.3977, 8.5456, 488));
        LabDrone leaves = lab.add(VehicleSpec.COPTER, new LocalFrame(47.3977, 8.5472, 568));
        Stream.of(stays, leaves).forEach(lab::ready);
        List<PlanRequest.WaypointRequest> waypoints = IntStream.range(0, 8)
                .mapToObj(n -> MissionRunFlight.waypoint(stays.place(44.5, n * 120.5 / 7), 590 + 2 * n))
                .toList();
        MissionRunFlight run =
                MissionRunFlight.begins(lab, chief, List.of(stays, leaves), waypoints, MissionRunFlight.Manner.ON);
        lab.untilSeen(
                "it is on its way",
                Duration.ofMinutes(4),
                () -> !run.of(leaves, "visited").isEmpty());

        leaves.switchedTo(LOITER);
        lab.untilSeen(
                "the pilot has it",
                Duration.ofSeconds(30),
                () -> run.stage(leaves).equals("suspended"));
        long since = lab.time().nanos();
        lab.untilSeen(
                "the other one has all",
                Duration.ofSeconds(30),
                () -> !run.next(stays).isEmpty());
        List<String> left = run.next(stays);
        lab.untilSeen(
                "the other one has done what it can",
                Duration.ofMinutes(8),
                () -> run.stage(stays).equals("landed"));

        requireFlown(run.view(), stays, left);
        assertThat(orders(leaves, since)).isEmpty();
        assertThat(leaves.mode()).isEqualTo(LOITER);
        assertThat(leaves.state().mode()).isEqualTo("LOITER");
        assertThat(run.told("takenOver").get(0).drone()).isEqualTo(leaves.id().value());

        lab.server().runs().resume(chief.principal(), run.id(), leaves.id().value());
        assertThat(run.end().counts().visited()).isEqualTo(8);
        assertThat(orders(leaves, since)).isNotEmpty();
        assertThat(run.decidesTheSameAgain()).isTrue();
    }

    /** What was left to that one, but where the pilot hovers; meanwhile nobody may go there. */
    private static void requireFlown(RunView ends, LabDrone stays, List<String> left) {
        assertThat(ends.waypoints())
                .filteredOn(one -> !one.state().equals("visited"))
                .allSatisfy(one -> assertThat(one.why()).contains("stands in the air there"));
        assertThat(ends.waypoints())
                .filteredOn(one -> left.contains(one.id()) && one.state().equals("visited"))
                .isNotEmpty()
                .allSatisfy(one -> {
                    assertThat(stays.track().nearest(MissionRunFlight.place(one), one.altitudeAmsl()))
                            .isLessThan(NEAR_METERS);
                    assertThat(offHeight(one, stays)).isLessThan(1);
                });
    }

    /** How many metres too high or too low it was where it came nearest over the ground. */
    private static double offHeight(RunView.WaypointView one, LabDrone drone) {
        double nearest = Double.POSITIVE_INFINITY;
        double off = Double.POSITIVE_INFINITY;
        for (VehicleTrack.Fix fix : drone.track().since(0)) {
            double away = Geodesy.distanceMeters(fix.place(), MissionRunFlight.place(one));
            if (away < nearest) {
                nearest = away;
                off = Math.abs(fix.amsl() - one.altitudeAmsl());
            }
        }
        return off;
    }

    /** What tells that vehicle to do something; asking it for messages is none. */
    private static List<Frame> orders(LabDrone drone, long since) {
        return drone.wire().traffic().down(since, ORDERS).stream()
                .map(LinkTraffic.Heard::frame)
                .filter(frame -> frame.messageId() != CommandLong.ID
                        || !QUESTIONS.contains(CommandLong.decode(frame).command()))
                .toList();
    }

    @Test
    void nobodyIsGivenUpForGustsGapsBetweenHeartbeatsAndLostMessages() {
        List<LabDrone> drones = IntStream.range(0, 3)
                .mapToObj(n -> lab.add(VehicleSpec.COPTER.inWind(6)))
                .toList();
        drones.forEach(lab::ready);
        SplittableRandom chance = new SplittableRandom(1);
        LabDrone first = drones.get(0);
        List<PlanRequest.WaypointRequest> waypoints = IntStream.range(0, 9)
                .mapToObj(n -> MissionRunFlight.waypoint(
                        first.place(chance.nextDouble(-22, 22), chance.nextDouble(-25, 145)),
                        first.groundAmsl() + 15 + 5 * chance.nextInt(3)))
                .toList();
        LabVehicleLink.Quality lossy = new LabVehicleLink.Quality(0.1, Duration.ofMillis(10), Duration.ofMillis(40));
        drones.forEach(drone -> drone.wire().is(lossy));

        MissionRunFlight run = MissionRunFlight.begins(
                lab, chief, drones, waypoints, new MissionRunFlight.Manner("automatic", "rtl", 1.0));
        lab.untilSeen("they fly", Duration.ofMinutes(2), () -> run.allAre("flying"));
        for (LabDrone drone : drones) {
            // Now and then a vehicle says nothing for some seconds, and hears all the same.
            drone.wire().isSilentUpwards(true);
            lab.goOn(Duration.ofMillis(3_500));
            drone.wire().isSilentUpwards(false);
            lab.goOn(Duration.ofSeconds(2));
        }
        RunView over = run.end();

        assertThat(over.explanations())
                .extracting(RunView.ExplanationView::trigger)
                .doesNotContainAnyElementsOf(DOUBTS);
        assertThat(run.allAre("landed")).isTrue();
        assertThat(drones).allMatch(LabDrone::isDown);
        assertThat(over.counts().visited()).isEqualTo(9);
        assertThat(over.waypoints())
                .allSatisfy(one -> assertThat(run.missed(one)).isLessThan(NEAR_METERS));
    }
}
