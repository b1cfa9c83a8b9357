package org.dronemap.core.conduct;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.core.operation.OperationObservation;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.core.separation.GiveWay;
import org.dronemap.core.separation.SeparationBoard;
import org.dronemap.core.time.RealTime;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** What an operation is shown of its drones, and its people with it. */
class ObservationBuilderTest extends OperationTestBase {
    private static final DroneId OTHER = new DroneId("drone-of-others");

    private final SeparationBoard board = new SeparationBoard();

    private @Nullable GiveWay seen(Set<DroneId> own) {
        DroneId drone = cloud.drones().get(0).id();
        GiveWay give = new GiveWay(OTHER, "Falcon", GiveWay.Manner.MOVE, Instant.EPOCH, false, "climbs 6 m");
        board.publish(Map.of(drone, give), Map.of());
        DroneGateway gateway = new DroneGateway(cloud, Operations.FACE);
        SavedOperation saved = SavedOperation.begun(
                ID,
                ArmingOperation.KIND.name(),
                new SavedOperation.Owner("ann", "ann", OrganisationId.HOME),
                "a watch",
                Instant.EPOCH);
        LeaseHolder.Operation holder = new LeaseHolder.Operation(ID.value(), saved.owner(), "A watch");
        ObservationBuilder builder =
                new ObservationBuilder(cloud, gateway, (owner, one) -> Optional.empty(), board, new RealTime());
        OperationObservation scene = builder.observe(saved, new OperationLeases(gateway, holder), own);
        return scene.of(drone).orElseThrow().giveWay();
    }

    /** Users of an operation may not know of drones that are none of its own; what it saw is in its journal. */
    @Test
    void namesNoDroneOfOthers() {
        DroneId drone = cloud.drones().get(0).id();
        GiveWay give = Objects.requireNonNull(seen(Set.of(drone)));
        assertThat(give.toString()).doesNotContain(OTHER.value()).doesNotContain("Falcon");
        assertThat(give.words()).isEqualTo("climbs 6 m");
        assertThat(Objects.requireNonNull(seen(Set.of(drone, OTHER))).toName()).isEqualTo("Falcon");
    }
}
