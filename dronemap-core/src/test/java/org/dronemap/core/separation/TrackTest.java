package org.dronemap.core.separation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.dronemap.core.geo.PlanePoint;
import org.junit.jupiter.api.Test;

/** Distances between two that move, found in closed form between samples. */
class TrackTest {
    private static final Separation LEAST = new Separation(10, 5);

    private static Track straight(double east, double north, double eastward, double northward) {
        List<TrackSample> samples = new ArrayList<>();
        for (int i = 0; i <= 20; i++) {
            double seconds = i * Track.STRIDE_SECONDS;
            samples.add(new TrackSample(new PlanePoint(east + eastward * seconds, north + northward * seconds), 20));
        }
        return new Track(samples);
    }

    /** At no sample are they nearer than 12 m. */
    @Test
    void findsTheNearestBetweenTwoSamples() {
        Track one = straight(-12.5, 0, 25, 0);
        Track other = straight(12.5, 0, -25, 0);
        assertThat(one.clearance(other, LEAST)).isZero();
    }

    @Test
    void agreesWithSamplesOfHundredths() {
        SplittableRandom chance = new SplittableRandom(5);
        for (int trial = 0; trial < 500; trial++) {
            double[] a = chance.doubles(4, -20, 20).toArray();
            double[] b = chance.doubles(4, -20, 20).toArray();
            double nearest = Double.POSITIVE_INFINITY;
            for (double t = 0; t <= 10; t += 0.01) {
                nearest = Math.min(
                        nearest, Math.hypot(a[0] + a[2] * t - b[0] - b[2] * t, a[1] + a[3] * t - b[1] - b[3] * t));
            }
            double found = straight(a[0], a[1], a[2], a[3]).clearance(straight(b[0], b[1], b[2], b[3]), LEAST);
            assertThat(found).isCloseTo(Math.min(8, nearest / 10), within(0.03));
        }
    }

    @Test
    void heightCountsWhereTheyAreBesideEachOther() {
        Track one = straight(0, 0, 1, 0);
        Track above = new Track(one.samples().stream()
                .map(sample -> new TrackSample(sample.spot(), 24.9))
                .toList());
        assertThat(one.clearance(above, LEAST)).isLessThan(1);
        assertThat(one.clearance(above, new Separation(10, 4.9))).isCloseTo(1, within(1e-9));
    }
}
