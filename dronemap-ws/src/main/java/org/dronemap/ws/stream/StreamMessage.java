package org.dronemap.ws.stream;

import com.fasterxml.jackson.annotation.JsonInclude;
import java.time.Instant;
import java.util.List;
import org.dronemap.ws.service.CommandRequest;
import org.dronemap.ws.service.CommandView;
import org.dronemap.ws.service.ControlView;
import org.dronemap.ws.service.DroneView;
import org.dronemap.ws.service.FollowReceipt;
import org.dronemap.ws.service.FollowRequest;
import org.dronemap.ws.service.FollowView;
import org.dronemap.ws.service.PlanView;
import org.dronemap.ws.service.Problem;
import org.dronemap.ws.service.RunView;
import org.dronemap.ws.service.SteeringRequest;
import org.dronemap.ws.service.VirtualDroneView;
import org.dronemap.ws.service.ZoneFeature;
import org.jspecify.annotations.Nullable;

/** The messages of the stream, each with its type as clients see it. */
sealed interface StreamMessage {

    /** From a client; which members are there depends on the type. */
    record FromClient(
            @Nullable String type,
            @Nullable String key,
            @Nullable String requestId,
            @Nullable String drone,
            @Nullable CommandRequest command,
            SteeringRequest.@Nullable Velocity velocity,
            SteeringRequest.@Nullable Sticks sticks,
            @Nullable List<String> drones,
            @Nullable Integer rate,
            @Nullable String action,
            @Nullable String user,
            @Nullable String reason,
            @Nullable Long epoch,
            @Nullable String follow,
            @Nullable Instant sent,
            @Nullable Double roundTrip,
            @Nullable List<FollowRequest.@Nullable PositionRequest> positions) {}

    record Hello(String type, String user, String role) implements StreamMessage {
        Hello(String user, String role) {
            this("hello", user, role);
        }
    }

    record Drones(String type, List<DroneView> drones) implements StreamMessage {
        Drones(List<DroneView> drones) {
            this("drones", drones);
        }
    }

    record Drone(String type, DroneView drone) implements StreamMessage {
        Drone(DroneView drone) {
            this("drone", drone);
        }
    }

    record DroneRemoved(String type, String id) implements StreamMessage {
        DroneRemoved(String id) {
            this("droneRemoved", id);
        }
    }

    record ZoneChanged(String type, ZoneFeature zone) implements StreamMessage {
        ZoneChanged(ZoneFeature zone) {
            this("zone", zone);
        }
    }

    record ZoneRemoved(String type, String id) implements StreamMessage {
        ZoneRemoved(String id) {
            this("zoneRemoved", id);
        }
    }

    record VirtualDroneChanged(String type, VirtualDroneView virtualDrone) implements StreamMessage {
        VirtualDroneChanged(VirtualDroneView virtualDrone) {
            this("virtualDrone", virtualDrone);
        }
    }

    record VirtualDroneRemoved(String type, String id) implements StreamMessage {
        VirtualDroneRemoved(String id) {
            this("virtualDroneRemoved", id);
        }
    }

    record PlanChanged(String type, PlanView plan) implements StreamMessage {
        PlanChanged(PlanView plan) {
            this("plan", plan);
        }
    }

    record PlanRemoved(String type, String id) implements StreamMessage {
        PlanRemoved(String id) {
            this("planRemoved", id);
        }
    }

    record RunChanged(String type, RunView run) implements StreamMessage {
        RunChanged(RunView run) {
            this("run", run);
        }
    }

    record FollowChanged(String type, FollowView follow) implements StreamMessage {
        FollowChanged(FollowView follow) {
            this("follow", follow);
        }
    }

    record FollowNow(String type, String id, FollowView.@Nullable NowView now) implements StreamMessage {
        FollowNow(String id, FollowView.@Nullable NowView now) {
            this("followNow", id, now);
        }
    }

    record PositionsHeard(String type, @Nullable String requestId, FollowReceipt receipt) implements StreamMessage {
        PositionsHeard(@Nullable String requestId, FollowReceipt receipt) {
            this("positionsHeard", requestId, receipt);
        }
    }

    record Command(String type, CommandView command) implements StreamMessage {
        Command(CommandView command) {
            this("command", command);
        }
    }

    record CommandAccepted(String type, @Nullable String requestId, CommandView command) implements StreamMessage {
        CommandAccepted(@Nullable String requestId, CommandView command) {
            this("commandAccepted", requestId, command);
        }
    }

    record Control(String type, String drone, ControlView control, ControlView.ChangeView change)
            implements StreamMessage {
        Control(String drone, ControlView control, ControlView.ChangeView change) {
            this("control", drone, control, change);
        }
    }

    record ControlAnswer(String type, @Nullable String requestId, String drone, boolean waiting, ControlView control)
            implements StreamMessage {
        ControlAnswer(@Nullable String requestId, String drone, boolean waiting, ControlView control) {
            this("controlAnswer", requestId, drone, waiting, control);
        }
    }

    @JsonInclude(JsonInclude.Include.NON_NULL)
    record Failure(String type, Problem problem, @Nullable String requestId) implements StreamMessage {
        Failure(Problem problem, @Nullable String requestId) {
            this("error", problem, requestId);
        }
    }

    record Ping(String type, Instant at) implements StreamMessage {
        Ping(Instant at) {
            this("ping", at);
        }
    }

    record Pong(String type) implements StreamMessage {
        Pong() {
            this("pong");
        }
    }
}
