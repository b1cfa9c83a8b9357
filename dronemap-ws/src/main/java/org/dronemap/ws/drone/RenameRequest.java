package org.dronemap.ws.drone;

import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Size;
import org.jspecify.annotations.Nullable;

/** A request to give a drone another name. */
@Schema(name = "RenameRequest")
record RenameRequest(
        @Size(min = 1, max = DroneService.LONGEST_NAME) @Nullable
        String name) {}
