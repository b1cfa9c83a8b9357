package org.dronemap.proxy.roslink;

import java.io.IOException;
import java.util.List;
import java.util.function.Supplier;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.lane.Lanes;
import org.dronemap.core.time.Time;
import org.dronemap.proxy.endpoint.EndpointRegistry;
import org.dronemap.proxy.endpoint.EndpointSecurity;
import org.dronemap.proxy.endpoint.EndpointUrl;
import org.dronemap.proxy.endpoint.PeerHandler;
import org.dronemap.proxy.record.TextMessageTap;
import org.dronemap.proxy.session.Enrolment;
import org.dronemap.proxy.session.VehicleTraffic;

/** Opens the endpoints that ROSLink robots connect to, and owns their sessions. Any thread. */
public final class RoslinkConnector implements AutoCloseable {
    private final List<EndpointUrl> urls;
    private final RobotSessionRegistry table;
    private final EndpointRegistry links;

    /**
     * The rules and collaborators that sessions of robots are made with.
     *
     * @param keys issued to robots
     * @param taps hear every message of a session, one each
     * @param doors what links are guarded with
     * @param enrolment from where those that show no such key come in by themselves
     */
    public record Policy(RobotKeys keys, Supplier<TextMessageTap> taps, EndpointSecurity doors, Enrolment enrolment) {}

    public RoslinkConnector(CloudManager cloud, Lanes lanes, List<EndpointUrl> urls, Policy policy, Time time) {
        this.urls = List.copyOf(urls);
        table = new RobotSessionRegistry(cloud, lanes, policy, time::nanos);
        links = new EndpointRegistry(table, policy.doors(), time);
    }

    /**
     * Opens all configured endpoints or none.
     *
     * @throws IOException with a sentence that says which one and why
     */
    public synchronized void start() throws IOException {
        try {
            for (int number = 0; number < urls.size(); number++) {
                links.open(id(number), urls.get(number));
            }
        } catch (IOException e) {
            close();
            throw e;
        }
    }

    /** Opens all configured endpoints; one whose port is taken is tried again. */
    public synchronized void keep() {
        for (int number = 0; number < urls.size(); number++) {
            links.retryLater(id(number), urls.get(number));
        }
    }

    private static String id(int number) {
        return "robots-" + (number + 1);
    }

    /** Who takes in what new links bring. */
    public PeerHandler.Factory handlers() {
        return table;
    }

    public List<EndpointRegistry.Status> endpoints() {
        return links.all();
    }

    /** Those that were open and are not any more. */
    public List<String> broken() {
        return links.broken();
    }

    /** Ends the links of whoever came with a key for that drone that is void now. */
    public void disconnect(String drone) {
        table.disconnect(drone);
    }

    /** What went over the link of each robot. */
    public List<VehicleTraffic> traffic() {
        return table.traffic();
    }

    /** Messages that were none. */
    public long brokenCount() {
        return table.refusals().brokenCount();
    }

    /** Messages of kinds that robots do not send. */
    public long unknownCount() {
        return table.refusals().unknownCount();
    }

    /** Pictures that were none. */
    public long unreadableCount() {
        return table.refusals().unreadableCount();
    }

    /** Messages that were not believed to come from whom they say. */
    public long refusedCount() {
        return table.refusals().robotCount();
    }

    @Override
    public synchronized void close() {
        links.close();
    }
}
