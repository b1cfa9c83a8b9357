package org.dronemap.ws.wiring;

import java.time.Clock;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.time.Time;
import org.dronemap.ws.account.AccountChanges;
import org.dronemap.ws.audit.AuditService;
import org.dronemap.ws.control.ControlService;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.key.AccessKeyService;
import org.dronemap.ws.organisation.GrantChanges;
import org.dronemap.ws.organisation.GrantService;
import org.dronemap.ws.organisation.GroupService;
import org.dronemap.ws.outlet.OutletGateway;
import org.dronemap.ws.outlet.OutletService;
import org.dronemap.ws.reading.SecretGenerator;
import org.dronemap.ws.server.ServerComponents;
import org.dronemap.ws.server.ShutdownSequence;
import org.dronemap.ws.user.UserService;

/** The use cases of a {@link SteppedServer} around users: who they are, what they may do and have done, and what they attach. */
public final class SteppedAccountServices {
    private final UserService users;
    private final GrantService grants;
    private final ControlService control;
    private final OutletService outlet;
    private final AuditService audit;
    private final AccessKeyService keys;

    SteppedAccountServices(ServerComponents house, DroneService drones, Time time, ShutdownSequence closing) {
        Clock clock = time.clock();
        SecretGenerator secrets = new SecretGenerator();
        AccessStore access = house.access();
        AccountChanges accounts = new AccountChanges(access);
        GrantChanges changes = new GrantChanges(house.grants(), house.grantBook());
        closing.add("the grants", changes.announceRegularly(time));
        users = new UserService(access, accounts, house.passwords(), secrets, changes);
        grants = new GrantService(changes, access, new GroupService(changes, access, drones), clock);
        OutletGateway gateway = house.links().outlet();
        control = new ControlService(house.cloud(), drones, access, accounts, house.grantBook(), gateway);
        outlet = new OutletService(gateway, access, accounts, secrets);
        audit = new AuditService(house.audit().store(), house.audit().keeper(), house.audit()::verify);
        keys = new AccessKeyService(access, accounts, secrets, clock);
    }

    public UserService users() {
        return users;
    }

    public GrantService grants() {
        return grants;
    }

    public ControlService control() {
        return control;
    }

    public OutletService outlet() {
        return outlet;
    }

    public AccessKeyService keys() {
        return keys;
    }

    public AuditService audit() {
        return audit;
    }
}
