package org.dronemap.ws.server;

import java.time.Duration;
import java.util.List;
import org.dronemap.core.access.LinkKey;
import org.dronemap.proxy.endpoint.EndpointUrl;
import org.dronemap.proxy.outlet.Outlet;
import org.dronemap.proxy.outlet.client.OutletStatus;
import org.dronemap.proxy.outlet.rights.AddressRange;
import org.dronemap.ws.outlet.OutletGateway;
import org.dronemap.ws.outlet.OutletView;

/** Adapter that manages the proxy's outlet for third-party ground stations for the services. */
record ProxyOutletGateway(Outlet outlet) implements OutletGateway {
    @Override
    public List<String> endpoints() {
        return outlet.endpoints().stream().map(EndpointUrl::toString).toList();
    }

    @Override
    public void judgeAnew() {
        outlet.judgeAnew();
    }

    @Override
    public boolean hasKey(String user) {
        return outlet.hasKey(user);
    }

    @Override
    public boolean putKey(String user, LinkKey key) {
        return outlet.putKey(user, key);
    }

    @Override
    public boolean removeKey(String user) {
        return outlet.removeKey(user);
    }

    @Override
    public OutletView status() {
        OutletStatus status = outlet.status();
        OutletStatus.Refused refused = status.refused();
        return new OutletView(
                endpoints(),
                status.clients().stream().map(ProxyOutletGateway::client).toList(),
                status.ports().stream().map(ProxyOutletGateway::port).toList(),
                new OutletView.RefusedView(
                        refused.unsigned(),
                        refused.badSignature(),
                        refused.replayed(),
                        refused.tooOld(),
                        refused.turnedAway(),
                        refused.elsewhere()),
                status.unread(),
                status.notPassed());
    }

    @Override
    public boolean disconnect(String id) {
        return outlet.disconnect(id);
    }

    @Override
    public OutletView.PortView openPort(String user, String address, Duration time) {
        return port(outlet.openPort(user, AddressRange.parse(address), time));
    }

    @Override
    public boolean closePort(String id) {
        return outlet.closePort(id);
    }

    @Override
    public void closePortsOf(String user) {
        outlet.closePortsOf(user);
    }

    private static OutletView.PortView port(OutletStatus.Port port) {
        return new OutletView.PortView(
                port.id(),
                port.user(),
                port.endpoint(),
                port.allowed(),
                port.peer(),
                port.refused(),
                port.since(),
                port.until());
    }

    private static OutletView.ClientView client(OutletStatus.Client client) {
        return new OutletView.ClientView(
                client.id(),
                client.user(),
                client.address(),
                client.transport(),
                client.systemId(),
                client.drones(),
                client.since(),
                client.framesIn(),
                client.framesOut(),
                client.framesPerSecondIn(),
                client.framesPerSecondOut(),
                client.dropped(),
                client.waiting(),
                client.silentSeconds());
    }
}
