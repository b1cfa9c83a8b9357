package org.dronemap.proxy.outlet;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import org.dronemap.proxy.outlet.client.OutletStatus;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** A program that somebody disconnected. */
class DisconnectedClientTest {
    private final OutletTestBench house = new OutletTestBench();

    DisconnectedClientTest() throws IOException {}

    @AfterEach
    void close() throws IOException {
        house.close();
    }

    @Test
    void itsUserStaysOutsideFromThereByWhateverPortAndNobodyElseDoes() {
        OutletTestBench.Station ann = house.new Station("ann", 255);
        OutletTestBench.Station bob = house.new Station("bob", 255);
        Outlet outlet = house.outlet();
        assertThat(outlet.status().clients())
                .as("both hear the vehicle")
                .extracting(OutletStatus.Client::user)
                .containsExactly("ann", "bob");
        String id = outlet.status().clients().stream()
                .filter(client -> client.user().equals("ann"))
                .findFirst()
                .orElseThrow()
                .id();
        assertThat(outlet.disconnect(id)).isTrue();
        house.await(() -> outlet.status().clients().size() == 1, "it is not disconnected");
        long before = outlet.status().refused().turnedAway();
        MatrixClient elsewhere = new MatrixClient(outlet, "ann", 254);
        elsewhere.says(OutletTestBench.GROUND);
        ann.says(OutletTestBench.GROUND);
        house.await(() -> outlet.status().refused().turnedAway() >= before + 2, "it is let in");
        assertThat(elsewhere.seesAVehicle()).isFalse();
        bob.says(OutletTestBench.GROUND);
        assertThat(outlet.status().clients())
                .extracting(OutletStatus.Client::user)
                .containsExactly("bob");
    }
}
