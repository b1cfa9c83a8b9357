package org.dronemap.proxy;

import java.io.IOException;
import java.util.List;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.lane.Lanes;
import org.dronemap.core.time.Time;
import org.dronemap.proxy.endpoint.EndpointCounters;
import org.dronemap.proxy.endpoint.EndpointRegistry;
import org.dronemap.proxy.endpoint.EndpointSecurity;
import org.dronemap.proxy.endpoint.EndpointUrl;
import org.dronemap.proxy.endpoint.PeerHandler;
import org.dronemap.proxy.record.ReplayRegistry;
import org.dronemap.proxy.session.Enrolment;
import org.dronemap.proxy.session.FrameTap;
import org.dronemap.proxy.session.IdentificationRateLimiter;
import org.dronemap.proxy.session.SessionDependencies;
import org.dronemap.proxy.session.VehicleSessionRegistry;
import org.dronemap.proxy.session.VehicleTraffic;
import org.dronemap.proxy.signing.KeyringRegistry;

/**
 * Opens the endpoints that MAVLink vehicles connect to, and owns their sessions, signing keys and replays. Any thread.
 */
public final class MavlinkConnector implements AutoCloseable {
    private final List<EndpointUrl> urls;
    private final KeyringRegistry keyrings;
    private final VehicleSessionRegistry sessions;
    private final ReplayRegistry replays;
    private final EndpointRegistry links;

    /** One endpoint with its counts. */
    public record EndpointStatus(EndpointUrl url, EndpointCounters.Counts counts) {}

    /**
     * The rules and collaborators that sessions of vehicles are made with.
     *
     * @param keyrings the keys that vehicles sign with
     * @param taps hear every frame of every session
     * @param doors what links are guarded with
     * @param enrolment from where strangers come in
     */
    public record Policy(
            KeyringRegistry keyrings, FrameTap.Factory taps, EndpointSecurity doors, Enrolment enrolment) {}

    public MavlinkConnector(CloudManager cloud, Lanes lanes, List<EndpointUrl> urls, Policy policy, Time time) {
        this.urls = List.copyOf(urls);
        this.keyrings = policy.keyrings();
        sessions = new VehicleSessionRegistry(new SessionDependencies(
                cloud,
                lanes,
                time::nanos,
                keyrings,
                policy.taps(),
                policy.enrolment(),
                new IdentificationRateLimiter(),
                policy.doors().watch()));
        replays = new ReplayRegistry(sessions, time);
        links = new EndpointRegistry(sessions, policy.doors(), time);
    }

    /**
     * Opens all configured endpoints or none; those that dial may find nobody yet.
     *
     * @throws IOException with a sentence that says which one and why
     */
    public synchronized void start() throws IOException {
        try {
            for (int number = 0; number < urls.size(); number++) {
                links.open("configured-" + (number + 1), urls.get(number));
            }
        } catch (IOException e) {
            close();
            throw e;
        }
    }

    /** The endpoints, configured or added since. */
    public EndpointRegistry links() {
        return links;
    }

    public List<EndpointStatus> endpoints() {
        return links.all().stream()
                .map(link -> new EndpointStatus(link.url(), link.counts()))
                .toList();
    }

    /** What went over the link of each vehicle. */
    public List<VehicleTraffic> traffic() {
        return sessions.traffic();
    }

    /** Recordings that play or have played. */
    public ReplayRegistry replays() {
        return replays;
    }

    /** The keys of vehicles. */
    public KeyringRegistry keyrings() {
        return keyrings;
    }

    /** Who takes in what new links bring. */
    public PeerHandler.Factory handlers() {
        return sessions;
    }

    /** Vehicles on links now. */
    public int sessionCount() {
        return sessions.openCount();
    }

    @Override
    public synchronized void close() {
        replays.close();
        links.close();
    }
}
