package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.lane.Watchdog;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.lease.LeaseRules;
import org.dronemap.core.safety.SafetyTimes;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.MissionRunFlight;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.plan.PlanRequest;
import org.junit.jupiter.api.Test;

/**
 * How long each silence of the table of times truly lasts until somebody acts on it: the worst of twenty moments of chance, from
 * the cause to what the server shows, the vehicle is told at its socket, or does. Printed for the table.
 */
class ReactionTimesTest {
    private static final int MOMENTS = 20;
    private static final int RUNS = 5;
    private static final long RTL = 6;
    private static final Duration LONGEST = Duration.ofMinutes(2);
    private static final Duration SLACK = Duration.ofSeconds(1);
    private static final LeaseRules CONTROL = LeaseRules.DEFAULT;

    /** One copter that hovers, and what happens to it. */
    private interface Moment {
        /** From the cause on; returns when it was acted on. */
        Duration passes(Laboratory lab, LabDrone drone, Pilot ann);
    }

    private static Duration worst(String what, Duration least, Moment moment) {
        SplittableRandom chance = new SplittableRandom(28);
        List<Duration> took = new ArrayList<>();
        for (int number = 0; number < MOMENTS; number++) {
            try (Laboratory lab = new Laboratory(number + 1)) {
                LabDrone drone = lab.copter();
                Pilot ann = lab.pilot("ann", Role.OPERATOR);
                ann.takesOff(drone, 20);
                lab.until("it hovers", Duration.ofSeconds(40), () -> drone.height() > 19);
                lab.goOn(Duration.ofMillis(chance.nextLong(2_000)));
                took.add(moment.passes(lab, drone, ann));
            }
        }
        return worst(what, least, took);
    }

    private static Duration worst(String what, Duration least, List<Duration> took) {
        Duration best = Collections.min(took);
        Duration worst = Collections.max(took);
        System.out.printf(
                Locale.ROOT, "%s: %.1f to %.1f s%n", what, best.toMillis() / 1_000.0, worst.toMillis() / 1_000.0);
        assertThat(best).as(what + " no sooner").isGreaterThanOrEqualTo(least);
        return worst;
    }

    private static Duration until(Laboratory lab, String what, BooleanSupplier holds) {
        long since = lab.time().nanos();
        lab.until(what, LONGEST, holds);
        return Duration.ofNanos(lab.time().nanos() - since);
    }

    private static Duration toldAfter(Laboratory lab, LabDrone drone, String what) {
        OrderCapture socket = new OrderCapture();
        drone.wire().capturedBy(socket);
        return until(lab, what, () -> !socket.ordersAfter(0).isEmpty());
    }

    private static boolean is(LabDrone drone, LinkState state) {
        return drone.state().link().state() == state;
    }

    @Test
    void aSilentVehicleIsSuspectThenLost() {
        Duration suspect = worst("suspect", Duration.ofMillis(500), (lab, drone, ann) -> {
            drone.wire().cut();
            return until(lab, "it is suspect", () -> !is(drone, LinkState.LIVE));
        });
        Duration lost = worst("lost", Watchdog.DEFAULT.lostAfter().minus(SLACK), (lab, drone, ann) -> {
            drone.wire().cut();
            return until(lab, "it is lost", () -> is(drone, LinkState.LOST));
        });

        assertThat(suspect).isLessThan(Watchdog.DEFAULT.suspectAfter().plus(SLACK));
        assertThat(lost).isLessThan(Watchdog.DEFAULT.lostAfter().plus(SLACK));
    }

    @Test
    void othersTakeOverWhatASilentDroneWasToDoAndInTheEndWhatLayAheadOfIt() {
        SplittableRandom chance = new SplittableRandom(28);
        List<Duration> taken = new ArrayList<>();
        List<Duration> freed = new ArrayList<>();
        for (int number = 0; number < RUNS; number++) {
            try (Laboratory lab = new Laboratory(number + 1)) {
                List<LabDrone> drones = lab.copters(2);
                MissionRunFlight run = runsFarOut(lab, drones).awaitsAll("flying");
                LabDrone silent = drones.get(0);
                LabDrone other = drones.get(1);
                lab.goOn(Duration.ofMillis(chance.nextLong(5_000)));
                List<String> all = run.of(silent, "assigned");
                silent.wire().cut();
                long since = lab.time().nanos();
                lab.until(
                        "others take over",
                        LONGEST,
                        () -> run.of(other, "assigned").stream().anyMatch(all::contains));
                taken.add(Duration.ofNanos(lab.time().nanos() - since));
                List<String> reserved = run.of(silent, "reserved");
                lab.until(
                        "what was reserved is given to others",
                        LONGEST,
                        () -> run.of(other, "assigned").containsAll(reserved));
                freed.add(Duration.ofNanos(lab.time().nanos() - since));
            }
        }
        Duration slowest = worst("taken over", Watchdog.DEFAULT.lostAfter().minus(SLACK), taken);
        Duration due = Watchdog.DEFAULT.lostAfter().plus(SafetyTimes.CORRIDOR_FREED);
        Duration last = worst("reserved and freed", due.minus(SLACK), freed);

        assertThat(slowest).isLessThan(Watchdog.DEFAULT.lostAfter().plus(SLACK));
        assertThat(last).isLessThan(due.plus(SLACK));
    }

    /** So far that each has more ahead of it than it may reach before it comes home by itself. */
    private static MissionRunFlight runsFarOut(Laboratory lab, List<LabDrone> drones) {
        LabDrone first = drones.get(0);
        List<PlanRequest.WaypointRequest> waypoints = IntStream.range(0, 12)
                .mapToObj(n -> MissionRunFlight.waypoint(
                        first.place((n % 2 == 0 ? 1 : -1) * 60, (1 + n / 2) * 120), first.groundAmsl() + 20))
                .toList();
        Pilot chief = lab.pilot("chief", Role.SUPERVISOR);
        return MissionRunFlight.begins(
                lab, chief, drones, waypoints, new MissionRunFlight.Manner("automatic", "rtl", null));
    }

    @Test
    void theDroneOfWhoTookControlAndFellSilentIsToldToHold() {
        Duration held = worst("holds", CONTROL.silence(), (lab, drone, ann) -> {
            ann.takesControl(drone);
            return toldAfter(lab, drone, "it is told to hold");
        });

        assertThat(held).isLessThan(CONTROL.silence().plus(SLACK));
    }

    @Test
    void controlThatCameWithACommandEndsAndItIsBroughtHome() {
        Duration ended = worst("control ends", CONTROL.idle(), (lab, drone, ann) -> {
            ann.fliesTo(drone, drone.place(5, 0), 20);
            return until(
                    lab, "control has ended", () -> ann.control(drone).state().equals("free"));
        });
        Duration home = worst("brought home", CONTROL.untilReturn(), (lab, drone, ann) -> {
            lab.until(
                    "control has ended",
                    LONGEST,
                    () -> ann.control(drone).state().equals("free"));
            return toldAfter(lab, drone, "it is told to return");
        });

        assertThat(ended).isLessThan(CONTROL.idle().plus(SLACK));
        assertThat(home).isLessThan(CONTROL.untilReturn().plus(SLACK));
    }

    @Test
    void aVehicleComesHomeByItselfWithoutTheServer() {
        Duration home = worst("comes home", SafetyTimes.VEHICLE_RETURNS.minus(SLACK), (lab, drone, ann) -> {
            lab.crashServer();
            return until(lab, "it comes home", () -> drone.mode() == RTL);
        });

        assertThat(home).isLessThan(SafetyTimes.VEHICLE_RETURNS.plus(SLACK));
        assertThat(home).isLessThan(SafetyTimes.CORRIDOR_KEPT);
    }

    @Test
    void tenVehiclesSideBySideComeHomeWithoutTheServerEachAtItsHeight() {
        try (Laboratory lab = new Laboratory(1)) {
            List<LabDrone> drones = lab.copters(10);
            Pilot ann = lab.pilot("ann", Role.OPERATOR);
            drones.forEach(drone -> ann.takesOff(drone, 20));
            // Each has to cross the ways of the others: the first is where the last has set off.
            for (int number = 0; number < drones.size(); number++) {
                LabDrone drone = drones.get(number);
                ann.fliesTo(drone, drones.get(drones.size() - 1 - number).place(60 + 15 * number, 0), 20);
            }
            lab.goOn(Duration.ofSeconds(150));
            lab.crashServer();

            Separation separation = new Separation(drones);
            lab.until("all come home", Duration.ofSeconds(30), () -> {
                separation.look();
                return drones.stream().allMatch(drone -> drone.mode() == RTL);
            });
            lab.until("all are down", Duration.ofMinutes(5), () -> {
                separation.look();
                return drones.stream().allMatch(LabDrone::isDown);
            });
            System.out.println(separation.words());
            assertThat(separation.least()).as(separation.words()).isGreaterThan(0.99);
        }
    }
}
