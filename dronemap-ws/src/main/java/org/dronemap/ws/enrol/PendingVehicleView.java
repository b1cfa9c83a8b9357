package org.dronemap.ws.enrol;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import org.dronemap.core.access.Principal;
import org.dronemap.core.cloud.WaitingVehicle;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/** A vehicle that waits to be enrolled as a drone, as administrators see it. */
@Schema(
        name = "WaitingView",
        description = "A vehicle that nobody has let in: nothing is sent to it but the question who it is.")
public record PendingVehicleView(
        String id,

        @Schema(
                description = "quarantined: it says that it is a drone which it does not prove to be",
                allowableValues = {"unknown", "quarantined"})
        String reason,

        @Nullable String claims,
        String why,
        String address,
        int port,
        int systemId,
        String transport,
        @EnumValues(VehicleKind.class) String kind,
        String autopilot,
        String vehicle,
        @Nullable String firmware,
        @Nullable String hardwareId,
        Instant since,
        Instant lastHeard) {
    /** A drone that it says it is only for those who see that drone. */
    static PendingVehicleView of(WaitingVehicle waiting, Principal principal) {
        DroneId claims = waiting.claims();
        return new PendingVehicleView(
                waiting.id(),
                waiting.isQuarantined() ? "quarantined" : "unknown",
                claims == null || !principal.sees(claims) ? null : claims.value(),
                waiting.why(),
                waiting.key().address(),
                waiting.key().port(),
                waiting.key().systemId(),
                waiting.transport(),
                WireNames.camel(waiting.identification().kind()),
                waiting.identification().autopilot(),
                waiting.identification().vehicle(),
                waiting.identification().firmware(),
                waiting.identification().hardwareUid(),
                waiting.since().truncatedTo(ChronoUnit.MILLIS),
                waiting.lastHeard().truncatedTo(ChronoUnit.MILLIS));
    }
}
