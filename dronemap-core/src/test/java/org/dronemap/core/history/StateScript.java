package org.dronemap.core.history;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.IdentityTrust;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.LinkStatus;
import org.dronemap.core.drone.MissionProgress;
import org.dronemap.core.drone.Motion;
import org.dronemap.core.drone.PayloadState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.drone.TextMessage;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodetic;
import org.jspecify.annotations.Nullable;

/** States of one drone as a test tells them, one after the other; time goes on by what the test says. */
final class StateScript {
    static final DroneId DRONE = new DroneId("copter-1");
    static final Instant START = Instant.parse("2026-03-04T05:06:07Z");

    private final List<TextMessage> messages = new ArrayList<>();
    private List<TextMessage> told = List.of();
    private Instant now = START;
    private Instant heard = START;
    private LinkState link = LinkState.LIVE;
    private @Nullable Boolean armed;
    private @Nullable String mode;
    private @Nullable Position position;
    private @Nullable Battery battery;
    private boolean replay;
    private double speed;
    private long version;

    StateScript after(double seconds) {
        now = now.plusNanos((long) (seconds * 1e9));
        return this;
    }

    Instant now() {
        return now;
    }

    StateScript armed(@Nullable Boolean value) {
        armed = value;
        return heard();
    }

    StateScript mode(String value) {
        mode = value;
        return heard();
    }

    StateScript link(LinkState value) {
        link = value;
        return this;
    }

    /** A recording that plays. */
    StateScript replayed() {
        replay = true;
        return this;
    }

    StateScript battery(int percent) {
        battery = new Battery(percent, null, null);
        return heard();
    }

    /** So far north of where everything begins, so high above it. */
    StateScript north(double meters, double height) {
        position = new Position(new Geodetic(47 + meters / 111_194.93, 8), 400 + height, height);
        speed = 5;
        return heard();
    }

    StateScript says(Severity severity, String text) {
        if (messages.size() == DroneState.MAX_MESSAGES) {
            messages.remove(0);
        }
        messages.add(new TextMessage(severity, text, now, null));
        told = List.copyOf(messages);
        return this;
    }

    private StateScript heard() {
        heard = now;
        return this;
    }

    DroneState state() {
        return new DroneState(
                DRONE,
                "Copter 1",
                replay,
                new LinkStatus(new DroneKey("127.0.0.1", 14601, 1), "udp", link, heard, LinkQuality.UNKNOWN, List.of()),
                new Identification(VehicleKind.MULTICOPTER, "ArduPilot", "ArduCopter", "4.5.6", null),
                IdentityTrust.UNPROVED,
                Capabilities.UNKNOWN,
                mode,
                armed,
                null,
                null,
                position,
                null,
                new Motion(speed, null, null, null),
                null,
                battery,
                null,
                null,
                null,
                PayloadState.UNKNOWN,
                MissionProgress.UNKNOWN,
                told,
                now,
                ++version,
                null);
    }
}
