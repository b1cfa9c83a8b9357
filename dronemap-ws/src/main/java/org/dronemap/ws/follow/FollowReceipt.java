package org.dronemap.ws.follow;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import org.dronemap.core.conduct.TargetReportResult;
import org.jspecify.annotations.Nullable;

/** The answer to positions that a followed phone has sent: up to which they are processed, and how many were new. */
@Schema(
        name = "FollowReceipt",
        description =
                "What became of the positions of one message. Keep those that it does not cover, and say them again.")
public record FollowReceipt(
        String follow,

        @Schema(description = "Positions up to this id are dealt with; null: none of them, the server is busy")
        @Nullable
        Long upTo,

        @Schema(description = "How many were new") int taken,

        @Schema(description = "How many had been said before, or are older than one that had been")
        int known,

        @Schema(description = "The time of the cloud") Instant at) {

    /** Counts while they are handed on one by one. */
    static final class Count {
        private int taken;
        private int known;
        private @Nullable Long upTo;

        /** False: it and those after it have to wait. */
        boolean add(long number, TargetReportResult reception) {
            if (reception == TargetReportResult.QUEUE_FULL) {
                return false;
            }
            if (reception == TargetReportResult.ACCEPTED) {
                taken++;
            } else {
                known++;
            }
            upTo = upTo == null ? number : Math.max(upTo, number);
            return true;
        }

        FollowReceipt receipt(String follow, Instant at) {
            return new FollowReceipt(follow, upTo, taken, known, at.truncatedTo(ChronoUnit.MILLIS));
        }
    }
}
