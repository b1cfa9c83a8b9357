package org.dronemap.ws.service;

import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Size;
import org.jspecify.annotations.Nullable;

/** What a client says about the control of a drone; which members are needed depends on what it is. */
@Schema(
        name = "ControlRequestView",
        description = "What goes with it; which members are needed depends on what is done.")
public record ControlRequestView(
        @Schema(description = "takeOver (needed), request, refuse: at most 200 characters")
        @Size(max = ControlService.LONGEST_REASON)
        @Nullable
        String reason,

        @Schema(description = "grant, refuse, hand-over: the name of the user") @Nullable
        String user,

        @Schema(description = "heartbeat: of the control that was taken") @Nullable
        Long epoch) {
    /** Nothing goes with it. */
    public static final ControlRequestView NOTHING = new ControlRequestView(null, null, null);
}
