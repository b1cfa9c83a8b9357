package org.dronemap.ws.server;

import java.io.InputStream;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.drone.DroneId;
import org.dronemap.proxy.record.Replay;
import org.dronemap.proxy.record.ReplayStatus;
import org.dronemap.proxy.record.Replays;
import org.dronemap.ws.reading.WireNames;
import org.dronemap.ws.recording.Recordings;
import org.dronemap.ws.recording.ReplayView;

/** Recordings as the links play them. */
record ProxyRecordings(Replays replays) implements Recordings {

    @Override
    public ReplayView start(String name, InputStream recording, long lengthBytes, double speed) {
        return view(replays.start(new Replays.Recording(name, recording, lengthBytes, speed)));
    }

    @Override
    public List<ReplayView> all() {
        return replays.all().stream().map(ProxyRecordings::view).toList();
    }

    @Override
    public Optional<ReplayView> find(String id) {
        return replays.find(id).map(ProxyRecordings::view);
    }

    @Override
    public boolean remove(String id) {
        return replays.remove(id);
    }

    private static ReplayView view(Replay replay) {
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
