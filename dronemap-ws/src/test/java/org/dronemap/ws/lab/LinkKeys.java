package org.dronemap.ws.lab;

import java.util.HexFormat;
import java.util.Objects;
import org.dronemap.core.drone.DroneId;
import org.dronemap.ws.link.LinkSecurityService;
import org.dronemap.ws.link.LinkSecurityService.LinkKeyRequest;
import org.dronemap.ws.link.LinkSecurityService.PolicyRequest;
import org.dronemap.ws.link.LinkSecurityView;

/** What an administrator does about the key of one drone. */
public final class LinkKeys {
    private final Laboratory lab;
    private final Pilot administrator;
    private final String drone;

    public LinkKeys(Laboratory lab, Pilot administrator, DroneId drone) {
        this.lab = lab;
        this.administrator = administrator;
        this.drone = drone.value();
    }

    private LinkSecurityService service() {
        return lab.server().office().linkSecurity();
    }

    public LinkSecurityView view() {
        return service().look(administrator.principal(), drone);
    }

    public LinkSecurityView.Messages counts() {
        return view().messages();
    }

    public LinkSecurityView.Key key() {
        return Objects.requireNonNull(view().key(), "there is no key");
    }

    public byte[] make() {
        return HexFormat.of()
                .parseHex(service()
                        .makeKey(administrator.principal(), drone, new LinkKeyRequest(null))
                        .key());
    }

    /** A key that the vehicle signs with from now on. */
    public byte[] install() {
        byte[] key = make();
        LinkSecurityView installed = service().install(administrator.principal(), drone, null);
        if (!Objects.requireNonNull(installed.key()).inUse()) {
            throw new AssertionError("The vehicle does not use its key: " + installed);
        }
        return key;
    }

    public LinkSecurityView rotate() {
        return service().rotate(administrator.principal(), drone, null);
    }

    public LinkSecurityView revoke() {
        return service().revoke(administrator.principal(), drone, true);
    }

    public LinkSecurityView policy(String policy) {
        return service().setPolicy(administrator.principal(), drone, new PolicyRequest(policy));
    }
}
