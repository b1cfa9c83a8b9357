package org.dronemap.ws.server;

import java.io.InputStream;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.drone.DroneId;
import org.dronemap.proxy.record.RecordingReplay;
import org.dronemap.proxy.record.ReplayRegistry;
import org.dronemap.proxy.record.ReplayStatus;
import org.dronemap.ws.reading.WireNames;
import org.dronemap.ws.recording.ReplayGateway;
import org.dronemap.ws.recording.ReplayView;

/** Adapter that has the proxy play recordings back for the services. */
record ProxyReplayGateway(ReplayRegistry replays) implements ReplayGateway {

    @Override
    public ReplayView start(String name, InputStream recording, long lengthBytes, double speed) {
        return view(replays.start(new ReplayRegistry.Source(name, recording, lengthBytes, speed)));
    }

    @Override
    public List<ReplayView> all() {
        return replays.all().stream().map(ProxyReplayGateway::view).toList();
    }

    @Override
    public Optional<ReplayView> find(String id) {
        return replays.find(id).map(ProxyReplayGateway::view);
    }

    @Override
    public boolean remove(String id) {
        return replays.remove(id);
    }

    private static ReplayView view(RecordingReplay replay) {
        ReplayStatus status = replay.status();
        return new ReplayView(
                status.id(),
                status.name(),
                status.speed(),
                status.drones().stream().map(DroneId::value).toList(),
                WireNames.camel(status.state()),
                status.records(),
                status.goodMessages(),
                status.brokenRuns(),
                status.brokenBytes(),
                status.progress(),
                status.failure());
    }
}
