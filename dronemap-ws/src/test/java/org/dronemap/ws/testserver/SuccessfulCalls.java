package org.dronemap.ws.testserver;

import java.net.http.HttpRequest;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/** For operations of REST: how each is carried out with success, whatever happened before. */
public abstract class SuccessfulCalls {
    static final String JSON = "application/json";

    final TestServer house;
    final TestHttpClient nobody;
    final OrganisationMember root;
    private final Map<String, Supplier<PreparedCall>> recipes = new TreeMap<>();

    /** One call that is ready to be made; {@code cookie}: the session that it comes with. */
    public record PreparedCall(
            TestHttpClient who,
            String method,
            String path,
            String contentType,
            String body,
            @Nullable String cookie) {
        PreparedCall with(String type, String text) {
            return new PreparedCall(who, method, path, type, text, cookie);
        }

        PreparedCall inSession(String given) {
            return new PreparedCall(who, method, path, contentType, body, given);
        }

        /** The same with another body. */
        public PreparedCall saying(String text) {
            return with(contentType, text);
        }

        public TestHttpClient.Answer make() {
            return who.send(path, request -> {
                request.header("Content-Type", contentType)
                        .method(method, HttpRequest.BodyPublishers.ofString(method.equals("GET") ? "" : body));
                return cookie == null
                        ? request
                        : request.header("Cookie", cookie).header("X-Dronemap", "1");
            });
        }
    }

    SuccessfulCalls(TestServer house, OrganisationMember root) {
        this.house = house;
        this.root = root;
        this.nobody = new TestHttpClient(house, "");
    }

    /** Everything that it needs is made first. Empty: nobody knows how. */
    public Optional<PreparedCall> of(String operation) {
        return Optional.ofNullable(recipes.get(operation)).map(Supplier::get);
    }

    final void can(String operation, Supplier<PreparedCall> recipe) {
        if (recipes.put(operation, recipe) != null) {
            throw new IllegalStateException(operation + " is here twice");
        }
    }

    /** By the administrator, on that path below the version. */
    final PreparedCall deed(String method, String path, String body) {
        return new PreparedCall(root.http(), method, "/api/v1/" + path, JSON, body, null);
    }

    /** Makes a thing and says its id. */
    final String made(String path, String body) {
        return made(path, body, "id");
    }

    final String made(String path, String body, String member) {
        TestHttpClient.Answer answer = root.http().post("/api/v1/" + path, body);
        String id = answer.text(member);
        if (id.isEmpty()) {
            throw new IllegalStateException(path + ": " + answer.raw().body());
        }
        return id;
    }

    final String name() {
        return "thing" + house.number();
    }
}
