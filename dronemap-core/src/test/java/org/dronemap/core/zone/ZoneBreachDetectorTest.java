package org.dronemap.core.zone;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.mission.Altitude;
import org.junit.jupiter.api.Test;

class ZoneBreachDetectorTest {
    private static final long STEP_NANOS = 200_000_000L;
    /** 10 m/s to the north. */
    private static final double STEP_DEGREES = 2 / 111_195.0;

    private final ZoneBreachDetector lookout = new ZoneBreachDetector();
    private long nanos;

    @Test
    void warnsOnceAheadAndOnceMoreAtTheBreach() {
        Zone zone = ZoneFixtures.zone(ZoneFixtures.square(false, 0.003, 0));

        List<ZoneBreachDetector.Finding> findings = fly(zone, 0, 140, 20);

        // From 222 m away at 10 m/s: 10 s ahead are 122 m on.
        assertThat(findings.subList(2, findings.size()))
                .allMatch(ZoneBreachDetector.Finding.Continuing.class::isInstance);
        assertThat(findings.get(0))
                .isInstanceOfSatisfying(
                        ZoneBreachDetector.Finding.Predicted.class,
                        ahead -> assertThat(ahead.seconds()).isBetween(9.0, 10.0));
        assertThat(findings.get(1)).isEqualTo(new ZoneBreachDetector.Finding.Breach(zone));
    }

    @Test
    void saysNothingToADroneThatPassesByOrAbove() {
        Zone low = ZoneFixtures.zone(
                ZoneFixtures.square(false, 0.003, 0), new AltitudeBand(null, 30.0, Altitude.Reference.HOME));

        assertThat(fly(low, 0, 200, 40)).isEmpty();
        assertThat(fly(ZoneFixtures.zone(ZoneFixtures.square(false, 0.003, 0.003)), 0, 200, 20))
                .isEmpty();
    }

    @Test
    void seesADroneLeaveItsArea() {
        Zone field = ZoneFixtures.zone(ZoneFixtures.square(true, 0, 0));

        assertThat(fly(field, 0, 70, 20))
                .extracting(finding -> finding.getClass().getSimpleName())
                .containsExactly("Predicted", "Breach");
    }

    @Test
    void seesAClimbOverTheCeilingButLetsItLandBelowTheFloor() {
        Zone field = ZoneFixtures.zone(
                ZoneFixtures.square(true, 0, 0), new AltitudeBand(10.0, 50.0, Altitude.Reference.HOME));
        List<ZoneBreachDetector.Finding> findings = new ArrayList<>();
        for (double height = 40; height > 1; height -= 0.4) {
            findings.addAll(look(field, 0, height));
        }
        assertThat(findings).isEmpty();
        for (double height = 1; height < 52; height += 0.4) {
            findings.addAll(look(field, 0, height));
        }
        assertThat(findings)
                .extracting(finding -> finding.getClass().getSimpleName())
                .containsExactly("Predicted", "Breach");
    }

    @Test
    void findsABreachThatAppearsOverADroneThatHolds() {
        Zone zone = ZoneFixtures.zone(ZoneFixtures.square(false, 0, 0));
        look(zone, 0.002, 20);

        assertThat(look(zone, 0, 20)).containsExactly(new ZoneBreachDetector.Finding.Breach(zone));
        assertThat(look(zone, 0, 20)).isEmpty();
    }

    @Test
    void takesATremblingPositionAtTheEdgeForOneBreach() {
        Zone zone = ZoneFixtures.zone(ZoneFixtures.square(false, 0, 0));
        List<ZoneBreachDetector.Finding> findings = new ArrayList<>();
        for (int i = 0; i < 50; i++) {
            findings.addAll(look(zone, i % 2 == 0 ? 0.000999 : 0.001001, 20));
        }
        assertThat(findings).containsOnlyOnce(new ZoneBreachDetector.Finding.Breach(zone));
    }

    @Test
    void saysAgainEveryTenSecondsThatItIsStillInside() {
        Zone zone = ZoneFixtures.zone(ZoneFixtures.square(false, 0, 0));
        List<ZoneBreachDetector.Finding> findings = new ArrayList<>();
        for (int i = 0; i < 110; i++) {
            findings.addAll(look(zone, 0, 20));
        }
        assertThat(findings)
                .containsExactly(
                        new ZoneBreachDetector.Finding.Breach(zone),
                        new ZoneBreachDetector.Finding.Continuing(zone),
                        new ZoneBreachDetector.Finding.Continuing(zone));
    }

    @Test
    void findsASecondBreachAfterItWasOutside() {
        Zone zone = ZoneFixtures.zone(ZoneFixtures.square(false, 0, 0));
        assertThat(look(zone, 0, 20)).hasSize(1);
        for (int i = 0; i < 20; i++) {
            look(zone, 0.005, 20);
        }
        assertThat(look(zone, 0, 20)).containsExactly(new ZoneBreachDetector.Finding.Breach(zone));
    }

    private List<ZoneBreachDetector.Finding> fly(Zone zone, double fromDegrees, int steps, double height) {
        List<ZoneBreachDetector.Finding> findings = new ArrayList<>();
        for (int i = 0; i < steps; i++) {
            findings.addAll(look(zone, fromDegrees + i * STEP_DEGREES, height));
        }
        return findings;
    }

    private List<ZoneBreachDetector.Finding> look(Zone zone, double north, double height) {
        nanos += STEP_NANOS;
        return lookout.check(List.of(zone), ZoneFixtures.flying(ZoneFixtures.at(north, 0), height), nanos);
    }
}
