package org.dronemap.ws.command;

import com.fasterxml.jackson.annotation.JsonIgnore;
import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import java.util.Map;
import org.dronemap.ws.problem.ProblemView;
import org.dronemap.ws.problem.Rejection;
import org.jspecify.annotations.Nullable;

/** The outcome of one command for several drones: one result for each, in the order asked. */
@Schema(name = "BroadcastView")
public record BroadcastView(String id, List<Result> results) {
    /** The command as it stands for this drone, or why there is none. */
    @Schema(name = "BroadcastResult")
    public record Result(
            String drone,
            @Nullable String name,
            @Nullable CommandView command,
            @Nullable String problem,

            @Schema(description = "The same for programs; docs/problems.md lists them") @Nullable
            String code,

            @Schema(
                    description =
                            "What the problem is about; which of them come with which code, docs/problems.md tells")
            @Nullable
            Map<String, Object> parameters) {

        static Result given(String drone, @Nullable String name, CommandView command) {
            return new Result(drone, name, command, null, null, null);
        }

        static Result refused(String drone, @Nullable String name, Rejection why) {
            return new Result(drone, name, null, why.sentence(), why.code().word(), ProblemView.values(why));
        }
    }

    /** No drone's command is under way any more. */
    @JsonIgnore
    public boolean isEnded() {
        return results.stream()
                .allMatch(result -> result.command() == null || result.command().outcome() != null);
    }
}
