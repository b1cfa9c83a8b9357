package org.dronemap.ws.follow;

import com.fasterxml.jackson.annotation.JsonTypeName;
import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.List;
import org.dronemap.core.access.Principal;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.stream.StreamAccessRule;
import org.dronemap.ws.stream.StreamConnection;
import org.dronemap.ws.stream.StreamMessage;
import org.dronemap.ws.stream.StreamOperation;
import org.dronemap.ws.stream.StreamRequest;
import org.dronemap.ws.stream.StreamRequestType;
import org.jspecify.annotations.Nullable;
import org.springframework.core.annotation.Order;

/** Receives the positions of followed phones on the WebSocket stream. Any thread. */
final class PositionsStreamOperation {
    private final FollowService follows;
    private final PhoneReachability phones;

    @JsonTypeName("positions")
    @Schema(
            name = "StreamPositionsRequest",
            description = "Where a followed phone was, oldest first, once a second. Times are by its own clock.")
    record ReportPositions(
            @Nullable String requestId,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "The id of a follow") @Nullable
            String follow,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "When this is sent") @Nullable
            Instant sent,

            @Schema(description = "Milliseconds from sending one to its answer, as measured lately") @Nullable
            Double roundTrip,

            @Schema(
                    requiredMode = Schema.RequiredMode.REQUIRED,
                    description = "Up to 60. None: the phone is there, and does not know where it is")
            @Nullable
            List<FollowRequest.@Nullable PositionRequest> positions)
            implements StreamRequest.OfUseCase {}

    @JsonTypeName("positionsHeard")
    @Order(620)
    @Schema(name = "StreamPositionsHeard", description = "Answers positions.")
    record PositionsReceived(@Nullable String requestId, FollowReceipt receipt) implements StreamMessage.OfUseCase {}

    private PositionsStreamOperation(FollowService follows, PhoneReachability phones) {
        this.follows = follows;
        this.phones = phones;
    }

    static StreamOperation<ReportPositions> of(FollowService follows, PhoneReachability phones) {
        return StreamOperation.of(
                new StreamRequestType<>(
                        ReportPositions.class,
                        new StreamAccessRule.OfOperation<>("reportFollowPositions"),
                        PositionsReceived.class),
                new PositionsStreamOperation(follows, phones)::receive);
    }

    private PositionsReceived receive(StreamConnection connection, Principal principal, ReportPositions request) {
        String follow = request.follow();
        if (follow == null) {
            throw InvalidInput.missing("follow", "the id of a follow");
        }
        FollowRequest.PositionsRequest report =
                new FollowRequest.PositionsRequest(request.sent(), request.roundTrip(), request.positions());
        FollowReceipt receipt = follows.positions(principal, follow, report);
        phones.received(connection, receipt.follow());
        return new PositionsReceived(request.requestId(), receipt);
    }
}
