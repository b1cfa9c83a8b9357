package org.dronemap.ws.access;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.dronemap.ws.violation.HandlerViolations;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.springframework.mock.web.MockHttpServletRequest;
import org.springframework.mock.web.MockHttpServletResponse;
import org.springframework.web.method.HandlerMethod;

class RestOperationsTest {
    private final RestOperations operations = HandlerCatalogue.of(HandlerViolations.Careful.class);

    @ParameterizedTest
    @CsvSource({
        "GET,    /api/v1/door/open,  ANYBODY,       SIGN_IN, ONLY_LOOKS,          GET /api/v1/door/open",
        "HEAD,   /api/v1/door/open,  ANYBODY,       SIGN_IN, ONLY_LOOKS,          GET /api/v1/door/open",
        "POST,   /api/v1/door,       ANYBODY,       SIGN_IN, RECORDED_WITH_PLACE, POST /api/v1/door",
        "GET,    /api/v1/things/a-b, VIEWER,        REQUEST, RECORDED,            GET /api/v1/things/{id}",
        "DELETE, /api/v1/things/a-b, ADMINISTRATOR, EXPORT,  RECORDED,            DELETE /api/v1/things/{id}",
        "DELETE, /api/v1/things/all, SUPERVISOR,    NOTHING, LEFT_OUT,            DELETE /api/v1/things/all"
    })
    void findsWhatTheHandlerSays(
            String method, String path, AccessLevel from, RequestCost costs, AuditPolicy audit, String name) {
        AccessRule rule = rule(method, path);

        assertThat(withoutOperation(rule)).isEqualTo(new AccessRule(from, costs, audit, null));
        assertThat(nameOf(rule.operation())).isEqualTo(name);
    }

    @ParameterizedTest
    @CsvSource({
        "PUT,     /api/v1/door/open,  ANYBODY,   SIGN_IN, RECORDED",
        "PUT,     /api/v1/door,       SIGNED_IN, REQUEST, RECORDED",
        "POST,    /api/v1/things/all, VIEWER,    REQUEST, RECORDED",
        "OPTIONS, /api/v1/things/a-b, VIEWER,    REQUEST, ONLY_LOOKS",
        "POST,    /api/v1/nowhere,    VIEWER,    REQUEST, RECORDED",
        "GET,     /api/v1/nowhere,    VIEWER,    REQUEST, ONLY_LOOKS"
    })
    void isAsClosedToOtherMethodsAsAnAddressIsToLookAt(
            String method, String path, AccessLevel from, RequestCost costs, AuditPolicy audit) {
        assertThat(rule(method, path)).isEqualTo(new AccessRule(from, costs, audit, null));
    }

    @Test
    void namesTheHandlerThatDoesNotSayWhoMayCallIt() {
        RestOperations forgetful = HandlerCatalogue.of(HandlerViolations.Forgetful.class);

        assertThatThrownBy(forgetful::afterSingletonsInstantiated)
                .hasMessage(
                        "The handler org.dronemap.ws.violation.HandlerViolations$Forgetful.forgotten has no @Access; say"
                                + " there who may call it, and what it is about.");
    }

    @Test
    void letsNoHandlerRunThatWasNotJudged() throws NoSuchMethodException {
        HandlerMatchInterceptor same = new HandlerMatchInterceptor(operations);
        HandlerMethod remove = new HandlerMethod(new HandlerViolations.Careful(), "remove");
        MockHttpServletResponse response = new MockHttpServletResponse();

        assertThat(same.preHandle(new MockHttpServletRequest("DELETE", "/api/v1/things/a-b"), response, remove))
                .isTrue();
        assertThatThrownBy(() ->
                        same.preHandle(new MockHttpServletRequest("DELETE", "/api/v1/things/all"), response, remove))
                .hasMessageContaining("judged as one for DELETE /api/v1/things/all");
        assertThatThrownBy(() -> same.preHandle(new MockHttpServletRequest("GET", "/api/v1/nowhere"), response, remove))
                .hasMessageContaining("judged as one for nothing");
    }

    private AccessRule rule(String method, String path) {
        return operations.rule(new MockHttpServletRequest(method, path));
    }

    private static AccessRule withoutOperation(AccessRule rule) {
        return new AccessRule(rule.from(), rule.costs(), rule.audit(), null);
    }

    private static String nameOf(@Nullable RestOperation operation) {
        return operation == null ? "" : operation.name();
    }
}
