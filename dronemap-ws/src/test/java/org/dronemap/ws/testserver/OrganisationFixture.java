package org.dronemap.ws.testserver;

import java.nio.ByteBuffer;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.session.FrameTap;
import tools.jackson.databind.JsonNode;

/** One thing of each kind that belongs to an organisation; all that people gave names has its word in them. */
public final class OrganisationFixture {
    private static final String ZONE =
            "{\"type\":\"Feature\",\"geometry\":{\"type\":\"Point\",\"coordinates\":[10.0,60.0]},\"properties\":"
                    + "{\"name\":\"%s\",\"kind\":\"exclusion\",\"radius\":50,\"drone\":\"%s\"}}";

    private final TestServer house;
    private final String word;
    private final OrganisationId organisation;
    private final ScriptedVehicle drone;
    private final OrganisationMember administrator;
    private final AtomicInteger numbers = new AtomicInteger();
    private final Map<String, String> things = new LinkedHashMap<>();

    public OrganisationFixture(TestServer house, String word, OrganisationId organisation, ScriptedVehicle drone) {
        this.house = house;
        this.word = word;
        this.organisation = organisation;
        this.drone = drone;
        this.administrator = house.member(organisation, word + "-root", Role.ADMINISTRATOR);
        fly();
        for (String kind : new String[] {
            "commands",
            "recordings",
            "flights",
            "replays",
            "missions",
            "zones",
            "users",
            "invitations",
            "robot-keys",
            "groups",
            "fleets",
            "grants",
            "virtual-drones"
        }) {
            things.put(kind, fresh(kind));
        }
        things.put("drones", drone.id());
        things.put("access-keys", "key-" + administrator.name());
    }

    public OrganisationMember member(String name, Role role) {
        return house.member(organisation, word + "-" + name, role);
    }

    public OrganisationMember administrator() {
        return administrator;
    }

    public ScriptedVehicle drone() {
        return drone;
    }

    public String word() {
        return word;
    }

    /** What the address of that kind of things calls one of this organisation's. */
    public Optional<String> thing(String kind) {
        return Optional.ofNullable(things.get(kind));
    }

    /** A new one. */
    public String fresh(String kind) {
        String name = word + "-" + kind + "-" + numbers.incrementAndGet();
        TestHttpClient http = administrator.http();
        String at = "/api/v1/" + kind;
        return switch (kind) {
            case "commands" -> id(http.post("/api/v1/drones/" + drone.id() + "/commands", "{\"type\":\"readHome\"}"));
            case "recordings" -> recording();
            case "flights" -> flight();
            case "replays" -> id(http.post("/api/v1/recordings/" + recording() + "/replays", ""));
            case "missions" ->
                id(http.post(at, "{\"name\":\"" + name + "\",\"items\":[{\"type\":\"takeOff\",\"altitude\":20}]}"));
            case "zones" -> id(http.post(at, String.format(ZONE, name, drone.id())));
            case "users" -> house.member(organisation, name, Role.VIEWER).name();
            case "invitations" -> id(http.post(at, "{\"label\":\"" + name + "\",\"role\":\"viewer\"}"));
            case "robot-keys" -> id(http.post(at, "{\"label\":\"" + name + "\",\"systemId\":7}"));
            case "groups", "fleets", "virtual-drones" -> id(http.post(at, "{\"name\":\"" + name + "\"}"));
            case "grants" ->
                id(http.post(at, "{\"user\":\"" + administrator.name() + "\",\"all\":true,\"operations\":[\"view\"]}"));
            default -> throw new IllegalArgumentException(kind);
        };
    }

    private static String id(TestHttpClient.Answer made) {
        String id = made.text("id");
        if (id.isEmpty()) {
            throw new IllegalStateException(made.raw().uri() + ": " + made.raw().body());
        }
        return id;
    }

    private void fly() {
        FrameTap tap = house.recorder().open(1);
        tap.bound(new DroneId(drone.id()));
        byte[] heartbeat = new FrameWriter(1, 1, 2).frame(new Heartbeat(2, 3, 0x81, 4, 4, 3));
        new FrameReader().read(ByteBuffer.wrap(heartbeat), tap::received);
    }

    private String flight() {
        String path = "/api/v1/flights?drone=" + drone.id();
        int before = administrator.http().get(path).json().path("flights").size();
        drone.says(new DroneEvent.ModeReported("GUIDED", true));
        drone.says(new DroneEvent.ModeReported("GUIDED", false));
        return ConditionWait.until("the flight of " + drone.id(), () -> {
            JsonNode all = administrator.http().get(path).json().path("flights");
            return all.size() > before
                    ? Optional.ofNullable(all.path(0).path("id").asString(null))
                    : Optional.empty();
        });
    }

    private String recording() {
        return ConditionWait.until("the recording of " + drone.id(), () -> {
            JsonNode all = administrator
                    .http()
                    .get("/api/v1/recordings?drone=" + drone.id())
                    .json();
            return Optional.ofNullable(all.path("recordings").path(0).path("id").asString(null));
        });
    }
}
