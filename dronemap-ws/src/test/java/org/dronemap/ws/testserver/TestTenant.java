package org.dronemap.ws.testserver;

import java.net.http.HttpRequest;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.access.KeyRights;
import org.dronemap.core.access.KeyScope;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.organisation.OrganisationId;

/**
 * An organisation on the shared server, with users and drones that no other test has. What it began is stopped, and its drones
 * are on the ground, once it is closed.
 */
public final class TestTenant implements AutoCloseable {
    private static final int FIRST_PORT = 20_000;

    private final TestServer server = SharedServer.get();
    private final OrganisationId organisation;
    private final List<ScriptedVehicle> vehicles = new ArrayList<>();
    private final List<ImmediateCopter> copters = new ArrayList<>();

    public TestTenant() {
        TestHttpClient.Answer made = SharedServer.administrator()
                .post("/api/v1/organisations", "{\"name\":\"Tenant " + server.number() + "\"}");
        if (made.status() != 201) {
            throw new IllegalStateException(made.raw().body());
        }
        organisation = new OrganisationId(made.text("id"));
    }

    public TestServer server() {
        return server;
    }

    public OrganisationId organisation() {
        return organisation;
    }

    /** An access key of a new user with this role. */
    public String key(Role role) {
        return key(new KeyRights(role, KeyScope.ALL, null));
    }

    /** An access key with these rights, of a new user with their role. */
    public String key(KeyRights rights) {
        return server.key(organisation, rights);
    }

    /** As a new user with this role. */
    public TestHttpClient http(Role role) {
        return new TestHttpClient(server, key(role));
    }

    /** A new user whose name begins like this. */
    public OrganisationMember member(String name, Role role) {
        return server.member(organisation, unique(name), role);
    }

    /** A name that nobody else has and that begins like this. */
    public String unique(String name) {
        return name + "-" + server.number();
    }

    /** A vehicle in contact that does as the test says. */
    public ScriptedVehicle vehicle() {
        ScriptedVehicle vehicle = ScriptedVehicle.connect(server.cloud(), FIRST_PORT + server.number());
        vehicles.add(vehicle);
        own(vehicle.id());
        return vehicle;
    }

    /** A copter that does what it is told, and stands there. */
    public ImmediateCopter copter(String name, Geodetic stand) {
        DroneKey key = new DroneKey("10.9.8.7", FIRST_PORT + server.number(), 1);
        ImmediateCopter copter = new ImmediateCopter(server.cloud(), key, name, stand);
        copters.add(copter);
        own(copter.id());
        return copter;
    }

    private void own(String drone) {
        HttpRequest.BodyPublisher all = HttpRequest.BodyPublishers.ofString("{\"histories\":true}");
        TestHttpClient.Answer given = SharedServer.administrator()
                .send(
                        "/api/v1/organisations/" + organisation.value() + "/drones/" + drone,
                        request -> request.header("Content-Type", "application/json")
                                .PUT(all));
        if (given.status() != 200) {
            throw new IllegalStateException(given.raw().body());
        }
    }

    @Override
    public void close() {
        if (!copters.isEmpty()) {
            TestHttpClient supervisor = http(Role.SUPERVISOR);
            for (String kind : List.of("runs", "follows", "virtual-drones")) {
                end(supervisor, "/api/v1/" + kind, "stop");
            }
            end(supervisor, "/api/v1/dispatches", "cancel");
            end(supervisor, "/api/v1/recoveries", "cancel");
            copters.forEach(ImmediateCopter::isOnGround);
        }
        for (ScriptedVehicle vehicle : vehicles) {
            vehicle.says(new DroneEvent.PhaseReported(FlightPhase.ON_GROUND));
            vehicle.says(new DroneEvent.ModeReported("GUIDED", false));
        }
    }

    private static void end(TestHttpClient supervisor, String path, String how) {
        // The one member of each list is named after what it lists.
        supervisor
                .get(path)
                .json()
                .valueStream()
                .forEach(list -> list.forEach(one -> {
                    String id = one.path("id").asString("");
                    supervisor.post(path + "/" + id + "/" + how, "");
                }));
    }
}
