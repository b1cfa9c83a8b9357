package org.dronemap.ws.command;

import com.fasterxml.jackson.annotation.JsonFormat;
import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Pattern;
import jakarta.validation.constraints.Size;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** One command for several drones as a client writes it. Nothing is checked yet. */
@Schema(name = "BroadcastRequest", description = "One command for several drones.")
public record BroadcastRequest(
        @Schema(
                description = "Ids of the drones, or all of them by \"all\" alone",
                requiredMode = Schema.RequiredMode.REQUIRED,
                example = "[\"all\"]")
        @JsonFormat(with = JsonFormat.Feature.ACCEPT_SINGLE_VALUE_AS_ARRAY)
        @Size(min = 1, max = BroadcastService.MOST_DRONES)
        @Nullable
        List<@Nullable String> drones,

        @Schema(requiredMode = Schema.RequiredMode.REQUIRED) @Nullable
        CommandRequest command,

        @Schema(description = "Your own id (8 to 36 of A-Z a-z 0-9 _ -): the same id twice acts once on each drone")
        @Pattern(regexp = BroadcastService.ID)
        @Nullable
        String id) {}
