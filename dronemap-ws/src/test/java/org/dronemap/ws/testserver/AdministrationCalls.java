package org.dronemap.ws.testserver;

import java.net.URI;
import java.net.http.HttpRequest;
import org.dronemap.core.access.Role;
import org.dronemap.core.organisation.OrganisationId;

/** What is done about accounts, rights, organisations, links and the server, each with success. */
public final class AdministrationCalls extends SuccessfulCalls {
    private static final String PASSWORD = "a long enough one";

    private final FakeOidcProvider provider;
    private final String owner;

    public AdministrationCalls(TestServer house, OrganisationMember root, FakeOidcProvider provider) {
        super(house, root);
        this.provider = provider;
        owner = root.name();
        sessions();
        keys();
        robotKeys();
        users();
        groups();
        organisations();
        server();
    }

    private void sessions() {
        can(
                "POST /api/v1/registrations",
                () -> new PreparedCall(nobody, "POST", "/api/v1/registrations", JSON, credentials(name()), null));
        can(
                "POST /api/v1/session",
                () -> new PreparedCall(nobody, "POST", "/api/v1/session", JSON, credentials(user()), null));
        can("GET /api/v1/session/oidc/callback", this::comingBack);
        can("DELETE /api/v1/session", () -> session("DELETE", "/api/v1/session", ""));
        can(
                "POST /api/v1/session/password",
                () -> session(
                        "POST",
                        "/api/v1/session/password",
                        "{\"current\":\"" + PASSWORD + "\",\"next\":\"another long one\"}"));
        can(
                "POST /api/v1/session/sign-out-everywhere",
                () -> session("POST", "/api/v1/session/sign-out-everywhere", ""));
        can("POST /api/v1/stream-tickets", () -> deed("POST", "stream-tickets", ""));
    }

    private PreparedCall session(String method, String path, String body) {
        String cookie = cookie(nobody.post("/api/v1/session", credentials(user())));
        return new PreparedCall(nobody, method, path, JSON, body, null).inSession(cookie);
    }

    private PreparedCall comingBack() {
        TestHttpClient.Answer there = nobody.get("/api/v1/session/oidc");
        URI address = URI.create(there.raw().headers().firstValue("Location").orElseThrow());
        String path = "/api/v1/session/oidc/callback?" + provider.visit(address);
        return new PreparedCall(nobody, "GET", path, JSON, "", cookie(there));
    }

    private static String cookie(TestHttpClient.Answer answer) {
        return answer.raw().headers().firstValue("Set-Cookie").orElseThrow().split(";", 2)[0];
    }

    private static String credentials(String name) {
        return "{\"name\":\"" + name + "\",\"password\":\"" + PASSWORD + "\"}";
    }

    private String user() {
        String name = name();
        return made(
                "users", "{\"name\":\"" + name + "\",\"role\":\"operator\",\"password\":\"" + PASSWORD + "\"}", "name");
    }

    private void keys() {
        can("POST /api/v1/access-keys", () -> deed("POST", "access-keys", "{\"label\":\"a key\",\"role\":\"viewer\"}"));
        can("POST /api/v1/access-keys/{id}/renew", () -> deed("POST", "access-keys/" + key() + "/renew", ""));
        can("DELETE /api/v1/access-keys/{id}", () -> deed("DELETE", "access-keys/" + key(), ""));
        can("POST /api/v1/invitations", () -> deed("POST", "invitations", "{\"label\":\"x\",\"role\":\"viewer\"}"));
        can(
                "DELETE /api/v1/invitations/{id}",
                () -> deed(
                        "DELETE", "invitations/" + made("invitations", "{\"label\":\"x\",\"role\":\"viewer\"}"), ""));
        can("PUT /api/v1/outlet/passphrase", () -> deed("PUT", "outlet/passphrase", "{}"));
        can("DELETE /api/v1/outlet/passphrase", () -> deed("DELETE", "outlet/passphrase", ""));
        can("POST /api/v1/outlet/ports", () -> {
            closePorts();
            return deed("POST", "outlet/ports", "{\"address\":\"192.0.2.7\"}");
        });
        can("DELETE /api/v1/outlet/ports/{id}", () -> {
            closePorts();
            return deed("DELETE", "outlet/ports/" + made("outlet/ports", "{\"address\":\"192.0.2.7\"}"), "");
        });
        can("DELETE /api/v1/outlet/clients/{id}", () -> deed("DELETE", "outlet/clients/client-1", ""));
        can("POST /api/v1/dtls-keys", () -> deed("POST", "dtls-keys", "{\"label\":\"a copter\"}"));
        can(
                "DELETE /api/v1/dtls-keys/{identity}",
                () -> deed("DELETE", "dtls-keys/" + made("dtls-keys", "{\"label\":\"a copter\"}", "identity"), ""));
    }

    /** A user may have few of them, and each deed may be done more than once. */
    private void closePorts() {
        root.http()
                .get("/api/v1/outlet")
                .json()
                .path("ports")
                .forEach(port -> root.http()
                        .send("/api/v1/outlet/ports/" + port.path("id").asString(), HttpRequest.Builder::DELETE));
    }

    private void robotKeys() {
        String body = "{\"label\":\"a robot\",\"systemId\":7,\"owner\":\"26\"}";
        can("POST /api/v1/robot-keys", () -> deed("POST", "robot-keys", body));
        can("DELETE /api/v1/robot-keys/{id}", () -> deed("DELETE", "robot-keys/" + made("robot-keys", body), ""));
    }

    private String key() {
        return made("access-keys", "{\"label\":\"a key\",\"role\":\"viewer\"}");
    }

    private void users() {
        can(
                "POST /api/v1/users",
                () -> deed(
                        "POST",
                        "users",
                        "{\"name\":\"" + name() + "\",\"role\":\"viewer\",\"password\":\"" + PASSWORD + "\"}"));
        can("PATCH /api/v1/users/{name}", () -> deed("PATCH", "users/" + user(), "{\"role\":\"viewer\"}"));
        can("DELETE /api/v1/users/{name}", () -> deed("DELETE", "users/" + user(), ""));
        can("POST /api/v1/users/{name}/password", () -> deed("POST", "users/" + user() + "/password", ""));
        can(
                "DELETE /api/v1/users/{name}/access-keys/{id}",
                () -> deed("DELETE", "users/" + owner + "/access-keys/" + key(), ""));
        can("POST /api/v1/users/{name}/sign-out", () -> deed("POST", "users/" + user() + "/sign-out", ""));
        can(
                "PUT /api/v1/users/{name}/only-granted",
                () -> deed("PUT", "users/" + user() + "/only-granted", "{\"onlyGranted\":true}"));
    }

    private void groups() {
        can("POST /api/v1/groups", () -> deed("POST", "groups", named()));
        can("PUT /api/v1/groups/{id}", () -> deed("PUT", "groups/" + made("groups", named()), named()));
        can("DELETE /api/v1/groups/{id}", () -> deed("DELETE", "groups/" + made("groups", named()), ""));
        can(
                "PUT /api/v1/groups/{id}/only-granted",
                () -> deed("PUT", "groups/" + made("groups", named()) + "/only-granted", "{\"onlyGranted\":true}"));
        can("POST /api/v1/fleets", () -> deed("POST", "fleets", named()));
        can("PUT /api/v1/fleets/{id}", () -> deed("PUT", "fleets/" + made("fleets", named()), named()));
        can("DELETE /api/v1/fleets/{id}", () -> deed("DELETE", "fleets/" + made("fleets", named()), ""));
        can("POST /api/v1/grants", () -> deed("POST", "grants", grant()));
        can("DELETE /api/v1/grants/{id}", () -> deed("DELETE", "grants/" + made("grants", grant()), ""));
    }

    private String named() {
        return "{\"name\":\"" + name() + "\"}";
    }

    private String grant() {
        return "{\"user\":\"" + user() + "\",\"all\":true,\"operations\":[\"view\"]}";
    }

    private void organisations() {
        can("POST /api/v1/organisations", () -> deed("POST", "organisations", named()));
        can(
                "PATCH /api/v1/organisations/{id}",
                () -> deed("PATCH", "organisations/" + made("organisations", named()), named()));
        can(
                "DELETE /api/v1/organisations/{id}",
                () -> deed("DELETE", "organisations/" + made("organisations", named()), ""));
        can("PUT /api/v1/organisations/{id}/drones/{drone}", () -> deed("PUT", drone(), "{\"histories\":true}"));
        can("DELETE /api/v1/organisations/{id}/drones/{drone}", () -> {
            String given = drone();
            deed("PUT", given, "").make();
            return deed("DELETE", given, "");
        });
    }

    private String drone() {
        return "organisations/" + made("organisations", named()) + "/drones/"
                + ScriptedVehicle.connect(house.cloud(), 16000 + house.number()).id();
    }

    private void server() {
        can("POST /api/v1/endpoints", () -> deed("POST", "endpoints", url()));
        can("DELETE /api/v1/endpoints/{id}", () -> deed("DELETE", "endpoints/" + made("endpoints", url()), ""));
        can("POST /api/v1/waiting/{id}/enrol", () -> deed("POST", "waiting/" + stranger() + "/enrol", "{}"));
        can("DELETE /api/v1/waiting/{id}", () -> deed("DELETE", "waiting/" + stranger(), ""));
        can("POST /api/v1/backup", () -> deed("POST", "backup", ""));
        can("POST /api/v1/audit/verification", () -> deed("POST", "audit/verification", ""));
    }

    private String url() {
        return "{\"url\":\"udpserver://127.0.0.1:" + (20_000 + house.number()) + "\"}";
    }

    /** A vehicle that nobody vouches for, which has to wait. */
    private String stranger() {
        return ScriptedVehicle.stranger(house.cloud(), 17_000 + house.number());
    }

    /** Somebody of the server's own organisation who may command. */
    public static OrganisationMember operator(TestServer house, String name) {
        return house.member(OrganisationId.HOME, name, Role.OPERATOR);
    }
}
