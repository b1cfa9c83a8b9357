package org.dronemap.core.cloud;

import java.util.Optional;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.event.DroneEvent;
import org.jspecify.annotations.Nullable;

/** A drone with its link and liveness. Owned by its lane, except where a method says otherwise. */
final class ManagedDrone implements Lane.Ticker {
    private final Drone drone;
    private final Lane lane;
    private final Liveness liveness;
    private final CloudListener listener;
    private @Nullable LinkSession session;
    private boolean played;

    ManagedDrone(Drone drone, Lane lane, Watchdog watchdog, CloudListener listener) {
        this.drone = drone;
        this.lane = lane;
        this.liveness = new Liveness(watchdog);
        this.listener = listener;
    }

    Drone drone() {
        return drone;
    }

    DroneId id() {
        return drone.state().id();
    }

    Lane lane() {
        return lane;
    }

    /** The way down; empty when no link ever came up since the start. */
    Optional<VehicleChannel> channel() {
        return session == null || session.replay() ? Optional.empty() : Optional.of(session.channel());
    }

    void attach(LinkSession newSession) {
        session = newSession;
        drone.attach(newSession);
        listener.droneChanged(drone.state());
    }

    /** News of an old session are nobody's news. */
    boolean isAttachedTo(LinkSession candidate) {
        return candidate.equals(session);
    }

    void heard() {
        liveness.heard(lane.activeNanos());
        drone.heard();
        judge();
    }

    void accept(DroneEvent event) {
        heard();
        drone.apply(event);
        listener.droneChanged(drone.state());
    }

    void measured(LinkQuality quality) {
        drone.measured(quality);
        listener.droneChanged(drone.state());
    }

    /** Its recording is over. */
    void played() {
        played = true;
        judge();
    }

    void say(Severity severity, String text) {
        drone.say(severity, text);
        listener.droneChanged(drone.state());
    }

    void rename(String name) {
        drone.rename(name);
        listener.droneChanged(drone.state());
    }

    @Override
    public void tick() {
        judge();
        if (liveness.probeDue(lane.activeNanos())) {
            channel().ifPresent(VehicleChannel::probe);
        }
    }

    private void judge() {
        LinkState before = drone.state().link().state();
        LinkState now = played ? LinkState.ENDED : liveness.judge(lane.activeNanos());
        if (!drone.linkState(now)) {
            return;
        }
        if (now == LinkState.LOST) {
            drone.say(Severity.CRITICAL, "Contact lost.");
        } else if (before == LinkState.LOST && now == LinkState.LIVE) {
            drone.say(Severity.NOTICE, "Contact is there.");
        }
        listener.droneChanged(drone.state());
    }
}
