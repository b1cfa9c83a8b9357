package org.dronemap.ws.lab;

import java.util.Arrays;
import java.util.List;
import org.dronemap.core.access.Role;
import org.dronemap.ws.organisation.GrantService.GrantRequest;
import org.dronemap.ws.organisation.GrantService.OnlyGrantedRequest;
import org.dronemap.ws.outlet.OutletView;
import org.dronemap.ws.user.UserService;

/** Who says what the users of the laboratory's server may do. */
public final class Administrator {
    private final Laboratory lab;
    private final Pilot account;

    Administrator(Laboratory lab) {
        this.lab = lab;
        account = lab.pilot("the administrator", Role.ADMINISTRATOR);
    }

    public Pilot account() {
        return account;
    }

    /** A user with that role who sees these drones and no other. */
    public Pilot granted(String name, Role role, LabDrone... drones) {
        Pilot user = lab.pilot(name, role);
        onlyGranted(user);
        String unused = grants(user, drones);
        return user;
    }

    public void onlyGranted(Pilot user) {
        lab.server()
                .accounts()
                .grants()
                .setUserOnlyGranted(account.principal(), user.name(), new OnlyGrantedRequest(true));
    }

    /** The id of the grant: to look at all of them, and unless it is a viewer's to plan for them and command them. */
    public String grants(Pilot user, LabDrone... drones) {
        List<String> operations = user.role() == Role.VIEWER ? List.of("view") : List.of("view", "plan", "command");
        List<String> ids =
                Arrays.stream(drones).map(drone -> drone.id().value()).toList();
        GrantRequest request = new GrantRequest(user.name(), null, null, null, ids, null, operations, null, null);
        return lab.server()
                .accounts()
                .grants()
                .add(account.principal(), request)
                .id();
    }

    public void takesBack(String grant) {
        lab.server().accounts().grants().revoke(account.principal(), grant);
    }

    public void disables(Pilot user) {
        var unused = lab.server()
                .accounts()
                .users()
                .change(account.principal(), user.name(), new UserService.Change(null, "disabled"));
    }

    /** How the outlet is doing. */
    public OutletView outlet() {
        return lab.server().accounts().outlet().all(account.principal());
    }

    /** That user's programs that are attached. */
    public List<OutletView.ClientView> clients(Pilot user) {
        return outlet().clients().stream()
                .filter(client -> client.user().equals(user.name()))
                .toList();
    }

    public void disconnects(String client) {
        lab.server().accounts().outlet().disconnect(account.principal(), client);
    }
}
