package org.dronemap.proxy.outlet.client;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import org.dronemap.core.access.OutletSystemId;
import org.dronemap.core.drone.DroneId;
import org.junit.jupiter.api.Test;

class SystemIdRegistryTest {
    private static final DroneId FIRST = new DroneId("drone-1");
    private static final DroneId SECOND = new DroneId("drone-2");

    private final List<OutletSystemId> kept = new ArrayList<>();

    @Test
    void aVehicleKeepsItsOwnNumberWhereThatIsFree() {
        OutletSystemIdRegistry numbers = new OutletSystemIdRegistry(List.of(), kept::add);
        assertThat(numbers.of("ann", FIRST, 7)).hasValue(7);
        assertThat(numbers.of("ann", SECOND, 7)).hasValue(1);
        assertThat(numbers.of("bob", SECOND, 7)).hasValue(7);
        assertThat(kept)
                .containsExactly(
                        new OutletSystemId("ann", FIRST, 7),
                        new OutletSystemId("ann", SECOND, 1),
                        new OutletSystemId("bob", SECOND, 7));
    }

    @Test
    void aNumberStaysWhateverTheVehicleCallsItselfLater() {
        OutletSystemIdRegistry numbers =
                new OutletSystemIdRegistry(List.of(new OutletSystemId("ann", FIRST, 9)), kept::add);
        assertThat(numbers.of("ann", FIRST, 1)).hasValue(9);
        assertThat(numbers.drone("ann", 9)).isEqualTo(FIRST);
        assertThat(numbers.drone("bob", 9)).isNull();
        assertThat(kept).isEmpty();
    }

    @Test
    void noTwoDronesShareANumberAndGroundStationsKeepTheirs() {
        OutletSystemIdRegistry numbers = new OutletSystemIdRegistry(List.of(), kept::add);
        Set<Integer> given = new HashSet<>();
        for (int index = 0; index < OutletSystemIdRegistry.HIGHEST; index++) {
            OptionalInt number = numbers.of("ann", new DroneId("drone-" + index), 255);
            assertThat(given.add(number.orElseThrow())).isTrue();
        }
        assertThat(given).allMatch(number -> number >= 1 && number <= OutletSystemIdRegistry.HIGHEST);
        assertThat(numbers.of("ann", new DroneId("one-more"), 3)).isEmpty();
    }

    @Test
    void theNumberOfADroneThatIsGoneIsFreeAgain() {
        OutletSystemIdRegistry numbers = new OutletSystemIdRegistry(List.of(), kept::add);
        assertThat(numbers.of("ann", FIRST, 1)).hasValue(1);
        numbers.forget(FIRST);
        assertThat(numbers.drone("ann", 1)).isNull();
        assertThat(numbers.of("ann", SECOND, 1)).hasValue(1);
    }
}
