package org.dronemap.ws.server;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.dronemap.core.drone.DroneId;
import org.dronemap.proxy.MavlinkConnector;
import org.dronemap.proxy.endpoint.EndpointCounters;
import org.dronemap.proxy.endpoint.EndpointRegistry;
import org.dronemap.proxy.endpoint.EndpointUrl;
import org.dronemap.proxy.endpoint.PeerStatus;
import org.dronemap.proxy.roslink.RoslinkConnector;
import org.dronemap.proxy.session.VehicleTraffic;
import org.dronemap.ws.link.EndpointView;
import org.dronemap.ws.link.LinkTrafficView;
import org.dronemap.ws.link.VehicleEndpointGateway;
import org.dronemap.ws.reading.WireNames;

/** Adapter that manages the endpoints of the MAVLink and ROSLink proxies for the services. */
record ProxyEndpointGateway(MavlinkConnector proxy, RoslinkConnector robots) implements VehicleEndpointGateway {
    private static final int MOST_PEERS_SHOWN = 100;

    @Override
    public List<Status> all() {
        return Stream.concat(proxy.links().all().stream(), robots.endpoints().stream())
                .map(ProxyEndpointGateway::status)
                .toList();
    }

    @Override
    public String checked(String url) {
        return EndpointUrl.parse(url).toString();
    }

    @Override
    public void keep(String id, String url) {
        proxy.links().retryLater(id, EndpointUrl.parse(url));
    }

    @Override
    public boolean remove(String id) {
        return proxy.links().remove(id);
    }

    @Override
    public void disconnect(String identity) {
        proxy.links().disconnect(identity);
        robots.disconnect(identity);
    }

    @Override
    public List<LinkTrafficView> traffic() {
        return Stream.concat(proxy.traffic().stream(), robots.traffic().stream())
                .map(ProxyEndpointGateway::traffic)
                .toList();
    }

    @Override
    public Map<String, Long> refusedMessages() {
        return Map.of(
                "broken", robots.brokenCount(),
                "notBelieved", robots.refusedCount(),
                "unknown", robots.unknownCount(),
                "noPicture", robots.unreadableCount());
    }

    private static Status status(EndpointRegistry.Status link) {
        List<EndpointView.PeerView> peers = link.peers().stream()
                .limit(MOST_PEERS_SHOWN)
                .map(ProxyEndpointGateway::peer)
                .toList();
        return new Status(
                link.id(),
                link.url().toString(),
                link.url().kind().transport(),
                WireNames.camel(link.state().phase()),
                link.state().reason(),
                counts(link),
                peers);
    }

    private static EndpointView.Counts counts(EndpointRegistry.Status link) {
        EndpointCounters.Counts counts = link.counts();
        return new EndpointView.Counts(
                counts.peers(),
                counts.framesIn(),
                counts.framesOut(),
                counts.lost(),
                counts.brokenBytes(),
                counts.droppedIn(),
                counts.droppedOut(),
                counts.throttled(),
                counts.refusedPeers(),
                link.peers().stream().mapToLong(PeerStatus::queue).sum(),
                link.kernelDrops().isPresent() ? (Long) link.kernelDrops().getAsLong() : null);
    }

    private static EndpointView.PeerView peer(PeerStatus peer) {
        return new EndpointView.PeerView(
                peer.address().toString(),
                peer.identity(),
                peer.framesIn(),
                peer.framesOut(),
                peer.lost(),
                peer.brokenBytes(),
                peer.dropped(),
                peer.queue(),
                peer.silentMillis() / 1000.0);
    }

    private static LinkTrafficView traffic(VehicleTraffic traffic) {
        DroneId drone = traffic.drone();
        return new LinkTrafficView(
                drone == null ? null : drone.value(),
                traffic.key().address(),
                traffic.key().port(),
                traffic.key().systemId(),
                traffic.transport(),
                traffic.received(),
                traffic.sent(),
                traffic.lost(),
                traffic.doubled(),
                traffic.dropped(),
                traffic.queue());
    }
}
