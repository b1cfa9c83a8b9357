package org.dronemap.ws.drone;

import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.problem.DroneProblem;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.reading.NameRules;

/**
 * Lists, shows, renames and removes drones for users, and finds a drone with the check that the user may use it. Any
 * thread.
 */
public final class DroneService {
    static final int LONGEST_NAME = 60;

    private static final Set<LinkState> HEARD = EnumSet.of(LinkState.LIVE, LinkState.SUSPECT);

    private final CloudManager cloud;
    private final DroneViewMapper views;

    public DroneService(CloudManager cloud, DroneViewMapper views) {
        this.cloud = cloud;
        this.views = views;
    }

    public List<DroneView> drones(Principal principal) {
        return cloud.drones().stream()
                .filter(state -> principal.sees(state.id()))
                .map(state -> views.view(state, principal))
                .toList();
    }

    /** Those that are heard now. */
    public List<DroneView> activeDrones(Principal principal) {
        return cloud.drones().stream()
                .filter(state -> principal.sees(state.id()))
                .filter(state -> HEARD.contains(state.link().state()))
                .map(state -> views.view(state, principal))
                .toList();
    }

    public DroneView drone(Principal principal, String id) {
        return views.view(state(principal, id), principal);
    }

    public DroneView rename(Principal principal, String id, RenameRequest request) {
        DroneId drone = state(principal, id, Role.OPERATOR).id();
        cloud.rename(drone, NameRules.checked("name", request.name(), LONGEST_NAME));
        return drone(principal, id);
    }

    /** Only a lost drone goes: one in contact would come back at once. */
    public void remove(Principal principal, String id) {
        Optional<String> why =
                cloud.forget(state(principal, id, Role.ADMINISTRATOR).id());
        if (why.isPresent()) {
            throw Rejection.of(DroneProblem.DRONE_IN_CONTACT, why.get(), ProblemParameter.DRONE.is(id));
        }
    }

    /** For those who may do with it what takes that role. */
    public DroneState state(Principal principal, String id, Role needed) {
        RoleChecks.require(principal, needed);
        DroneState state = state(principal, id);
        RoleChecks.require(principal, needed, state.id());
        return state;
    }

    /** The same for those who may do what takes either role, such as plan or command. */
    public DroneState state(Principal principal, String id, Role needed, Role orElse) {
        RoleChecks.require(principal, principal.may(needed) ? needed : orElse);
        DroneState state = state(principal, id);
        RoleChecks.require(principal, principal.may(needed, state.id()) ? needed : orElse, state.id());
        return state;
    }

    /** What the asker may not see is told from what is not there by nothing. */
    public DroneState state(Principal principal, String id) {
        return find(principal, id).orElseThrow(() -> Rejection.unknown(NotFoundProblem.DRONE, id));
    }

    public Optional<DroneState> find(Principal principal, String id) {
        return parse(id).filter(principal::sees).flatMap(cloud::drone);
    }

    private static Optional<DroneId> parse(String id) {
        try {
            return Optional.of(new DroneId(id));
        } catch (IllegalArgumentException notAnId) {
            return Optional.empty();
        }
    }
}
