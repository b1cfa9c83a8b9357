package org.dronemap.ws.testserver;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.http.HttpRequest;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.audit.AuditRecord;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.VehicleLog;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.session.FrameTap;
import tools.jackson.databind.JsonNode;

/** What is done with drones and what belongs to them, each with success. */
public final class DroneCalls extends SuccessfulCalls {
    private static final String CONTROL = "/control";
    private static final String PARAMETERS = "RTL_ALT,2000\n";
    private static final String ITEMS = "\"items\":[{\"type\":\"takeOff\",\"altitude\":20},"
            + "{\"type\":\"waypoint\",\"latitude\":47.3978,\"longitude\":8.5457,\"altitude\":20}]";
    private static final String ZONE =
            "{\"type\":\"Feature\",\"geometry\":{\"type\":\"Point\",\"coordinates\":[10.0,60.0]},\"properties\":"
                    + "{\"name\":\"%s\",\"kind\":\"exclusion\",\"radius\":50,\"ceiling\":100,\"altitudeReference\":\"home\"}}";
    private static final String FENCE =
            "{\"zones\":[{\"type\":\"circle\",\"inside\":true,\"center\":{\"latitude\":47.3977,\"longitude\":8.5456},"
                    + "\"radius\":500}]}";
    private static final String RALLY = "{\"points\":[{\"latitude\":47.3977,\"longitude\":8.5456,\"altitude\":30}]}";

    private final ScriptedVehicle vehicle;
    private final OrganisationMember other;
    private final OrganisationFixture estate;

    public DroneCalls(TestServer house, OrganisationFixture estate, OrganisationMember other) {
        super(house, estate.administrator());
        this.vehicle = estate.drone();
        this.other = other;
        this.estate = estate;
        drones();
        control();
        fences();
        parametersAndLogs();
        linkSecurity();
        missionsAndZones();
        virtualDrones();
        plans();
        recordings();
    }

    /** Of that drone, which nobody has control of. */
    private PreparedCall ofDrone(String method, String below, String body) {
        free();
        return deed(method, "drones/" + vehicle.id() + below, body);
    }

    private void free() {
        for (OrganisationMember one : List.of(root, other)) {
            one.http().send("/api/v1/drones/" + vehicle.id() + CONTROL, HttpRequest.Builder::DELETE);
        }
    }

    private void drones() {
        can("PATCH /api/v1/drones/{id}", () -> ofDrone("PATCH", "", "{\"name\":\"" + name() + "\"}"));
        can("DELETE /api/v1/drones/{id}", () -> deed("DELETE", "drones/" + played(), ""));
        can("POST /api/v1/drones/{id}/commands", () -> ofDrone("POST", "/commands?wait=20", "{\"type\":\"readHome\"}"));
        can(
                "POST /api/v1/commands",
                () -> deed(
                        "POST",
                        "commands?wait=20",
                        "{\"drones\":[\"" + vehicle.id() + "\"],\"command\":{\"type\":\"readHome\"}}"));
    }

    /** Of a replay of this organisation. */
    private String played() {
        String id = ScriptedVehicle.played(house.cloud(), 18_000 + house.number());
        house.grants().lend(new DroneId(id), OrganisationId.HOME);
        return id;
    }

    private void control() {
        can("POST /api/v1/drones/{id}/control/take", () -> ofDrone("POST", CONTROL + "/take", ""));
        can("POST /api/v1/drones/{id}/control/request", () -> {
            free();
            control(other, "take", "");
            return deed("POST", "drones/" + vehicle.id() + CONTROL + "/request", "{\"reason\":\"a survey\"}");
        });
        can("POST /api/v1/drones/{id}/control/grant", () -> asked("grant"));
        can("POST /api/v1/drones/{id}/control/refuse", () -> asked("refuse"));
        can("POST /api/v1/drones/{id}/control/hand-over", () -> asked("hand-over"));
        can("DELETE /api/v1/drones/{id}/control", () -> {
            free();
            control(root, "take", "");
            return deed("DELETE", "drones/" + vehicle.id() + CONTROL, "");
        });
        can("POST /api/v1/drones/{id}/control/take-over", () -> {
            free();
            control(other, "take", "");
            return deed("POST", "drones/" + vehicle.id() + CONTROL + "/take-over", "{\"reason\":\"smoke\"}");
        });
    }

    private PreparedCall asked(String action) {
        free();
        control(root, "take", "");
        control(other, "request", "{\"reason\":\"a survey\"}");
        return deed("POST", "drones/" + vehicle.id() + CONTROL + "/" + action, "{\"user\":\"" + other.name() + "\"}");
    }

    private void control(OrganisationMember who, String action, String body) {
        who.http().post("/api/v1/drones/" + vehicle.id() + CONTROL + "/" + action, body);
    }

    private void fences() {
        can("PUT /api/v1/drones/{id}/fence", () -> ofDrone("PUT", "/fence", FENCE));
        can("PUT /api/v1/drones/{id}/fence/zones", () -> {
            made("zones", String.format(ZONE, name()));
            return ofDrone("PUT", "/fence/zones", "");
        });
        can("DELETE /api/v1/drones/{id}/fence", () -> ofDrone("DELETE", "/fence", ""));
        can("POST /api/v1/drones/{id}/fence/refresh", () -> ofDrone("POST", "/fence/refresh", ""));
        can("PUT /api/v1/drones/{id}/rally-points", () -> ofDrone("PUT", "/rally-points", RALLY));
        can("DELETE /api/v1/drones/{id}/rally-points", () -> ofDrone("DELETE", "/rally-points", ""));
        can("POST /api/v1/drones/{id}/rally-points/refresh", () -> ofDrone("POST", "/rally-points/refresh", ""));
    }

    private void parametersAndLogs() {
        can("POST /api/v1/drones/{id}/parameters/refresh", () -> ofDrone("POST", "/parameters/refresh", ""));
        can(
                "PUT /api/v1/drones/{id}/parameters/{name}",
                () -> ofDrone("PUT", "/parameters/RTL_ALT", "{\"value\":2000}"));
        can(
                "POST /api/v1/drones/{id}/parameters/file",
                () -> ofDrone("POST", "/parameters/file", "").with("text/plain", PARAMETERS));
        can("POST /api/v1/drones/{id}/logs/refresh", () -> ofDrone("POST", "/logs/refresh", ""));
        can("POST /api/v1/drones/{id}/logs/{number}/download", () -> {
            list(7);
            return ofDrone("POST", "/logs/7/download", "");
        });
        can("DELETE /api/v1/drones/{id}/logs/{number}/file", () -> {
            list(8);
            fetched(8);
            return ofDrone("DELETE", "/logs/8/file", "");
        });
    }

    private void list(int number) {
        vehicle.says(new DroneEvent.LogsRead(List.of(new VehicleLog(number, null, 10))));
        ConditionWait.until(
                "the log is listed",
                () -> Optional.of(root.http().get("/api/v1/drones/" + vehicle.id() + "/logs"))
                        .filter(answer -> answer.raw().body().contains("\"number\":" + number)));
    }

    private void fetched(int number) {
        try {
            Path folder =
                    Files.createDirectories(house.data().resolve("vehicle-logs").resolve(vehicle.id()));
            Files.write(folder.resolve(number + "-0-10.log"), new byte[10]);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void linkSecurity() {
        String keys = "/link-key";
        can("PUT /api/v1/drones/{id}/link-security", () -> ofDrone("PUT", "/link-security", "{\"policy\":\"off\"}"));
        can("POST /api/v1/drones/{id}/link-key", () -> {
            ofDrone("DELETE", keys + "?vehicle=false", "").make();
            return ofDrone("POST", keys, "{}");
        });
        can("DELETE /api/v1/drones/{id}/link-key", () -> ofDrone("DELETE", keys + "?vehicle=false", ""));
        can("POST /api/v1/drones/{id}/link-key/install", () -> keyed("/install"));
        can("POST /api/v1/drones/{id}/link-key/rotate", () -> keyed("/rotate"));
    }

    private PreparedCall keyed(String change) {
        ofDrone("POST", "/link-key", "{}").make();
        return ofDrone("POST", "/link-key" + change, "{\"confirm\":true}");
    }

    private void missionsAndZones() {
        can("POST /api/v1/missions", () -> deed("POST", "missions", mission()));
        can("PUT /api/v1/missions/{id}", () -> deed("PUT", "missions/" + estate.fresh("missions"), mission()));
        can("DELETE /api/v1/missions/{id}", () -> deed("DELETE", "missions/" + estate.fresh("missions"), ""));
        can("POST /api/v1/zones", () -> deed("POST", "zones", String.format(ZONE, name())));
        can("POST /api/v1/zones/import", () -> deed("POST", "zones/import", String.format(ZONE, name())));
        can("PUT /api/v1/zones/{id}", () -> deed("PUT", "zones/" + estate.fresh("zones"), String.format(ZONE, name())));
        can("DELETE /api/v1/zones/{id}", () -> deed("DELETE", "zones/" + estate.fresh("zones"), ""));
    }

    private String mission() {
        return "{\"name\":\"" + name() + "\"," + ITEMS + "}";
    }

    private void virtualDrones() {
        String all = "virtual-drones/";
        can("POST /api/v1/virtual-drones", () -> deed("POST", "virtual-drones", mission()));
        can("PUT /api/v1/virtual-drones/{id}", () -> deed("PUT", all + virtual(), mission()));
        can("DELETE /api/v1/virtual-drones/{id}", () -> deed("DELETE", all + virtual(), ""));
        can("POST /api/v1/virtual-drones/{id}/start", () -> deed("POST", all + virtual() + "/start", "{}"));
        can("POST /api/v1/virtual-drones/{id}/stop", () -> {
            String id = virtual();
            deed("POST", all + id + "/start", "{}").make();
            return deed("POST", all + id + "/stop", "");
        });
        can("POST /api/v1/virtual-drones/{id}/resume", () -> deed("POST", all + suspended() + "/resume", ""));
        can("PUT /api/v1/warehouse/{id}", () -> deed("PUT", "warehouse/" + vehicle.id(), "{}"));
        can("DELETE /api/v1/warehouse/{id}", () -> {
            deed("PUT", "warehouse/" + vehicle.id(), "{}").make();
            return deed("DELETE", "warehouse/" + vehicle.id(), "");
        });
    }

    private String virtual() {
        return made("virtual-drones", mission());
    }

    /** One whose drone a supervisor has stopped. */
    private String suspended() {
        root.http()
                .get("/api/v1/virtual-drones")
                .json()
                .path("virtualDrones")
                .forEach(one -> deed("POST", "virtual-drones/" + one.path("id").asString() + "/stop", "")
                        .make());
        ImmediateCopter copter = new ImmediateCopter(
                house.cloud(),
                new DroneKey("127.0.0.1", 19_000 + house.number(), 1),
                name(),
                new Geodetic(47.3977, 8.5456));
        deed("PUT", "warehouse/" + copter.id(), "{}").make();
        String id = virtual();
        deed("POST", "virtual-drones/" + id + "/start", "{}").make();
        await(id, "flying");
        root.http().post("/api/v1/drones/" + copter.id() + "/commands?wait=20", "{\"type\":\"hold\"}");
        await(id, "suspended");
        return id;
    }

    private void await(String virtual, String state) {
        ConditionWait.until(
                "it is " + state,
                () -> Optional.of(root.http().get("/api/v1/virtual-drones/" + virtual))
                        .filter(answer -> answer.json()
                                .path("run")
                                .path("state")
                                .asString("")
                                .equals(state)));
    }

    private void plans() {
        can("POST /api/v1/plans", () -> deed("POST", "plans", plan()));
        can("DELETE /api/v1/plans/{id}", () -> deed("DELETE", "plans/" + planned(), ""));
        can("POST /api/v1/plans/{id}/accept", () -> deed("POST", "plans/" + planned() + "/accept?wait=20", "{}"));
        can("POST /api/v1/plans/{id}/stop", () -> deed("POST", "plans/" + waiting() + "/stop", ""));
        can(
                "POST /api/v1/tours",
                () -> deed("POST", "tours", "{\"drone\":\"" + copter().id() + "\",\"seconds\":0.1," + place() + "}"));
    }

    private String planned() {
        return planned(plan());
    }

    private String planned(String request) {
        String id = made("plans", request);
        ConditionWait.until(
                "the plan is finished",
                () -> Optional.of(root.http().get("/api/v1/plans/" + id))
                        .filter(answer -> answer.text("state").equals("finished")));
        return id;
    }

    /** Two that stand side by side: one of them has to leave later. */
    private String waiting() {
        String id = planned("{\"drones\":[\"" + copter().id() + "\",\"" + copter().id()
                + "\"],\"seconds\":0.1,\"objective\":{\"kind\":\"earliestEnd\",\"everyDrone\":true},\"waypoints\":["
                + "{\"latitude\":47.4077,\"longitude\":8.5456,\"altitude\":20},"
                + "{\"latitude\":47.4077,\"longitude\":8.5476,\"altitude\":20}]}");
        root.http().post("/api/v1/plans/" + id + "/accept", "{\"start\":true}");
        ConditionWait.until(
                "one of them waits, and the record that the other was told to start is written",
                () -> Optional.of(root.http().get("/api/v1/plans/" + id))
                        .filter(answer -> oneWaits(answer.json().path("launch").path("drones"))));
        return id;
    }

    private boolean oneWaits(JsonNode drones) {
        boolean waits = false;
        boolean told = false;
        for (JsonNode drone : drones) {
            waits |= drone.path("stage").asString("").equals("waiting");
            String command = drone.path("command").asString("");
            // It is the last command that a drone is told.
            told |= house.records().stream()
                    .map(AuditRecord::entry)
                    .anyMatch(entry ->
                            command.equals(entry.command()) && entry.operation().equals("startMission"));
        }
        return waits && told;
    }

    private String plan() {
        return "{\"drones\":[\"" + copter().id() + "\"],\"seconds\":0.1," + place() + "}";
    }

    private static String place() {
        return "\"waypoints\":[{\"latitude\":47.3979,\"longitude\":8.5456,\"altitude\":20}]";
    }

    private ImmediateCopter copter() {
        return new ImmediateCopter(
                        house.cloud(),
                        new DroneKey("127.0.0.1", 19_000 + house.number(), 1),
                        name(),
                        new Geodetic(47.3977, 8.5456))
                .wellHeard(house.cloud());
    }

    private void recordings() {
        can(
                "PATCH /api/v1/flights/{id}",
                () -> deed(
                        "PATCH", "flights/" + estate.thing("flights").orElseThrow(), "{\"notes\":\"" + name() + "\"}"));
        can("DELETE /api/v1/recordings/{id}", () -> deed("DELETE", "recordings/" + flown() + "?confirm=true", ""));
        can(
                "POST /api/v1/recordings/{id}/replays",
                () -> deed("POST", "recordings/" + estate.thing("recordings").orElseThrow() + "/replays", ""));
        can(
                "POST /api/v1/replays",
                () -> deed("POST", "replays?name=x.tlog", "").with("application/octet-stream", "a recording"));
        can("DELETE /api/v1/replays/{id}", () -> deed("DELETE", "replays/" + estate.fresh("replays"), ""));
    }

    /** The recording of a flight that has ended. */
    private String flown() {
        String drone =
                ScriptedVehicle.connect(house.cloud(), 19_000 + house.number()).id();
        FrameTap tap = house.recorder().open(1);
        tap.bound(new DroneId(drone));
        byte[] armed = new FrameWriter(1, 1, 2).frame(new Heartbeat(2, 3, 0x81, 4, 4, 3));
        new FrameReader().read(ByteBuffer.wrap(armed), tap::received);
        tap.ended();
        return ConditionWait.until(
                "the recording of " + drone,
                () -> Optional.of(root.http()
                                .get("/api/v1/recordings?drone=" + drone)
                                .json()
                                .path("recordings")
                                .path(0))
                        .filter(one -> one.has("id") && !one.path("end").isNull())
                        .map(one -> one.path("id").asString()));
    }
}
