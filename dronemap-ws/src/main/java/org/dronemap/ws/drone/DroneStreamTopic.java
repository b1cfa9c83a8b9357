package org.dronemap.ws.drone;

import com.fasterxml.jackson.annotation.JsonTypeName;
import io.swagger.v3.oas.annotations.media.Schema;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronemap.core.access.Permission;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.ws.stream.StreamMessage;
import org.dronemap.ws.stream.StreamTopic;
import org.dronemap.ws.stream.StreamTopicRate;
import org.dronemap.ws.stream.StreamWelcome;
import org.dronemap.ws.stream.delivery.StreamEventRouter;
import org.dronemap.ws.stream.delivery.StreamMessageSubject;
import org.jspecify.annotations.Nullable;
import org.springframework.core.annotation.Order;

/** Defines the topic of the WebSocket stream about drones, and the list of them that a client gets first. */
final class DroneStreamTopic {
    private DroneStreamTopic() {}

    @JsonTypeName("drones")
    @Order(100)
    @Schema(name = "StreamDrones", description = "All drones that you see, once after hello.")
    record AllDrones(List<DroneView> drones) implements StreamMessage.OfUseCase {}

    @JsonTypeName("drone")
    @Order(110)
    @Schema(name = "StreamDrone", description = "A drone that has changed.")
    record DroneChanged(DroneView drone) implements StreamMessage.OfUseCase {}

    @JsonTypeName("droneRemoved")
    @Order(120)
    @Schema(name = "StreamDroneRemoved", description = "A drone that is gone, or out of your sight from now on.")
    record DroneRemoved(String id) implements StreamMessage.OfUseCase {}

    /** Those to whom a drone that they see looks alike. */
    private record DroneSight(Role role, Set<Permission> permissions) {}

    static StreamTopic<DroneState> of(CloudManager cloud, DroneViewMapper views, StreamEventRouter news) {
        return new StreamTopic<>(
                DroneChanged.class,
                new StreamTopicRate.NewestAsAsked(),
                StreamTopic.SubjectMapping.ofDrone(DroneState::id),
                new StreamTopic.Audience<>("whoever sees the drone", (who, drone) -> sightOf(who, drone.id())),
                (drone, who) -> new DroneChanged(views.view(drone, who)),
                cloud::drones,
                new StreamTopic.Removal(DroneRemoved.class, DroneRemoved::new),
                feed -> {
                    news.onChange(drone -> feed.changed(drone.id().value(), () -> Optional.of(drone)));
                    news.onRemoval(id -> feed.removed(id.value()));
                });
    }

    static StreamWelcome welcome(DroneService drones) {
        return new StreamWelcome(AllDrones.class, principal -> greeting(drones, principal));
    }

    private static StreamWelcome.Greeting greeting(DroneService drones, Principal principal) {
        List<DroneView> all = drones.drones(principal);
        Map<StreamMessageSubject, Object> sights = new HashMap<>();
        all.forEach(drone -> {
            DroneId id = new DroneId(drone.id());
            Object sight = sightOf(principal, id);
            if (sight != null) {
                sights.put(StreamMessageSubject.drone(id), sight);
            }
        });
        return new StreamWelcome.Greeting(new AllDrones(all), sights);
    }

    /** What somebody sees of a drone is the same as long as this is. Null: nothing. */
    private static @Nullable Object sightOf(Principal who, DroneId drone) {
        Set<Permission> permissions = who.permissions(drone);
        return permissions.isEmpty() ? null : new DroneSight(who.role(), permissions);
    }
}
