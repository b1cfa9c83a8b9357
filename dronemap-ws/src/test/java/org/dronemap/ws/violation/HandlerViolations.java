package org.dronemap.ws.violation;

import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.AuditPolicy;
import org.dronemap.ws.access.RequestCost;
import org.dronemap.ws.access.ResourceScope;
import org.springframework.web.bind.annotation.DeleteMapping;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RestController;

/** Handlers made up for tests. */
public final class HandlerViolations {
    private HandlerViolations() {}

    /** One of them does not say who may call it. */
    @RestController
    public static class Forgetful {
        @GetMapping("/api/v1/planted")
        @Access(from = AccessLevel.VIEWER, about = ResourceScope.NONE)
        public String look() {
            return "seen";
        }

        @PostMapping("/api/v1/planted")
        public String forgotten() {
            return "done";
        }
    }

    /** All of them do. */
    @RestController
    public static class Careful {
        @GetMapping("/api/v1/door/open")
        @Access(from = AccessLevel.ANYBODY, about = ResourceScope.NONE, costs = RequestCost.SIGN_IN)
        public String open() {
            return "seen";
        }

        @GetMapping("/api/v1/door")
        @Access(from = AccessLevel.SIGNED_IN, about = ResourceScope.OWN)
        public String own() {
            return "seen";
        }

        @PostMapping("/api/v1/door")
        @Access(
                from = AccessLevel.ANYBODY,
                about = ResourceScope.NONE,
                costs = RequestCost.SIGN_IN,
                audit = AuditPolicy.RECORDED_WITH_PLACE)
        public String enter() {
            return "done";
        }

        @GetMapping("/api/v1/things/{id}")
        @Access(from = AccessLevel.VIEWER, about = ResourceScope.SHARED, audit = AuditPolicy.RECORDED)
        public String look() {
            return "seen";
        }

        @DeleteMapping("/api/v1/things/{id}")
        @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.SERVER, costs = RequestCost.EXPORT)
        public String remove() {
            return "done";
        }

        @DeleteMapping("/api/v1/things/all")
        @Access(
                from = AccessLevel.SUPERVISOR,
                about = ResourceScope.ORGANISATION,
                costs = RequestCost.NOTHING,
                audit = AuditPolicy.LEFT_OUT)
        public String removeAll() {
            return "done";
        }
    }
}
