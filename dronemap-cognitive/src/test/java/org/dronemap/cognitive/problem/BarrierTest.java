package org.dronemap.cognitive.problem;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Set;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.zone.AltitudeBand;
import org.dronemap.core.zone.Zone;
import org.junit.jupiter.api.Test;

class BarrierTest {
    @Test
    void isNamedAsItsZoneIs() {
        for (String name : new String[] {"Crane", "", "“Old” mill”"}) {
            for (boolean inside : new boolean[] {true, false}) {
                FenceArea shape = circle(inside);
                assertThat(barrier(Zone.words(shape, name), shape).name()).isEqualTo(name);
            }
        }
    }

    @Test
    void isNamedAsItIsToldWhenItIsNoZone() {
        assertThat(barrier("Eagle, which stands in the air there,", circle(false))
                        .name())
                .isEqualTo("Eagle, which stands in the air there,");
    }

    private static FenceArea circle(boolean inside) {
        return new FenceArea.Circle(inside, new Geodetic(47.4, 8.5), 20);
    }

    private static Barrier barrier(String words, FenceArea shape) {
        return new Barrier(words, shape, AltitudeBand.ALL, Set.of());
    }
}
