package org.dronemap.ws.soap;

import java.util.List;
import org.dronemap.ws.service.RobotKeyService;
import org.dronemap.ws.service.RobotKeyService.RobotKeyRequest;

/** Keys of robots over SOAP. Any thread. */
public final class SoapRobotKeys {
    private final SoapCaller caller;
    private final RobotKeyService keys;

    public SoapRobotKeys(SoapCaller caller, RobotKeyService keys) {
        this.caller = caller;
        this.keys = keys;
    }

    List<SoapRobotKey> all() {
        return keys.keys(caller.reading()).stream().map(SoapRobotKey::of).toList();
    }

    SoapRobotKey issue(RobotKeyRequest request) {
        return SoapRobotKey.of(keys.issue(caller.reading(), request));
    }

    void revoke(String id) {
        keys.revoke(caller.reading(), id);
    }
}
