package org.dronemap.ws.lab;

import java.util.HashSet;
import java.util.Set;
import org.dronemap.sim.link.ServerAddress;
import org.dronemap.sim.robot.BridgeQuirk;
import org.dronemap.sim.robot.RobotOptions;
import org.jspecify.annotations.Nullable;

/**
 * What a robot of the laboratory is made of.
 *
 * @param kind rover or drone
 * @param key what it shows of itself
 * @param patience seconds of silence after which it makes itself safe; 0: never
 * @param path to which it opens a WebSocket beside UDP; null: it has none
 */
public record RobotSpec(
        String kind,
        int systemId,
        String key,
        double patience,
        @Nullable String path,
        Set<BridgeQuirk> quirks) {
    private static final double MOTION_HERTZ = 5;
    private static final ServerAddress ANY = new ServerAddress(false, "127.0.0.1", 25_500);

    /** One on wheels that reports as ground robots' bridges do. */
    public static RobotSpec rover(int systemId) {
        return new RobotSpec("rover", systemId, "key-" + systemId, 0, null, Set.of(BridgeQuirk.STATUS_IS_HEARTBEAT));
    }

    /** One whose flight controller stands behind mavros. */
    public static RobotSpec flyer(int systemId) {
        return new RobotSpec("drone", systemId, "key-" + systemId, 0, null, Set.of());
    }

    public RobotSpec with(BridgeQuirk... others) {
        Set<BridgeQuirk> all = new HashSet<>(quirks);
        all.addAll(Set.of(others));
        return new RobotSpec(kind, systemId, key, patience, path, all);
    }

    public RobotSpec showing(String other) {
        return new RobotSpec(kind, systemId, other, patience, path, quirks);
    }

    public RobotSpec onWeb(String opened) {
        return new RobotSpec(kind, systemId, key, patience, opened, quirks);
    }

    /** One that makes itself safe after so many seconds without the server. */
    public RobotSpec missing(double seconds) {
        return new RobotSpec(kind, systemId, key, seconds, path, quirks);
    }

    RobotOptions options() {
        RobotOptions.Identity identity = new RobotOptions.Identity(systemId, key, null);
        return new RobotOptions(1, kind, ANY, null, identity, MOTION_HERTZ, patience, quirks);
    }
}
