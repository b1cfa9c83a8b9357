package org.dronemap.ws.dispatch;

import com.fasterxml.jackson.annotation.JsonTypeName;
import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.dronemap.cognitive.operation.dispatch.DispatchLeg;
import org.dronemap.cognitive.operation.dispatch.DispatchState;
import org.dronemap.core.conduct.Operations.Snapshot;
import org.dronemap.core.drone.DroneId;
import org.dronemap.ws.stream.StreamMessage;
import org.dronemap.ws.stream.StreamTopic;
import org.dronemap.ws.stream.StreamTopicRate;
import org.dronemap.ws.stream.delivery.StreamEventRouter;
import org.jspecify.annotations.Nullable;
import org.springframework.core.annotation.Order;

/** Stream topics about drones that were sent: their changes, and what changes all the time. */
final class DispatchStreamTopics {
    private static final StreamTopicRate.Newest FOUR_A_SECOND = new StreamTopicRate.Newest(4);
    private static final StreamTopicRate.Newest ONCE_A_SECOND = new StreamTopicRate.Newest(1);
    private static final String AUDIENCE = "its owner, and in the organisation whoever sees all of its drones";

    private DispatchStreamTopics() {}

    @JsonTypeName("dispatch")
    @Order(630)
    @Schema(
            name = "StreamDispatchChanged",
            description = "A drone that was sent; all that are under way once after hello, then when one changes.")
    record DispatchChanged(DispatchView dispatch) implements StreamMessage.OfUseCase {}

    @JsonTypeName("dispatchNow")
    @Order(640)
    @Schema(
            name = "StreamDispatchNow",
            description = "The part of a dispatch that changes all the time; null: nothing is known of it now.")
    record DispatchNow(String id, DispatchView.@Nullable NowView now) implements StreamMessage.OfUseCase {}

    static StreamTopic<Snapshot<DispatchState>> changes(DispatchService dispatches) {
        return new StreamTopic<>(
                DispatchChanged.class,
                FOUR_A_SECOND,
                new StreamTopic.SubjectMapping<>(
                        "dispatch", dispatch -> dispatch.saved().id().value()),
                StreamTopic.Audience.of(AUDIENCE, DispatchService::isShownTo),
                (dispatch, who) -> new DispatchChanged(dispatches.view(dispatch)),
                dispatches::underWay,
                null,
                feed -> dispatches.addListener(
                        (operation, why) -> feed.changed(operation.id().value(), () -> dispatches.picture(operation))));
    }

    static StreamTopic<Snapshot<DispatchState>> now(DispatchService dispatches, StreamEventRouter news) {
        return new StreamTopic<>(
                DispatchNow.class,
                ONCE_A_SECOND,
                new StreamTopic.SubjectMapping<>(
                        "dispatchNow", dispatch -> dispatch.saved().id().value()),
                StreamTopic.Audience.of(AUDIENCE, DispatchService::isShownTo),
                (dispatch, who) -> new DispatchNow(
                        dispatch.saved().id().value(), dispatches.view(dispatch).now()),
                List::of,
                null,
                feed -> news.onMoves(drones -> dispatches.underWay().stream()
                        .filter(dispatch -> leads(dispatch.state(), drones::contains))
                        .forEach(
                                dispatch -> feed.changed(dispatch.saved().id().value(), () -> Optional.of(dispatch)))));
    }

    private static boolean leads(DispatchState state, Predicate<DroneId> moved) {
        DispatchLeg lead = state.lead();
        return lead != null && moved.test(lead.drone());
    }
}
