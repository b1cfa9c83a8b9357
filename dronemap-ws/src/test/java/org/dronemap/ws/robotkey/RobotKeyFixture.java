package org.dronemap.ws.robotkey;

import org.dronemap.core.link.RobotKey;

/** Gives a vehicle that is there the key of a robot, which otherwise it would have from its first word on. */
public final class RobotKeyFixture {
    private RobotKeyFixture() {}

    public static void keep(RobotKeyRing ring, RobotKey key) {
        ring.put(key);
    }
}
