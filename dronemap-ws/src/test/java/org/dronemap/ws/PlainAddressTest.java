package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.dronemap.ws.testserver.ExposedOperations;
import org.dronemap.ws.testserver.RawClient;
import org.dronemap.ws.testserver.SharedServer;
import org.dronemap.ws.testserver.TestServer;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** No route is reached by an address that is written in another way than the one that requests are judged by. */
class PlainAddressTest {
    private static TestServer house;

    @BeforeAll
    static void open() {
        house = SharedServer.get();
    }

    private static String statusOf(String method, String address) {
        try (RawClient client = new RawClient(house.httpPort())) {
            client.say(method + " " + address + " HTTP/1.1\r\nHost: localhost\r\nContent-Length: 0\r\n"
                    + "Connection: close\r\n\r\n");
            String line = client.hearLine();
            return line.substring(line.indexOf(' ') + 1, line.indexOf(' ') + 4);
        }
    }

    /** The same place for a server that decodes and tidies addresses. */
    private static List<String> otherWaysTo(String address) {
        List<String> ways = new ArrayList<>();
        String[] parts = address.substring(1).split("/");
        for (int part = 0; part < parts.length; part++) {
            for (String other : List.of(
                    "%" + Integer.toHexString(parts[part].charAt(0)) + parts[part].substring(1),
                    parts[part] + ";a=b",
                    parts[part] + "%3b",
                    "/" + parts[part],
                    "./" + parts[part],
                    "%2e/" + parts[part],
                    "x/../" + parts[part],
                    "x/%2E%2e/" + parts[part],
                    "..%2f" + parts[part])) {
                String[] changed = parts.clone();
                changed[part] = other;
                ways.add("/" + String.join("/", changed));
            }
        }
        return ways;
    }

    @Test
    void noRouteIsReachedOnAnotherWay() {
        ExposedOperations faces = new ExposedOperations(house);
        Set<String> routes = new TreeSet<>(faces.rest());
        faces.services().forEach(service -> routes.add("POST " + service));
        routes.add("GET /api/openapi.json");
        List<String> reached = new ArrayList<>();
        for (String route : routes) {
            String address = route.substring(route.indexOf(' ') + 1).replaceAll("\\{\\w+}", "a");
            for (String way : otherWaysTo(address)) {
                // Asked in a way that leaves no record: of what strangers may not do, so many are written down and no
                // more.
                String status = statusOf("GET", way);
                if (!status.equals("400")) {
                    reached.add(way + " is answered " + status);
                }
            }
        }

        assertThat(reached).isEmpty();
        assertThat(routes).hasSizeGreaterThan(100);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "/api/v1/users/a%20b",
                "/api/v1/users/%C3%A4",
                "/api/v1/users/a%3Ab%40c",
                "/api/v1/users/a:b@c,d",
                "/api/v1/users/100%25"
            })
    void namesWithOtherLettersAreWrittenAsTheyMustBe(String address) {
        assertThat(statusOf("DELETE", address)).isEqualTo("401");
    }

    @Test
    void whatASignInIsJudgedByIsWhatItReaches() {
        assertThat(statusOf("POST", "/%61pi/v1/session")).isEqualTo("400");
        assertThat(statusOf("POST", "/api/v1/session;a")).isEqualTo("400");
        assertThat(statusOf("POST", "/%73ervices/MAVLinkControllerService")).isEqualTo("400");
    }
}
