package org.dronemap.ws.wiring;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.time.Clock;
import java.util.List;
import java.util.function.Supplier;
import javax.net.ssl.SSLContext;
import org.dronemap.core.access.GrantRegistry;
import org.dronemap.core.audit.AuditRecorder;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.time.Time;
import org.dronemap.proxy.endpoint.BoundedWebSocketDraft;
import org.dronemap.proxy.endpoint.BoundedWebSocketFactory;
import org.dronemap.ws.access.RestOperations;
import org.dronemap.ws.account.AccountChanges;
import org.dronemap.ws.budget.Budgets;
import org.dronemap.ws.environment.SetupException;
import org.dronemap.ws.limit.ClientLimits;
import org.dronemap.ws.reading.JsonCodec;
import org.dronemap.ws.reading.SecretGenerator;
import org.dronemap.ws.security.CallerAuthenticator;
import org.dronemap.ws.security.StreamTickets;
import org.dronemap.ws.server.BuildVersion;
import org.dronemap.ws.server.ReloadableCertificate;
import org.dronemap.ws.settings.ServerSettings;
import org.dronemap.ws.stream.StreamClientRegistry;
import org.dronemap.ws.stream.StreamConnectionListener;
import org.dronemap.ws.stream.StreamFace;
import org.dronemap.ws.stream.StreamOperation;
import org.dronemap.ws.stream.StreamTopic;
import org.dronemap.ws.stream.StreamWelcome;
import org.dronemap.ws.stream.delivery.StreamEventRouter;
import org.dronemap.ws.stream.description.StreamDescription;
import org.jspecify.annotations.Nullable;
import org.springdoc.core.customizers.OpenApiCustomizer;
import org.springframework.beans.factory.ObjectProvider;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;

/** Spring configuration of the WebSocket face (the stream). */
@Configuration(proxyBeanMethods = false)
class StreamConfiguration {

    @Bean
    StreamTickets streamTickets(SecretGenerator secrets, Clock clock) {
        return new StreamTickets(secrets, clock);
    }

    @Bean
    StreamClientRegistry streamCrowd(ServerSettings settings) {
        return new StreamClientRegistry(settings.protection().streamsPerUser(), BoundedWebSocketDraft::admit);
    }

    @Bean
    StreamFace.Limits streamBounds(Budgets budgets, StreamClientRegistry crowd, RestOperations operations) {
        return new StreamFace.Limits(budgets, crowd, operations);
    }

    @Bean
    StreamFace.AccessServices streamEntrance(
            CallerAuthenticator authentication,
            StreamTickets tickets,
            AccountChanges accounts,
            StreamFace.Limits bounds,
            GrantRegistry grants,
            AuditRecorder audit) {
        return new StreamFace.AccessServices(authentication, tickets, accounts, bounds, grants, audit);
    }

    @Bean
    StreamFace.Services streamServices(
            StreamFace.AccessServices entrance, StreamFace.Features features, JsonCodec json) {
        return new StreamFace.Services(entrance, features, json, BuildVersion.current());
    }

    /** What rooms of features declare, in the order that they say. */
    @Bean
    StreamFace.Features streamFeatures(
            ObjectProvider<StreamTopic<?>> topics,
            ObjectProvider<StreamOperation<?>> operations,
            ObjectProvider<StreamWelcome> welcomes,
            ObjectProvider<StreamConnectionListener> listeners) {
        return new StreamFace.Features(
                topics.orderedStream().toList(),
                operations.orderedStream().toList(),
                welcomes.orderedStream().toList(),
                listeners.orderedStream().toList());
    }

    /** Tells topics of features what happens in the cloud. */
    @Bean
    StreamEventRouter streamEventRouter() {
        return new StreamEventRouter();
    }

    @Bean
    BoundedWebSocketFactory streamDoor(ServerSettings settings, Time time) {
        ClientLimits limits = settings.protection().clients();
        ServerSettings.Tls tls = settings.tls();
        Supplier<@Nullable SSLContext> certificate = tls == null ? () -> null : ReloadableCertificate.of(tls)::current;
        return new BoundedWebSocketFactory(
                BoundedWebSocketFactory.Limits.DEFAULT.with(limits.connectionsPerHost(), limits.patience()),
                certificate,
                time);
    }

    @Bean
    StreamFace streamFace(
            CloudManager cloud,
            StreamEventRouter news,
            StreamFace.Services services,
            ServerSettings settings,
            BoundedWebSocketFactory door,
            Clock clock) {
        InetSocketAddress address = new InetSocketAddress(settings.bindAddress(), settings.streamPort());
        StreamFace.Port port =
                new StreamFace.Port(address, door, new BoundedWebSocketDraft(StreamFace.LARGEST_MESSAGE_BYTES));
        return new StreamFace(cloud, news, services, port, clock);
    }

    @Bean
    StreamDescription streamDescription(StreamFace face, List<OpenApiCustomizer> customizers, JsonCodec json) {
        return new StreamDescription(face, customizers, json, BuildVersion.current());
    }

    /** Listens before the HTTP port does, so that whoever finds the page finds the stream. */
    @Bean
    StreamPort streamPort(StreamFace face, RestOperations operations, ServerSettings settings) {
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
