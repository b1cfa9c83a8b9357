package org.dronemap.ws.server;

import java.util.Optional;
import org.dronemap.core.link.RobotKey;
import org.dronemap.proxy.roslink.RobotKeys;
import org.dronemap.ws.robotkey.RobotKeyRing;

/** Lets the ROSLink proxy check keys of robots against those that administrators have issued. */
record IssuedRobotKeys(RobotKeyRing ring) implements RobotKeys {
    @Override
    public Optional<RobotKey> find(String key) {
        return ring.find(key);
    }

    @Override
    public boolean isOfIssuedForm(String key) {
        return ring.isOfThisForm(key);
    }

    @Override
    public boolean isValid(RobotKey key) {
        return ring.isValid(key);
    }
}
