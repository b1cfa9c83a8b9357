package org.dronemap.ws.testserver;

import java.net.http.HttpRequest;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.geo.Geodetic;

/** What is done with drones that are sent, each with success. */
public final class DispatchCalls extends SuccessfulCalls {
    public DispatchCalls(TestServer house, OrganisationFixture estate) {
        super(house, estate.administrator());
        can("POST /api/v1/dispatches", () -> deed("POST", "dispatches", order()));
        can(
                "POST /api/v1/dispatches/{id}/cancel",
                () -> deed("POST", "dispatches/" + made("dispatches", order()) + "/cancel", ""));
    }

    private String order() {
        ImmediateCopter copter = new ImmediateCopter(
                        house.cloud(),
                        new DroneKey("127.0.0.1", 18_500 + house.number(), 1),
                        name(),
                        // Far from all others, so that it serves nobody else.
                        new Geodetic(46.2, 7.5))
                .wellHeard(house.cloud());
        root.http()
                .send(
                        "/api/v1/warehouse/" + copter.id(),
                        request -> request.header("Content-Type", "application/json")
                                .PUT(HttpRequest.BodyPublishers.ofString("{}")));
        return "{\"latitude\":46.2,\"longitude\":7.5,\"height\":20}";
    }
}
