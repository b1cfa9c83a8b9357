package org.dronemap.ws.follow;

import com.fasterxml.jackson.annotation.JsonTypeName;
import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import java.util.Optional;
import org.dronemap.cognitive.operation.follow.FollowState;
import org.dronemap.core.conduct.Operations.Snapshot;
import org.dronemap.ws.stream.StreamMessage;
import org.dronemap.ws.stream.StreamTopic;
import org.dronemap.ws.stream.StreamTopicRate;
import org.dronemap.ws.stream.delivery.StreamEventRouter;
import org.jspecify.annotations.Nullable;
import org.springframework.core.annotation.Order;

/** Defines the two topics of the WebSocket stream about follows: their changes, and what changes all the time. */
final class FollowStreamTopics {
    private static final StreamTopicRate.Newest FOUR_A_SECOND = new StreamTopicRate.Newest(4);

    private FollowStreamTopics() {}

    @JsonTypeName("follow")
    @Order(600)
    @Schema(
            name = "StreamFollowChanged",
            description = "A phone that is followed; all that are under way once after hello, then when one changes.")
    record FollowChanged(FollowView follow) implements StreamMessage.OfUseCase {}

    @JsonTypeName("followNow")
    @Order(610)
    @Schema(
            name = "StreamFollowNow",
            description = "The part of a follow that changes all the time; null: nothing is known of it now.")
    record FollowNow(String id, FollowView.@Nullable NowView now) implements StreamMessage.OfUseCase {}

    static StreamTopic<Snapshot<FollowState>> changes(FollowService follows) {
        return new StreamTopic<>(
                FollowChanged.class,
                FOUR_A_SECOND,
                new StreamTopic.SubjectMapping<>(
                        "follow", follow -> follow.saved().id().value()),
                StreamTopic.Audience.of("the organisation, whoever sees the drone", FollowService::isShownTo),
                (follow, who) -> new FollowChanged(follows.view(follow)),
                follows::underWay,
                null,
                feed -> follows.addListener(
                        (operation, why) -> feed.changed(operation.id().value(), () -> follows.picture(operation))));
    }

    static StreamTopic<Snapshot<FollowState>> now(FollowService follows, StreamEventRouter news) {
        return new StreamTopic<>(
                FollowNow.class,
                FOUR_A_SECOND,
                new StreamTopic.SubjectMapping<>(
                        "followNow", follow -> follow.saved().id().value()),
                StreamTopic.Audience.of("the organisation, whoever sees the drone", FollowService::isShownTo),
                (follow, who) -> new FollowNow(
                        follow.saved().id().value(), follows.view(follow).now()),
                List::of,
                null,
                feed -> news.onMoves(drones -> follows.underWay().stream()
                        .filter(follow -> drones.contains(follow.state().drone()))
                        .forEach(follow -> feed.changed(follow.saved().id().value(), () -> Optional.of(follow)))));
    }
}
