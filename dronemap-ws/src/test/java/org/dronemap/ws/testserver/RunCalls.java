package org.dronemap.ws.testserver;

import java.util.Optional;
import java.util.function.Predicate;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.geo.Geodetic;

/** What is done with mission runs, each with success. */
public final class RunCalls extends SuccessfulCalls {
    private static final String WAYPOINT = "{\"latitude\":47.3979,\"longitude\":8.5456,\"altitude\":20}";
    private static final String BARRIER =
            "{\"type\":\"Feature\",\"geometry\":{\"type\":\"Point\",\"coordinates\":[8.56,47.41]},\"properties\":"
                    + "{\"name\":\"crane\",\"radius\":20}}";

    /** A run under way, and its drone. */
    private record Started(String id, ImmediateCopter copter) {
        String path(String below) {
            return "runs/" + id + below;
        }
    }

    public RunCalls(TestServer house, OrganisationFixture estate) {
        super(house, estate.administrator());
        can("POST /api/v1/runs", () -> deed("POST", "runs", order(planned(copter()), "automatic")));
        can("POST /api/v1/runs/{id}/waypoints", () -> deed("POST", started().path("/waypoints"), waypoints()));
        can(
                "PATCH /api/v1/runs/{id}/waypoints/{waypoint}",
                () -> deed("PATCH", started().path("/waypoints/1"), "{\"altitude\":25}"));
        can(
                "DELETE /api/v1/runs/{id}/waypoints/{waypoint}",
                () -> deed("DELETE", started().path("/waypoints/1"), ""));
        can("POST /api/v1/runs/{id}/barriers", () -> deed("POST", started().path("/barriers"), BARRIER));
        can(
                "POST /api/v1/runs/{id}/drones",
                () -> deed("POST", started().path("/drones"), "{\"drone\":\"" + copter().id() + "\"}"));
        can("POST /api/v1/runs/{id}/drones/{drone}/resume", this::resume);
        can("POST /api/v1/runs/{id}/drones/{drone}/give-up", () -> {
            Started run = started();
            return deed("POST", run.path("/drones/" + run.copter().id() + "/give-up"), "");
        });
        can("POST /api/v1/runs/{id}/answers/{proposal}", this::answer);
        can("POST /api/v1/runs/{id}/pause", () -> deed("POST", started().path("/pause"), ""));
        can("POST /api/v1/runs/{id}/continue", () -> {
            Started run = started();
            root.http().post("/api/v1/" + run.path("/pause"), "");
            return deed("POST", run.path("/continue"), "");
        });
        can("POST /api/v1/runs/{id}/stop", () -> deed("POST", started().path("/stop"), ""));
    }

    /** Somebody took it and gave it back: it waits for this. */
    private PreparedCall resume() {
        Started run = started();
        String control = "/api/v1/drones/" + run.copter().id() + "/control";
        root.http().post(control + "/take-over", "{\"reason\":\"a look\"}");
        await(run, answer -> answer.raw().body().contains("\"suspended\""));
        return deed("POST", run.path("/drones/" + run.copter().id() + "/resume"), "");
    }

    private PreparedCall answer() {
        Started run = started("askFirst");
        root.http().post("/api/v1/" + run.path("/waypoints"), waypoints());
        TestHttpClient.Answer asks =
                await(run, answer -> answer.json().path("proposal").has("number"));
        String number = asks.json().path("proposal").path("number").asString();
        return deed("POST", run.path("/answers/" + number), "{\"accept\":true}");
    }

    private TestHttpClient.Answer await(Started run, Predicate<TestHttpClient.Answer> what) {
        return ConditionWait.until(
                "the run goes on",
                () -> Optional.of(root.http().get("/api/v1/" + run.path(""))).filter(what));
    }

    private Started started() {
        return started("automatic");
    }

    private Started started(String mode) {
        ImmediateCopter copter = copter();
        return new Started(made("runs", order(planned(copter), mode)), copter);
    }

    private static String order(String plan, String mode) {
        return "{\"plan\":\"" + plan + "\",\"mode\":\"" + mode + "\",\"name\":\"roofs\"}";
    }

    private static String waypoints() {
        return "{\"waypoints\":[" + WAYPOINT + "]}";
    }

    private String planned(ImmediateCopter copter) {
        String id = made(
                "plans", "{\"drones\":[\"" + copter.id() + "\"],\"seconds\":0.1,\"waypoints\":[" + WAYPOINT + "]}");
        ConditionWait.until(
                "the plan is finished",
                () -> Optional.of(root.http().get("/api/v1/plans/" + id))
                        .filter(answer -> answer.text("state").equals("finished")));
        return id;
    }

    private ImmediateCopter copter() {
        return new ImmediateCopter(
                        house.cloud(),
                        new DroneKey("127.0.0.1", 19_000 + house.number(), 1),
                        name(),
                        new Geodetic(47.3977, 8.5456))
                .wellHeard(house.cloud());
    }
}
