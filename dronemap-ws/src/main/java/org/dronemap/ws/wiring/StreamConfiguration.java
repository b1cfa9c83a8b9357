package org.dronemap.ws.wiring;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.time.Clock;
import javax.net.ssl.SSLContext;
import org.dronemap.ws.security.Authentication;
import org.dronemap.ws.security.StreamTickets;
import org.dronemap.ws.service.Accounts;
import org.dronemap.ws.service.CommandService;
import org.dronemap.ws.service.ControlService;
import org.dronemap.ws.service.DroneService;
import org.dronemap.ws.service.DroneViews;
import org.dronemap.ws.service.JsonReader;
import org.dronemap.ws.service.Secrets;
import org.dronemap.ws.stream.StreamFace;
import org.jspecify.annotations.Nullable;
import org.springframework.boot.ssl.SslBundles;
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
    StreamFace.Entrance streamEntrance(
            Authentication authentication, StreamTickets tickets, Accounts accounts, House house) {
        return new StreamFace.Entrance(authentication, tickets, accounts, house.grantBook());
    }

    @Bean
    StreamFace.Services streamServices(
            StreamFace.Entrance entrance,
            DroneService drones,
            DroneViews views,
            CommandService commands,
            ControlService controls,
            JsonReader json) {
        return new StreamFace.Services(entrance, drones, views, commands, controls, json);
    }

    @Bean
    StreamFace streamFace(
            House house, StreamFace.Services services, Settings settings, SslBundles bundles, Clock clock) {
        InetSocketAddress address = new InetSocketAddress(settings.bindAddress(), settings.streamPort());
        return new StreamFace(house.cloud(), services, address, tls(settings, bundles), clock);
    }

    /** Listens before the HTTP port does, so that whoever finds the page finds the stream. */
    @Bean
    StreamPort streamPort(StreamFace face, Settings settings) {
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

    private static @Nullable SSLContext tls(Settings settings, SslBundles bundles) {
        return settings.tls() == null
                ? null
                : bundles.getBundle(FacesServer.TLS_BUNDLE).createSslContext();
    }
}
