package org.dronemap.ws.testserver;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.function.UnaryOperator;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Speaks to a test house's HTTP port with one access key, or as nobody. */
public final class TestHttpClient {
    /** Costs threads and time to make: all share one. */
    private static final HttpClient CLIENT = HttpClient.newHttpClient();

    private final JsonMapper json = new JsonMapper();
    private final String base;
    private final String key;

    /** An answer: its status, its headers, its body as text and as JSON. */
    public record Answer(HttpResponse<String> raw, JsonNode json) {
        public int status() {
            return raw.statusCode();
        }

        public String text(String field) {
            return json.path(field).asString("");
        }
    }

    public TestHttpClient(TestServer house, String key) {
        this.base = "http://127.0.0.1:" + house.httpPort();
        this.key = key;
    }

    /** The header of HTTP Basic. */
    public static String basic(String name, String password) {
        byte[] both = (name + ":" + password).getBytes(StandardCharsets.UTF_8);
        return "Basic " + Base64.getEncoder().encodeToString(both);
    }

    public Answer get(String path) {
        return send(path, HttpRequest.Builder::GET);
    }

    public Answer post(String path, String body) {
        return send(
                path,
                builder -> builder.header("Content-Type", "application/json")
                        .POST(HttpRequest.BodyPublishers.ofString(body)));
    }

    public Answer send(String path, UnaryOperator<HttpRequest.Builder> how) {
        HttpRequest.Builder builder = HttpRequest.newBuilder(URI.create(base + path));
        if (!key.isEmpty()) {
            builder.header("Authorization", "Bearer " + key);
        }
        try {
            HttpRequest request = how.apply(builder).build();
            HttpResponse<String> response = CLIENT.send(request, HttpResponse.BodyHandlers.ofString());
            DeclaredStatuses.check(request.method(), request.uri().getRawPath(), response.statusCode());
            boolean isJson = response.headers()
                    .firstValue("Content-Type")
                    .map(type -> type.contains("json") && !type.contains("jsonl"))
                    .orElse(false);
            return new Answer(response, isJson ? json.readTree(response.body()) : json.createObjectNode());
        } catch (IOException e) {
            throw new IllegalStateException(e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException(e);
        }
    }
}
