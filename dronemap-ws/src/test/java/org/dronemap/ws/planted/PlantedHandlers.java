package org.dronemap.ws.planted;

import org.dronemap.ws.access.About;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.Audit;
import org.dronemap.ws.access.Cost;
import org.dronemap.ws.access.From;
import org.springframework.web.bind.annotation.DeleteMapping;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RestController;

/** Handlers made up for tests. */
public final class PlantedHandlers {
    private PlantedHandlers() {}

    /** One of them does not say who may call it. */
    @RestController
    public static class Forgetful {
        @GetMapping("/api/v1/planted")
        @Access(from = From.VIEWER, about = About.NONE)
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
        @Access(from = From.ANYBODY, about = About.NONE, costs = Cost.SIGN_IN)
        public String open() {
            return "seen";
        }

        @GetMapping("/api/v1/door")
        @Access(from = From.SIGNED_IN, about = About.OWN)
        public String own() {
            return "seen";
        }

        @PostMapping("/api/v1/door")
        @Access(from = From.ANYBODY, about = About.NONE, costs = Cost.SIGN_IN, audit = Audit.RECORDED_WITH_PLACE)
        public String enter() {
            return "done";
        }

        @GetMapping("/api/v1/things/{id}")
        @Access(from = From.VIEWER, about = About.SHARED, audit = Audit.RECORDED)
        public String look() {
            return "seen";
        }

        @DeleteMapping("/api/v1/things/{id}")
        @Access(from = From.ADMINISTRATOR, about = About.SERVER, costs = Cost.EXPORT)
        public String remove() {
            return "done";
        }

        @DeleteMapping("/api/v1/things/all")
        @Access(from = From.SUPERVISOR, about = About.ORGANISATION, costs = Cost.NOTHING, audit = Audit.LEFT_OUT)
        public String removeAll() {
            return "done";
        }
    }
}
