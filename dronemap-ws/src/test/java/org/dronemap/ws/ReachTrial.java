package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.dronemap.core.access.Role;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.core.parameter.Parameter;
import org.dronemap.core.parameter.ParameterType;
import org.dronemap.ws.testserver.ExposedOperations;
import org.dronemap.ws.testserver.OrganisationFixture;
import org.dronemap.ws.testserver.OrganisationMember;
import org.dronemap.ws.testserver.ResourceScopeTable;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.SharedServer;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.TestInstance;

/**
 * A house with two organisations that have one thing of each kind, somebody in each role in both, and what it takes to try
 * all that the running server exposes.
 */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
abstract class ReachTrial {
    static final String ABSENT = "absent-thing";
    private static final String GIVEN = " /api/v1/organisations/{id}/drones/{drone}";
    final Map<Role, OrganisationMember> ours = new EnumMap<>(Role.class);
    final Map<Role, OrganisationMember> theirs = new EnumMap<>(Role.class);
    final List<String> wrong = new ArrayList<>();
    TestServer house;
    ExposedOperations faces;
    ResourceScopeTable whose;
    OrganisationFixture own;
    /** Another one of our own. */
    ScriptedVehicle spare;

    OrganisationFixture foreign;
    private String foreignId;

    @BeforeAll
    void open() {
        house = SharedServer.get();
        faces = new ExposedOperations(house);
        whose = new ResourceScopeTable();
        ScriptedVehicle ourDrone = vehicle();
        ScriptedVehicle theirDrone = vehicle();
        spare = vehicle();
        TestHttpClient root = new TestHttpClient(house, house.key(Role.ADMINISTRATOR));
        foreignId = root.post("/api/v1/organisations", "{\"name\":\"Mountain rescue " + house.number() + "\"}")
                .text("id");
        String given = "/api/v1/organisations/" + foreignId + "/drones/" + theirDrone.id();
        assertThat(put(root, given, "").status()).isEqualTo(200);
        own = new OrganisationFixture(house, "our" + house.number(), OrganisationId.HOME, ourDrone);
        foreign = new OrganisationFixture(house, "their" + house.number(), new OrganisationId(foreignId), theirDrone);
        for (Role role : Role.values()) {
            ours.put(role, own.member(role.name(), role));
            theirs.put(role, foreign.member(role.name(), role));
        }
    }

    @AfterEach
    void forgetWhatWasWrong() {
        wrong.clear();
    }

    void judge(String cell, boolean promised, TestHttpClient.Answer answer) {
        boolean closed = answer.status() == 401 || answer.status() == 403;
        if (closed == promised || answer.status() == 404 || answer.status() >= 500) {
            wrong.add(cell + ": " + answer.status() + " " + answer.raw().body());
        }
    }

    /** The same answer as for what is not there. */
    void alike(OrganisationMember caller, String operation, String thing) {
        TestHttpClient.Answer there = rest(caller, operation, thing);
        TestHttpClient.Answer absent = rest(caller, operation, ABSENT);
        if (!isSame(there, thing, absent)) {
            wrong.add(operation + " for " + caller.name() + " tells " + thing + " from an absent one: "
                    + there.raw().body() + " / " + absent.raw().body());
        }
    }

    static boolean isSame(TestHttpClient.Answer there, String thing, TestHttpClient.Answer absent) {
        return there.status() == absent.status()
                && there.raw().body().replace(thing, ABSENT).equals(absent.raw().body());
    }

    void silent(String cell, TestHttpClient.Answer answer, OrganisationFixture other) {
        silent(cell, answer.raw().body(), other);
    }

    void silent(String cell, String body, OrganisationFixture other) {
        if (body.contains(other.word() + "-")
                || body.matches("(?s).*[\">]" + other.drone().id() + "[\"<].*")) {
            wrong.add(cell + ": " + body);
        }
    }

    TestHttpClient.Answer rest(OrganisationMember caller, String operation, String thing) {
        return faces.rest(caller.http(), operation, values(operation, thing));
    }

    private Map<String, String> values(String operation, String thing) {
        if (operation.endsWith(GIVEN)) {
            return Map.of("id", foreignId, "drone", thing);
        }
        return operation.contains("/users/")
                // What is of a user: the key that each member has.
                ? Map.of("name", thing, "id", "key-" + thing)
                : Map.of("id", thing, "identity", thing);
    }

    /** The same call as {@link #rest} of the operation that it is there. */
    String soap(OrganisationMember caller, String operation, String thing) {
        return faces.soapAsRest(caller.http(), operation, values(faces.restOf(operation), thing))
                .raw()
                .body();
    }

    /** What an address is about: the word after the version. */
    static String kind(String operation) {
        boolean ofDrone = operation.endsWith(GIVEN) || operation.contains(" /api/v1/warehouse/");
        return ofDrone
                ? "drones"
                : operation.replaceFirst("\\S+ /(api/v1/)?", "").split("/")[0];
    }

    static boolean isTakingBack(String operation) {
        return operation.equals("DELETE" + GIVEN);
    }

    /** Not what would take the caller's own key or the drone away, nor what is one user's alone. */
    boolean isTried(String operation) {
        return !operation.endsWith(GIVEN)
                && !kind(operation).matches("access-keys|virtual-drones|plans|runs|follows|dispatches|recoveries");
    }

    String ownThing(String operation) {
        String kind = kind(operation);
        return operation.startsWith("DELETE ") && operation.endsWith("}") && !kind.matches("drones|recordings|commands")
                ? own.fresh(kind)
                : own.thing(kind).orElseThrow();
    }

    static TestHttpClient.Answer put(TestHttpClient http, String path, String body) {
        return http.send(
                path,
                request -> request.header("Content-Type", "application/json")
                        .PUT(HttpRequest.BodyPublishers.ofString(body)));
    }

    ScriptedVehicle vehicle() {
        ScriptedVehicle vehicle = ScriptedVehicle.connect(house.cloud(), 20_000 + house.number());
        vehicle.says(new DroneEvent.ParametersRead(List.of(new Parameter("RTL_ALT", ParameterType.INT16, 1500))));
        return vehicle;
    }

    /** {@link #judge} of an answer of SOAP. */
    void judgeSoap(String cell, boolean promised, String answer) {
        String wrongWith = ExposedOperations.wrong(answer);
        boolean closed = wrongWith.matches("not-signed-in|forbidden");
        if (closed == promised || wrongWith.matches("unknown|internal") || answer.contains("Server</faultcode>")) {
            wrong.add(cell + ": " + answer);
        }
    }

    void alikeInSoap(OrganisationMember caller, String operation, String thing) {
        String there = soap(caller, operation, thing);
        String absent = soap(caller, operation, ABSENT);
        if (!there.replace(thing, ABSENT).equals(absent)) {
            wrong.add(operation + " for " + caller.name() + ": " + there + " / " + absent);
        }
    }
}
