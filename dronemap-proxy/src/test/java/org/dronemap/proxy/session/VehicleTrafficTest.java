package org.dronemap.proxy.session;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.junit.jupiter.api.Test;

class VehicleTrafficTest {
    private static final DroneKey KEY = new DroneKey("127.0.0.1", 5760, 1);

    @Test
    void addsUpTheSessionsOfAVehicleThatConnectedAgain() {
        VehicleTraffic broken = new VehicleTraffic(KEY, "tcp", new DroneId("d1"), 100, 50, 4, 3, 2, 1);
        VehicleTraffic fresh = new VehicleTraffic(KEY, "tcp", null, 10, 5, 4, 3, 2, 1);

        assertThat(fresh.and(broken)).isEqualTo(new VehicleTraffic(KEY, "tcp", new DroneId("d1"), 110, 55, 8, 6, 4, 2));
    }
}
