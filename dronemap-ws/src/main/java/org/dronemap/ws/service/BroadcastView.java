package org.dronemap.ws.service;

import com.fasterxml.jackson.annotation.JsonIgnore;
import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** What becomes of one command for several drones: one result for each, in the order asked. */
@Schema(name = "BroadcastView")
public record BroadcastView(String id, List<Result> results) {
    /** The command as it stands for this drone, or the sentence why there is none. */
    @Schema(name = "BroadcastResult")
    public record Result(
            String drone,
            @Nullable String name,
            @Nullable CommandView command,
            @Nullable String problem) {}

    /** No drone's command is under way any more. */
    @JsonIgnore
    public boolean isEnded() {
        return results.stream()
                .allMatch(result -> result.command() == null || result.command().outcome() != null);
    }
}
