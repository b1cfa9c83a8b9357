package org.dronemap.ws.recording;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * A recording being played back, as clients see it.
 *
 * @param progress 0 to 1
 * @param failure the sentence when the state is failed
 */
@Schema(name = "ReplayView")
public record ReplayView(
        String id,
        String name,
        double speed,
        List<String> drones,

        @Schema(allowableValues = {"running", "finished", "cancelled", "failed"})
        String state,

        long records,
        long goodMessages,
        long brokenRuns,
        long brokenBytes,
        double progress,
        @Nullable String failure) {}
