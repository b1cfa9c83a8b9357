package org.dronemap.ws.stream;

import com.fasterxml.jackson.annotation.JsonInclude;
import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.List;
import org.dronemap.core.access.Role;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.drone.ControlView;
import org.dronemap.ws.drone.DroneView;
import org.dronemap.ws.follow.FollowReceipt;
import org.dronemap.ws.follow.FollowView;
import org.dronemap.ws.plan.PlanView;
import org.dronemap.ws.problem.ProblemView;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.ObjectOnlyTypeResolver;
import org.dronemap.ws.run.RunView;
import org.dronemap.ws.virtual.VirtualDroneView;
import org.dronemap.ws.zone.ZoneFeature;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.annotation.JsonTypeResolver;

/** A message that the server sends to clients on the WebSocket stream. */
@JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "type")
@JsonTypeResolver(ObjectOnlyTypeResolver.class)
@JsonSubTypes({
    @JsonSubTypes.Type(value = StreamMessage.Hello.class, name = "hello"),
    @JsonSubTypes.Type(value = StreamMessage.Drones.class, name = "drones"),
    @JsonSubTypes.Type(value = StreamMessage.Drone.class, name = "drone"),
    @JsonSubTypes.Type(value = StreamMessage.DroneRemoved.class, name = "droneRemoved"),
    @JsonSubTypes.Type(value = StreamMessage.ZoneChanged.class, name = "zone"),
    @JsonSubTypes.Type(value = StreamMessage.ZoneRemoved.class, name = "zoneRemoved"),
    @JsonSubTypes.Type(value = StreamMessage.VirtualDroneChanged.class, name = "virtualDrone"),
    @JsonSubTypes.Type(value = StreamMessage.VirtualDroneRemoved.class, name = "virtualDroneRemoved"),
    @JsonSubTypes.Type(value = StreamMessage.PlanChanged.class, name = "plan"),
    @JsonSubTypes.Type(value = StreamMessage.PlanRemoved.class, name = "planRemoved"),
    @JsonSubTypes.Type(value = StreamMessage.RunChanged.class, name = "run"),
    @JsonSubTypes.Type(value = StreamMessage.FollowChanged.class, name = "follow"),
    @JsonSubTypes.Type(value = StreamMessage.FollowNow.class, name = "followNow"),
    @JsonSubTypes.Type(value = StreamMessage.PositionsReceived.class, name = "positionsHeard"),
    @JsonSubTypes.Type(value = StreamMessage.Command.class, name = "command"),
    @JsonSubTypes.Type(value = StreamMessage.CommandAccepted.class, name = "commandAccepted"),
    @JsonSubTypes.Type(value = StreamMessage.Control.class, name = "control"),
    @JsonSubTypes.Type(value = StreamMessage.ControlAnswer.class, name = "controlAnswer"),
    @JsonSubTypes.Type(value = StreamMessage.Failure.class, name = "error"),
    @JsonSubTypes.Type(value = StreamMessage.Ping.class, name = "ping"),
    @JsonSubTypes.Type(value = StreamMessage.Pong.class, name = "pong")
})
@Schema(name = "StreamMessage", description = "What the server says.")
public sealed interface StreamMessage {
    /** A message of a topic that is declared beside its use case; {@code @JsonTypeName} says its type. */
    non-sealed interface OfUseCase extends StreamMessage {}

    @Schema(name = "StreamHello", description = "The first message: who you are.")
    record Hello(String user, @EnumValues(Role.class) String role) implements StreamMessage {}

    @Schema(name = "StreamDrones", description = "All drones that you see, once after hello.")
    record Drones(List<DroneView> drones) implements StreamMessage {}

    @Schema(name = "StreamDrone", description = "A drone that has changed.")
    record Drone(DroneView drone) implements StreamMessage {}

    @Schema(name = "StreamDroneRemoved", description = "A drone that is gone, or out of your sight from now on.")
    record DroneRemoved(String id) implements StreamMessage {}

    @Schema(name = "StreamZoneChanged", description = "A zone that was added or changed.")
    record ZoneChanged(ZoneFeature zone) implements StreamMessage {}

    @Schema(name = "StreamZoneRemoved", description = "A zone that was removed, or is out of your sight from now on.")
    record ZoneRemoved(String id) implements StreamMessage {}

    @Schema(
            name = "StreamVirtualDroneChanged",
            description =
                    "A virtual drone; all of them once after hello, then at once when its mission goes on, and while a drone serves it.")
    record VirtualDroneChanged(VirtualDroneView virtualDrone) implements StreamMessage {}

    @Schema(
            name = "StreamVirtualDroneRemoved",
            description = "A virtual drone that was removed, or is out of your sight from now on.")
    record VirtualDroneRemoved(String id) implements StreamMessage {}

    @Schema(name = "StreamPlanChanged", description = "A plan; all of them once after hello, then while it changes.")
    record PlanChanged(PlanView plan) implements StreamMessage {}

    @Schema(name = "StreamPlanRemoved", description = "A plan that was forgotten, or is out of your sight from now on.")
    record PlanRemoved(String id) implements StreamMessage {}

    @Schema(
            name = "StreamRunChanged",
            description = "A mission run; all that are under way once after hello, then while it changes.")
    record RunChanged(RunView run) implements StreamMessage {}

    @Schema(
            name = "StreamFollowChanged",
            description = "A phone that is followed; all that are under way once after hello, then when one changes.")
    record FollowChanged(FollowView follow) implements StreamMessage {}

    @Schema(
            name = "StreamFollowNow",
            description = "The part of a follow that changes all the time; null: nothing is known of it now.")
    record FollowNow(String id, FollowView.@Nullable NowView now) implements StreamMessage {}

    @Schema(name = "StreamPositionsHeard", description = "Answers positions.")
    record PositionsReceived(@Nullable String requestId, FollowReceipt receipt) implements StreamMessage {}

    @Schema(name = "StreamCommand", description = "A command whose phase has changed.")
    record Command(CommandView command) implements StreamMessage {}

    @Schema(name = "StreamCommandAccepted", description = "Answers a command; its outcome follows.")
    record CommandAccepted(@Nullable String requestId, CommandView command) implements StreamMessage {}

    @Schema(name = "StreamControl", description = "Who has a drone now, and what has happened.")
    record Control(String drone, ControlView control, ControlView.ChangeView change) implements StreamMessage {}

    @Schema(
            name = "StreamControlAnswer",
            description = "Answers what was said about control; waiting: the holder was asked.")
    record ControlAnswer(@Nullable String requestId, String drone, boolean waiting, ControlView control)
            implements StreamMessage {}

    @JsonInclude(JsonInclude.Include.NON_NULL)
    @Schema(
            name = "StreamError",
            description = "Answers a request that is not carried out, or says why the connection is closed.")
    record Failure(ProblemView problem, @Nullable String requestId) implements StreamMessage {}

    @Schema(name = "StreamPing", description = "The sign of life, once a second, by the clock of the cloud.")
    record Ping(Instant at) implements StreamMessage {}

    @Schema(name = "StreamPong", description = "Answers ping.")
    record Pong() implements StreamMessage {}
}
