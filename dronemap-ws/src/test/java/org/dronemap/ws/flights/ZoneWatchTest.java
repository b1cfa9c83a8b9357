package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.dronemap.core.access.Role;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.SetMode;
import org.dronemap.sim.physics.NeuPosition;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.VehicleSpec;
import org.dronemap.ws.lab.VehicleTrack;
import org.dronemap.ws.lab.ZoneFixtures;
import org.junit.jupiter.api.Test;

/** The watch over zones in flight, in wind and for some drones at once: judged by where they are and what they are told. */
class ZoneWatchTest {
    private static final int DRONES = 4;
    private static final double RADIUS = 25;
    private static final double AHEAD = 120;
    private static final int SET_MODE = 176;
    private static final double NANOS = 1e9;

    /** A zone put in the way of a drone that flies. */
    private record Breach(LabDrone drone, Geodetic middle, long putNanos) {}

    @Test
    void breachesAreWarnedOfBeforeAndActedOnWithinASecond() {
        try (Laboratory lab = new Laboratory(1)) {
            Pilot chief = lab.pilot("chief", Role.SUPERVISOR);
            List<LabDrone> drones = IntStream.range(0, DRONES)
                    .mapToObj(n -> lab.add(VehicleSpec.COPTER.inWind(6)))
                    .toList();
            drones.forEach(lab::ready);
            SplittableRandom chance = new SplittableRandom(7);
            List<Breach> breaches = new ArrayList<>();
            for (LabDrone drone : drones) {
                chief.takesOff(drone, 10);
                breaches.add(sentOff(lab, chief, drone, chance.nextDouble(2 * Math.PI)));
            }

            for (Breach breach : breaches) {
                lab.until(
                        "it is told to hold",
                        Duration.ofMinutes(1),
                        () -> breach.drone().isTold("is told: hold"));
            }
            lab.goOn(Duration.ofSeconds(2));

            assertThat(breaches).allSatisfy(breach -> {
                double inside = inside(breach);
                assertThat(toldToHold(breach) - inside).isLessThan(1);
                assertThat(warned(lab, breach)).isLessThan(inside);
            });
        }
    }

    private static Breach sentOff(Laboratory lab, Pilot chief, LabDrone drone, double bearing) {
        NeuPosition start = drone.craft().body().position();
        Geodetic target = drone.place(start.north() + 500 * Math.cos(bearing), start.east() + 500 * Math.sin(bearing));
        chief.does(drone, CommandRequests.goTo(target.latitudeDegrees(), target.longitudeDegrees(), 10.0));
        lab.until(
                "it flies there",
                Duration.ofMinutes(1),
                () -> drone.craft().body().position().horizontalDistanceTo(start) > 5);
        Geodetic middle =
                drone.place(start.north() + AHEAD * Math.cos(bearing), start.east() + AHEAD * Math.sin(bearing));
        lab.server().zones().add(chief.principal(), ZoneFixtures.circle("Sudden", middle, RADIUS, drone, "hold"));
        return new Breach(drone, middle, lab.time().nanos());
    }

    /** When it was inside first, in s. */
    private static double inside(Breach breach) {
        for (VehicleTrack.Fix fix : breach.drone().track().since(breach.putNanos())) {
            if (fix.metersTo(breach.middle(), fix.amsl()) < RADIUS) {
                return fix.atNanos() / NANOS;
            }
        }
        throw new AssertionError("It never was inside");
    }

    private static double toldToHold(Breach breach) {
        return breach.drone().wire().traffic().down(breach.putNanos(), CommandLong.ID, SetMode.ID).stream()
                        .filter(heard -> heard.frame().messageId() == SetMode.ID
                                || CommandLong.decode(heard.frame()).command() == SET_MODE)
                        .findFirst()
                        .orElseThrow()
                        .atNanos()
                / NANOS;
    }

    private static double warned(Laboratory lab, Breach breach) {
        Instant at = breach.drone().state().messages().stream()
                .filter(message -> message.text().contains("If it goes on like this it enters"))
                .findFirst()
                .orElseThrow()
                .at();
        return lab.time().nanos() / NANOS - Duration.between(at, lab.now()).toMillis() / 1_000.0;
    }
}
