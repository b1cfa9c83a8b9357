package org.dronemap.core.conduct;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.IntStream;
import org.dronemap.core.cloud.Claim;
import org.dronemap.core.cloud.CloudFixtures;
import org.dronemap.core.cloud.DroneLink;
import org.dronemap.core.cloud.LinkSession;
import org.dronemap.core.cloud.listener.CloudListener;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.lease.ControlChange;
import org.dronemap.core.lease.ControlState;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.organisation.OrganisationId;
import org.junit.jupiter.api.Test;

class OperationLeasesTest extends OperationTestBase {
    private static final int DRONES = 16;

    /** In which order control changed in that way. */
    private record Changes(ControlChange.Kind kind, List<DroneId> drones) implements CloudListener {
        @Override
        public void controlChanged(DroneId drone, ControlState now, ControlChange change) {
            if (change.kind() == kind) {
                drones.add(drone);
            }
        }
    }

    @Test
    void takesAndReleasesDronesInTheOrderInWhichTheOperationNamesThem() {
        List<DroneId> named = new ArrayList<>(ofOneLane());
        Collections.reverse(named);
        Changes taken = changes(ControlChange.Kind.TAKEN);
        Changes released = changes(ControlChange.Kind.RELEASED);

        begin(named);
        await().until(() -> taken.drones().size() == named.size());
        assertThat(taken.drones()).containsExactlyElementsOf(named);
        wish("stop");

        await().until(() -> released.drones().size() == named.size());
        assertThat(released.drones()).containsExactlyElementsOf(named);
    }

    /** What changes on several lanes is told in any order. */
    private List<DroneId> ofOneLane() {
        List<DroneLink> links =
                IntStream.range(0, DRONES).mapToObj(this::callIn).toList();
        return links.stream()
                .filter(one -> one.lane().equals(links.get(0).lane()))
                .map(DroneLink::id)
                .toList();
    }

    private DroneLink callIn(int number) {
        DroneKey key = new DroneKey("127.0.0.1", 14_700 + number, 2 + number);
        return CloudFixtures.bound(cloud.admit(new Claim(
                new LinkSession(key, "udp", false, "ArduCopter " + number, new CloudFixtures.RecordingChannel()),
                CloudFixtures.copter(null),
                null,
                true,
                0)));
    }

    private Changes changes(ControlChange.Kind kind) {
        Changes changes = new Changes(kind, new CopyOnWriteArrayList<>());
        cloud.addListener(changes);
        return changes;
    }

    private void begin(List<DroneId> named) {
        SavedOperation begun = SavedOperation.begun(
                ID,
                ArmingOperation.KIND.name(),
                new SavedOperation.Owner("ann", "ann", OrganisationId.HOME),
                "a watch",
                Instant.now());
        var unused = operations.begin(ArmingOperation.KIND, begun, ArmingOperation.of(named.toArray(DroneId[]::new)));
    }
}
