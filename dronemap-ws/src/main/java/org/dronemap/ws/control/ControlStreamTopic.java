package org.dronemap.ws.control;

import com.fasterxml.jackson.annotation.JsonTypeName;
import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import org.dronemap.ws.drone.ControlView;
import org.dronemap.ws.stream.StreamMessage;
import org.dronemap.ws.stream.StreamTopic;
import org.dronemap.ws.stream.StreamTopicRate;
import org.dronemap.ws.stream.delivery.StreamEventRouter;
import org.springframework.core.annotation.Order;

/** Defines the topic of the WebSocket stream about the control of drones. */
final class ControlStreamTopic {
    private ControlStreamTopic() {}

    @JsonTypeName("control")
    @Order(800)
    @Schema(name = "StreamControl", description = "Who has a drone now, and what has happened.")
    record ControlChanged(String drone, ControlView control, ControlView.ChangeView change)
            implements StreamMessage.OfUseCase {}

    static StreamTopic<StreamEventRouter.ControlEvent> of(StreamEventRouter news) {
        return new StreamTopic<>(
                ControlChanged.class,
                new StreamTopicRate.EveryChange(),
                StreamTopic.SubjectMapping.ofDrone(StreamEventRouter.ControlEvent::drone),
                StreamTopic.Audience.of("whoever sees the drone", (who, event) -> who.sees(event.drone())),
                (event, who) -> new ControlChanged(
                        event.drone().value(), ControlView.of(event.now()), ControlView.ChangeView.of(event.change())),
                List::of,
                null,
                feed -> news.onControl(feed::publish));
    }
}
