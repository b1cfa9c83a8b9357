package org.dronemap.ws.wiring;

import java.time.Clock;
import org.dronemap.core.time.Time;
import org.dronemap.ws.account.AccountChanges;
import org.dronemap.ws.audit.AuditService;
import org.dronemap.ws.control.ControlService;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.key.AccessKeyService;
import org.dronemap.ws.organisation.GrantChanges;
import org.dronemap.ws.organisation.GrantService;
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
        ServiceConfiguration services = new ServiceConfiguration();
        GrantConfiguration granting = new GrantConfiguration();
        Clock clock = time.clock();
        SecretGenerator secrets = services.secrets();
        AccountChanges accounts = services.accounts(house);
        GrantChanges changes = granting.grantChanges(house);
        closing.add("the grants", granting.grantRounds(house));
        users = services.userService(house, accounts, house.passwords(), secrets, changes);
        grants = granting.grantService(house, changes, granting.groupService(house, changes, drones), clock);
        control = services.controlService(house, drones, accounts);
        outlet = services.outletService(house, accounts, secrets);
        audit = services.auditService(house);
        keys = services.accessKeyService(house, accounts, secrets, clock);
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
