package org.dronemap.ws.testserver;

import java.util.Optional;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.geo.Geodetic;

/** What is done with follows, each with success. */
public final class FollowCalls extends SuccessfulCalls {
    public FollowCalls(TestServer house, OrganisationFixture estate) {
        super(house, estate.administrator());
        can("POST /api/v1/follows", () -> deed("POST", "follows", order()));
        can("PATCH /api/v1/follows/{id}", () -> deed("PATCH", opened(), "{\"distance\":20}"));
        can("POST /api/v1/follows/{id}/start", () -> deed("POST", opened() + "/start", ""));
        can("POST /api/v1/follows/{id}/cancel", () -> deed("POST", opened() + "/cancel", ""));
        can("POST /api/v1/follows/{id}/pause", () -> deed("POST", following() + "/pause", ""));
        can("POST /api/v1/follows/{id}/continue", () -> {
            String follow = following();
            root.http().post("/api/v1/" + follow + "/pause", "");
            return deed("POST", follow + "/continue", "");
        });
        can("POST /api/v1/follows/{id}/stop", () -> deed("POST", following() + "/stop", ""));
    }

    private String following() {
        String follow = opened();
        root.http().post("/api/v1/" + follow + "/start", "");
        ConditionWait.until(
                "the drone follows",
                () -> Optional.of(root.http().get("/api/v1/" + follow))
                        .filter(answer -> answer.text("state").equals("tracking")));
        return follow;
    }

    private String opened() {
        return "follows/" + made("follows", order());
    }

    private String order() {
        ImmediateCopter copter = new ImmediateCopter(
                        house.cloud(),
                        new DroneKey("127.0.0.1", 18_000 + house.number(), 1),
                        name(),
                        new Geodetic(47.3977, 8.5456))
                .wellHeard(house.cloud());
        return "{\"latitude\":47.3978,\"longitude\":8.5457,\"drone\":\"" + copter.id() + "\"}";
    }
}
