package org.dronemap.ws.testserver;

import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.geo.Geodetic;

/** What is done with drones that come home together, each with success. */
public final class RecoveryCalls extends SuccessfulCalls {
    public RecoveryCalls(TestServer house, OrganisationFixture estate) {
        super(house, estate.administrator());
        can("POST /api/v1/recoveries/preview", () -> deed("POST", "recoveries/preview", order()));
        can("POST /api/v1/recoveries", () -> deed("POST", "recoveries", order()));
        can(
                "POST /api/v1/recoveries/{id}/cancel",
                () -> deed("POST", "recoveries/" + made("recoveries", order()) + "/cancel", ""));
    }

    private String order() {
        ImmediateCopter copter = new ImmediateCopter(
                house.cloud(), new DroneKey("127.0.0.1", 18_600 + house.number(), 1), name(), new Geodetic(46.3, 7.6));
        copter.isAloft(house.cloud());
        return "{\"manner\":\"return\",\"drones\":[\"" + copter.id() + "\"]}";
    }
}
