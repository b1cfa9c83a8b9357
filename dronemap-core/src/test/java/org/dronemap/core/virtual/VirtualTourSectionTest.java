package org.dronemap.core.virtual;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.core.virtual.VirtualFixtures.Drone;
import org.junit.jupiter.api.Test;

class VirtualTourSectionTest {
    private final VirtualTour tour = VirtualTour.of(VirtualFixtures.mission(5));

    @Test
    void countsOnFromWhereTheDroneBeforeLeftOff() {
        VirtualTourSection second = tour.share(2, 20.0);

        assertThat(flown(second, 0)).isEqualTo(2);
        assertThat(flown(second, 1)).as("on its way to its first waypoint").isEqualTo(2);
        assertThat(flown(second, 2)).isEqualTo(3);
        assertThat(flown(second, 4, 3)).as("at its last waypoint").isEqualTo(5);
        assertThat(flown(second, 4)).as("on its way home").isEqualTo(5);
    }

    @Test
    void countsOnAlsoForWhatDoesNotTakeOff() {
        VirtualTourSection second = tour.share(3, null);

        assertThat(flown(second, 0)).isEqualTo(3);
        assertThat(flown(second, 1)).isEqualTo(4);
        assertThat(flown(second, 2)).isEqualTo(5);
    }

    @Test
    void countsFromTheBeginningForTheFirstDrone() {
        VirtualTourSection first = tour.share(0, 20.0);

        assertThat(flown(first, 1)).isZero();
        assertThat(flown(first, 3)).isEqualTo(2);
    }

    private static int flown(VirtualTourSection share, int current, Integer... reached) {
        return share.flown(
                new Drone("d", 0).carries(share, current, reached).state().mission());
    }
}
