package org.dronemap.ws.organisation;

import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Size;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.UUID;
import java.util.stream.Stream;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.Fleet;
import org.dronemap.core.access.GrantStore;
import org.dronemap.core.access.GrantSubject;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.UserGroup;
import org.dronemap.core.drone.DroneId;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ServerProblem;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.NameRules;
import org.jspecify.annotations.Nullable;

/**
 * Manages named groups of users and named fleets of drones, for the administrators of their organisation. Any thread.
 */
public final class GroupService {
    static final int LONGEST_NAME = 60;
    static final int MOST = 500;
    private static final String MEMBERS = "names of users, at most " + MOST;
    private static final String DRONES = "ids of drones, at most " + MOST;

    private final GrantChanges grants;
    private final AccessStore access;
    private final DroneService drones;

    /** A group as an administrator writes it; without members it is empty. */
    @Schema(name = "GroupRequest")
    public record GroupRequest(
            @Size(min = 1, max = GroupService.LONGEST_NAME) @Nullable
            String name,

            @Size(max = GroupService.MOST) @Nullable List<@Nullable String> members) {}

    /** A fleet as an administrator writes it; without drones it is empty. */
    @Schema(name = "FleetRequest")
    public record FleetRequest(
            @Size(min = 1, max = GroupService.LONGEST_NAME) @Nullable
            String name,

            @Size(max = GroupService.MOST) @Nullable List<@Nullable String> drones) {}

    /** A group; {@code onlyGranted}: its members see nothing but what they, or it, were granted. */
    @Schema(name = "GroupView")
    public record GroupView(String id, String name, List<String> members, boolean onlyGranted) {}

    /** A fleet. */
    @Schema(name = "FleetView")
    public record FleetView(String id, String name, List<String> drones) {
        static FleetView of(Fleet fleet) {
            return new FleetView(
                    fleet.id(),
                    fleet.name(),
                    fleet.drones().stream().map(DroneId::value).sorted().toList());
        }
    }

    public GroupService(GrantChanges grants, AccessStore access, DroneService drones) {
        this.grants = grants;
        this.access = access;
        this.drones = drones;
    }

    public List<GroupView> groups(Principal principal) {
        RoleChecks.requireForAll(principal, Role.ADMINISTRATOR);
        return groupsOf(principal).map(this::view).toList();
    }

    public GroupView addGroup(Principal principal, GroupRequest request) {
        RoleChecks.requireForAll(principal, Role.ADMINISTRATOR);
        requireRoom(groupsOf(principal).count());
        return save(principal, UUID.randomUUID().toString(), request);
    }

    public GroupView replaceGroup(Principal principal, String id, GroupRequest request) {
        RoleChecks.requireForAll(principal, Role.ADMINISTRATOR);
        return save(principal, group(principal, id).id(), request);
    }

    /** With what was granted to it; whoever saw nothing else sees nothing then. */
    public void deleteGroup(Principal principal, String id) {
        RoleChecks.requireForAll(principal, Role.ADMINISTRATOR);
        UserGroup going = group(principal, id);
        grants.make(store -> {
            keepBound(store, going, Set.of());
            store.deleteGroup(going.id());
        });
    }

    public List<FleetView> fleets(Principal principal) {
        RoleChecks.requireForAll(principal, Role.ADMINISTRATOR);
        return fleetsOf(principal).map(FleetView::of).toList();
    }

    public FleetView addFleet(Principal principal, FleetRequest request) {
        RoleChecks.requireForAll(principal, Role.ADMINISTRATOR);
        requireRoom(fleetsOf(principal).count());
        return save(principal, UUID.randomUUID().toString(), request);
    }

    public FleetView replaceFleet(Principal principal, String id, FleetRequest request) {
        RoleChecks.requireForAll(principal, Role.ADMINISTRATOR);
        return save(principal, fleet(principal, id).id(), request);
    }

    /** With all grants of it. */
    public void deleteFleet(Principal principal, String id) {
        RoleChecks.requireForAll(principal, Role.ADMINISTRATOR);
        String going = fleet(principal, id).id();
        grants.make(store -> store.deleteFleet(going));
    }

    UserGroup group(Principal principal, String id) {
        return groupsOf(principal)
                .filter(group -> group.id().equals(id))
                .findFirst()
                .orElseThrow(() -> Rejection.unknown(NotFoundProblem.GROUP, id));
    }

    Fleet fleet(Principal principal, String id) {
        return fleetsOf(principal)
                .filter(fleet -> fleet.id().equals(id))
                .findFirst()
                .orElseThrow(() -> Rejection.unknown(NotFoundProblem.FLEET, id));
    }

    private GroupView save(Principal principal, String id, GroupRequest request) {
        UserGroup group = new UserGroup(
                id,
                principal.organisation(),
                NameRules.checked("name", request.name(), LONGEST_NAME),
                members(principal, request.members()));
        if (isOnlyGranted(id) && group.members().contains(principal.name())) {
            throw Rejection.of(
                    AccessProblem.NOT_TO_ONESELF,
                    "The members of this group see only what they were granted; you cannot do this" + " to yourself.");
        }
        grants.make(store -> {
            grants.holdings().groups().stream()
                    .filter(before -> before.id().equals(id))
                    .forEach(before -> keepBound(store, before, group.members()));
            store.save(group);
        });
        return view(group);
    }

    /** Who leaves a group whose members see only what was granted sees no more for that, until somebody says so. */
    private void keepBound(GrantStore store, UserGroup group, Set<String> staying) {
        if (isOnlyGranted(group.id())) {
            group.members().stream()
                    .filter(member -> !staying.contains(member))
                    .forEach(leaving -> store.setOnlyGranted(new GrantSubject.OfUser(leaving), true));
        }
    }

    private FleetView save(Principal principal, String id, FleetRequest request) {
        Fleet fleet = new Fleet(
                id,
                principal.organisation(),
                NameRules.checked("name", request.name(), LONGEST_NAME),
                drones(principal, request.drones()));
        grants.make(store -> store.save(fleet));
        return FleetView.of(fleet);
    }

    private Set<String> members(Principal principal, @Nullable List<@Nullable String> names) {
        Set<String> members = new LinkedHashSet<>();
        for (String name : checked("members", MEMBERS, names)) {
            if (access.user(name)
                    .filter(user -> user.organisation().equals(principal.organisation()))
                    .isEmpty()) {
                throw InvalidInput.outside(ValueProblem.REFERENCE_UNKNOWN, "members", MEMBERS, "\"" + name + "\"");
            }
            members.add(name);
        }
        return members;
    }

    /** Such as the asker sees; what is out of reach is told from what is not there by nothing. */
    Set<DroneId> drones(Principal principal, @Nullable List<@Nullable String> ids) {
        Set<DroneId> found = new LinkedHashSet<>();
        for (String id : checked("drones", DRONES, ids)) {
            found.add(drones.find(principal, id)
                    .orElseThrow(() ->
                            InvalidInput.outside(ValueProblem.REFERENCE_UNKNOWN, "drones", DRONES, "\"" + id + "\""))
                    .id());
        }
        return found;
    }

    private static List<String> checked(String field, String allowed, @Nullable List<@Nullable String> given) {
        List<@Nullable String> all = given == null ? List.of() : given;
        if (all.size() > MOST) {
            throw InvalidInput.outside(
                    ValueProblem.SIZE_OUT_OF_RANGE,
                    field,
                    allowed,
                    all.size() + " of them",
                    ProblemParameter.MOST.is(MOST));
        }
        return all.stream().map(String::valueOf).toList();
    }

    private static void requireRoom(long there) {
        if (there >= MOST) {
            throw Rejection.of(
                    ServerProblem.LIMIT_REACHED,
                    "There are " + MOST + " already; remove some first.",
                    ProblemParameter.WHAT.is("groups or fleets"),
                    ProblemParameter.MOST.is(MOST));
        }
    }

    private Stream<UserGroup> groupsOf(Principal principal) {
        return grants.holdings().groups().stream()
                .filter(group -> group.organisation().equals(principal.organisation()));
    }

    private Stream<Fleet> fleetsOf(Principal principal) {
        return grants.holdings().fleets().stream()
                .filter(fleet -> fleet.organisation().equals(principal.organisation()));
    }

    private GroupView view(UserGroup group) {
        return new GroupView(
                group.id(), group.name(), group.members().stream().sorted().toList(), isOnlyGranted(group.id()));
    }

    private boolean isOnlyGranted(String group) {
        return grants.holdings().onlyGranted().contains(new GrantSubject.OfGroup(group));
    }
}
