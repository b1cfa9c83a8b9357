package org.dronemap.ws.server;

import java.io.IOException;
import java.util.List;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.lane.Lanes;
import org.dronemap.core.time.Time;
import org.dronemap.proxy.endpoint.EndpointUrl;
import org.dronemap.proxy.roslink.RoslinkConnector;
import org.dronemap.ws.environment.SetupException;
import org.dronemap.ws.settings.RobotSettings;

/** Builds and opens the endpoints at which ROSLink robots connect. */
final class RobotEndpointBuilder {
    private final RobotSettings settings;
    private final Time time;
    private final List<EndpointUrl> urls;

    RobotEndpointBuilder(RobotSettings settings, Time time) {
        this.settings = settings;
        this.time = time;
        urls = settings.urls().stream().map(RobotEndpointBuilder::url).toList();
    }

    private static EndpointUrl url(String text) {
        try {
            EndpointUrl url = EndpointUrl.parse(text);
            switch (url.kind()) {
                case UDPSERVER, WSSERVER, WSSSERVER -> {
                    return url;
                }
                default ->
                    throw new IllegalArgumentException("\"" + text
                            + "\" is nothing for robots; write udpserver://, wsserver:// or wssserver://, or off.");
            }
        } catch (IllegalArgumentException e) {
            throw new SetupException("DRONEMAP_ROBOTS: " + e.getMessage(), e);
        }
    }

    RoslinkConnector build(CloudManager cloud, Lanes lanes, RoslinkConnector.Policy policy) {
        return new RoslinkConnector(cloud, lanes, urls, policy, time);
    }

    /** Lets robots in. A port of a setting must be free; the usual ones may be another server's for now. */
    void open(RoslinkConnector robots) {
        if (settings.usual()) {
            robots.keep();
            return;
        }
        try {
            robots.start();
        } catch (IOException e) {
            throw new SetupException(e.getMessage() + " (DRONEMAP_ROBOTS)", e);
        }
    }
}
