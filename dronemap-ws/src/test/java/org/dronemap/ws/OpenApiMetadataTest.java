package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import org.dronemap.ws.testserver.SharedServer;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tools.jackson.databind.JsonNode;

/** What OpenAPI tells of the addresses is what they take. */
class OpenApiMetadataTest {
    private static final Set<String> METHODS = Set.of("get", "post", "put", "patch", "delete");

    private static TestServer house;
    private static JsonNode description;

    @BeforeAll
    static void open() {
        house = SharedServer.get();
        description = new TestHttpClient(house, "").get("/api/openapi.json").json();
    }

    /** Schemas go by the names of classes: two of one name would be one schema. */
    @ParameterizedTest
    @CsvSource({
        "/api/v1/access-keys, label role operations drones area floor ceiling altitudeReference days",
        "/api/v1/dtls-keys, label drone",
        "/api/v1/drones/{id}/link-key, key",
        "/api/v1/users, name role password",
        "/api/v1/endpoints, url"
    })
    void describesEachRequestByItsOwnMembers(String path, String members) {
        String schema = description
                .path("paths")
                .path(path)
                .path("post")
                .path("requestBody")
                .path("content")
                .path("application/json")
                .path("schema")
                .path("$ref")
                .asString("");
        JsonNode properties = description
                .path("components")
                .path("schemas")
                .path(schema.substring(schema.lastIndexOf('/') + 1))
                .path("properties");

        assertThat(properties.propertyNames()).containsExactlyInAnyOrderElementsOf(List.of(members.split(" ")));
    }

    /** springdoc makes names of methods unique by numbers, which change with every method that is added. */
    @Test
    void namesEachOperationByAVerbAndANameOfItsOwn() {
        description
                .path("paths")
                .forEachEntry((path, operations) -> operations.forEachEntry((method, operation) -> {
                    if (METHODS.contains(method)) {
                        assertThat(operation.path("operationId").asString(""))
                                .as(method + " " + path)
                                .matches("[a-z]+([A-Z][a-z]+)*");
                    }
                }));
    }

    @Test
    void hasASummaryForEachAddress() {
        JsonNode paths = description.path("paths");

        assertThat(paths.size()).isGreaterThan(40);
        paths.forEachEntry((path, operations) -> operations.forEachEntry((method, operation) -> {
            if (METHODS.contains(method)) {
                assertThat(operation.path("summary").asString(""))
                        .as(method + " " + path)
                        .isNotEmpty();
            }
        }));
    }
}
