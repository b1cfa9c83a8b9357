package org.dronemap.ws.soap;

import static org.dronemap.ws.soap.Answering.answer;

import java.util.List;
import org.dronemap.ws.service.RobotKeyService.RobotKeyRequest;
import org.jspecify.annotations.Nullable;

/** The operations of the SOAP service around the keys of robots. Any thread. */
abstract class RobotKeyCalls implements MAVLinkController {
    private final SoapRobotKeys keys;

    RobotKeyCalls(SoapRobotKeys keys) {
        this.keys = keys;
    }

    @Override
    public List<SoapRobotKey> getRobotKeysList() throws DronemapFault {
        return answer(keys::all);
    }

    @Override
    public SoapRobotKey issueRobotKey(
            @Nullable String robotKeyId,
            @Nullable String label,
            @Nullable Integer systemId,
            @Nullable String owner,
            @Nullable String organisation)
            throws DronemapFault {
        return answer(() -> keys.issue(new RobotKeyRequest(label, systemId, owner, organisation, robotKeyId)));
    }

    @Override
    public void revokeRobotKey(String robotKeyId) throws DronemapFault {
        answer(() -> {
            keys.revoke(robotKeyId);
            return robotKeyId;
        });
    }
}
