package org.dronemap.ws.wiring;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.time.Clock;
import java.util.List;
import java.util.function.Supplier;
import javax.net.ssl.SSLContext;
import org.dronemap.core.audit.AuditDesk;
import org.dronemap.core.time.Time;
import org.dronemap.proxy.endpoint.BoundedDraft;
import org.dronemap.proxy.endpoint.WebSocketDoor;
import org.dronemap.ws.access.RestOperations;
import org.dronemap.ws.account.Accounts;
import org.dronemap.ws.budget.Budgets;
import org.dronemap.ws.command.CommandService;
import org.dronemap.ws.control.ControlService;
import org.dronemap.ws.control.SteeringService;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.drone.DroneViews;
import org.dronemap.ws.follow.FollowService;
import org.dronemap.ws.guard.ClientLimits;
import org.dronemap.ws.plan.PlanDesk;
import org.dronemap.ws.reading.JsonReader;
import org.dronemap.ws.reading.Secrets;
import org.dronemap.ws.run.RunService;
import org.dronemap.ws.security.Authentication;
import org.dronemap.ws.security.StreamTickets;
import org.dronemap.ws.server.Certificate;
import org.dronemap.ws.server.House;
import org.dronemap.ws.server.Version;
import org.dronemap.ws.setting.SetupException;
import org.dronemap.ws.settings.Settings;
import org.dronemap.ws.stream.StreamCrowd;
import org.dronemap.ws.stream.StreamFace;
import org.dronemap.ws.stream.Topic;
import org.dronemap.ws.stream.description.StreamDescription;
import org.dronemap.ws.virtual.VirtualDroneViews;
import org.jspecify.annotations.Nullable;
import org.springdoc.core.customizers.OpenApiCustomizer;
import org.springframework.beans.factory.ObjectProvider;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;

/** Constructs the WebSocket face. */
@Configuration(proxyBeanMethods = false)
public class StreamConfiguration {

    @Bean
    StreamTickets streamTickets(Secrets secrets, Clock clock) {
        return new StreamTickets(secrets, clock);
    }

    @Bean
    StreamCrowd streamCrowd(Settings settings) {
        return new StreamCrowd(settings.protection().streamsPerUser(), BoundedDraft::admit);
    }

    @Bean
    StreamFace.Bounds streamBounds(Budgets budgets, StreamCrowd crowd, RestOperations operations) {
        return new StreamFace.Bounds(budgets, crowd, operations);
    }

    @Bean
    StreamFace.Entrance streamEntrance(
            Authentication authentication,
            StreamTickets tickets,
            Accounts accounts,
            StreamFace.Bounds bounds,
            House house,
            AuditDesk desk) {
        return new StreamFace.Entrance(authentication, tickets, accounts, bounds, house.grantBook(), desk);
    }

    @Bean
    StreamFace.Services streamServices(
            StreamFace.Entrance entrance,
            DroneService drones,
            StreamFace.Pictures pictures,
            CommandService commands,
            StreamFace.Reins reins,
            JsonReader json) {
        return new StreamFace.Services(entrance, drones, pictures, commands, reins, json);
    }

    @Bean
    StreamFace.Reins streamReins(ControlService controls, SteeringService steering) {
        return new StreamFace.Reins(controls, steering);
    }

    @Bean
    StreamFace.Pictures streamPictures(
            House house,
            DroneViews views,
            VirtualDroneViews virtualViews,
            PlanDesk plans,
            RunService runs,
            FollowService follows) {
        return new StreamFace.Pictures(views, house.virtuals(), virtualViews, plans, runs, follows);
    }

    @Bean
    WebSocketDoor streamDoor(Settings settings, Time time) {
        ClientLimits limits = settings.protection().clients();
        Settings.Tls tls = settings.tls();
        Supplier<@Nullable SSLContext> certificate = tls == null ? () -> null : Certificate.of(tls)::current;
        return new WebSocketDoor(
                WebSocketDoor.Limits.DEFAULT.with(limits.connectionsPerHost(), limits.patience()), certificate, time);
    }

    @Bean
    StreamFace streamFace(
            House house,
            StreamFace.Services services,
            ObjectProvider<Topic<?>> topics,
            Settings settings,
            WebSocketDoor door,
            Clock clock) {
        InetSocketAddress address = new InetSocketAddress(settings.bindAddress(), settings.streamPort());
        StreamFace.Port port = new StreamFace.Port(address, door, new BoundedDraft(StreamFace.LARGEST_MESSAGE_BYTES));
        return new StreamFace(house.cloud(), services, topics.orderedStream().toList(), port, clock);
    }

    @Bean
    StreamDescription streamDescription(StreamFace face, List<OpenApiCustomizer> customizers, JsonReader json) {
        return new StreamDescription(face, customizers, json, Version.current());
    }

    /** Listens before the HTTP port does, so that whoever finds the page finds the stream. */
    @Bean
    StreamPort streamPort(StreamFace face, RestOperations operations, Settings settings) {
        // Whoever comes first is judged by them, on another thread than the one that starts the server.
        operations.all();
        try {
            return new StreamPort(face.start());
        } catch (IOException e) {
            throw new SetupException(
                    "The stream port " + settings.streamPort() + " on " + settings.bindAddress()
                            + " cannot be listened on (is it taken by another program?); stop that one, or choose"
                            + " another port with DRONEMAP_STREAM_PORT.",
                    e);
        }
    }
}
