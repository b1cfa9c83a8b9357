package org.dronemap.ws.zone;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Set;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.zone.AltitudeBand;
import org.dronemap.core.zone.Zone;
import org.junit.jupiter.api.Test;

class ZoneFeatureTest {
    private static final FenceArea CIRCLE = new FenceArea.Circle(false, new Geodetic(47.4, 8.5), 20);

    @Test
    void ofWhatEverybodyKeepsToIsOneAndNamesNobody() {
        assertThat(drones(Set.of())).containsExactly((String) null);
    }

    @Test
    void ofWhatSomeKeepToIsThereForEachOfThem() {
        assertThat(drones(Set.of(new DroneId("kestrel"), new DroneId("falcon"))))
                .containsExactly("falcon", "kestrel");
    }

    private static List<String> drones(Set<DroneId> bound) {
        Barrier barrier = new Barrier(Zone.words(CIRCLE, "Crane"), CIRCLE, AltitudeBand.ALL, bound);
        return Arrays.asList(ZoneFeature.of(barrier).stream()
                .peek(feature -> assertThat(feature.properties().name()).isEqualTo("Crane"))
                .map(feature -> feature.properties().drone())
                .toArray(String[]::new));
    }
}
