package org.dronemap.ws.virtual;

import com.fasterxml.jackson.annotation.JsonTypeName;
import io.swagger.v3.oas.annotations.media.Schema;
import org.dronemap.core.conduct.VirtualDroneListener;
import org.dronemap.core.conduct.VirtualDrones;
import org.dronemap.core.virtual.VirtualDrone;
import org.dronemap.ws.stream.StreamMessage;
import org.dronemap.ws.stream.StreamTopic;
import org.dronemap.ws.stream.StreamTopicRate;
import org.dronemap.ws.stream.delivery.StreamEventRouter;
import org.dronemap.ws.stream.delivery.StreamTopicSink;
import org.springframework.core.annotation.Order;

/** Defines the topic of the WebSocket stream about virtual drones. */
final class VirtualDroneStreamTopic {
    private VirtualDroneStreamTopic() {}

    @JsonTypeName("virtualDrone")
    @Order(300)
    @Schema(
            name = "StreamVirtualDroneChanged",
            description =
                    "A virtual drone; all of them once after hello, then at once when its mission goes on, and while a drone serves it.")
    record VirtualDroneChanged(VirtualDroneView virtualDrone) implements StreamMessage.OfUseCase {}

    @JsonTypeName("virtualDroneRemoved")
    @Order(310)
    @Schema(
            name = "StreamVirtualDroneRemoved",
            description = "A virtual drone that was removed, or is out of your sight from now on.")
    record VirtualDroneRemoved(String id) implements StreamMessage.OfUseCase {}

    static StreamTopic<VirtualDrone> of(VirtualDrones virtuals, VirtualDroneViewMapper views, StreamEventRouter news) {
        return new StreamTopic<>(
                VirtualDroneChanged.class,
                new StreamTopicRate.Newest(2),
                new StreamTopic.SubjectMapping<>(
                        "virtualDrone", drone -> drone.id().value()),
                new StreamTopic.Audience<>(
                        "whose it is, and supervisors of the organisation",
                        (who, drone) -> VirtualDroneService.isShownTo(who, drone) ? who : null),
                (drone, who) -> new VirtualDroneChanged(views.view(drone, who)),
                virtuals::all,
                new StreamTopic.Removal(VirtualDroneRemoved.class, VirtualDroneRemoved::new),
                feed -> {
                    virtuals.addListener(new VirtualDroneUpdates(virtuals, feed));
                    news.onMoves(drones -> virtuals.all().stream()
                            .filter(drone -> drone.bound().stream().anyMatch(drones::contains))
                            .forEach(drone -> feed.changed(drone.id().value(), () -> virtuals.find(drone.id()))));
                });
    }

    /** Its missions go on: that is told at once. */
    private record VirtualDroneUpdates(VirtualDrones virtuals, StreamTopicSink<VirtualDrone> feed)
            implements VirtualDroneListener {
        @Override
        public void changed(VirtualDrone drone) {
            publish(drone);
            if (drone.isWaiting() || !drone.isUnderWay()) {
                // Those behind it in the queue may have moved up.
                virtuals.all().stream().filter(VirtualDrone::isWaiting).forEach(this::publish);
            }
        }

        private void publish(VirtualDrone drone) {
            feed.changedAtOnce(drone.id().value(), () -> virtuals.find(drone.id()));
        }

        @Override
        public void removed(VirtualDrone drone) {
            feed.removed(drone.id().value());
        }
    }
}
