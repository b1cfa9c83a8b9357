package org.dronemap.ws.organisation;

import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Size;
import java.time.Clock;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.User;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.organisation.Organisation;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.environment.EnvironmentVariables;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ServerProblem;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.NameRules;
import org.dronemap.ws.reading.SecretGenerator;
import org.dronemap.ws.zone.ZoneService;
import org.jspecify.annotations.Nullable;

/**
 * Creates, lists, renames and deletes organisations, for administrators of the server, who see counts only. Any thread.
 */
public final class OrganisationService {
    static final int LONGEST_NAME = 60;
    private static final String MOST = "DRONEMAP_ORGANISATIONS";
    private static final int USUAL = 200;
    private static final int UTMOST = 10_000;
    private static final String HOME_NAME = "Home";
    private static final String ID_FORM = "the id of an organisation";

    private final GrantChanges grants;
    private final AccessStore access;
    private final CloudManager cloud;
    private final ZoneService zones;
    private final Clock clock;
    private final int most;
    private final SecretGenerator secrets = new SecretGenerator();

    /** Request with the name of an organisation. */
    @Schema(name = "OrganisationNameRequest")
    public record NameRequest(
            @Size(min = 1, max = OrganisationService.LONGEST_NAME) @Nullable
            String name) {}

    /** An organisation as the server's administrators see it. */
    @Schema(name = "OrganisationView")
    public record OrganisationView(
            String id,
            String name,
            long users,
            long drones,
            @Nullable Instant madeAt) {}

    public OrganisationService(
            GrantChanges grants,
            AccessStore access,
            CloudManager cloud,
            ZoneService zones,
            Clock clock,
            EnvironmentVariables variables) {
        this.zones = zones;
        this.grants = grants;
        this.access = access;
        this.cloud = cloud;
        this.clock = clock;
        this.most = variables.whole(MOST, 1, UTMOST, USUAL);
    }

    /** The default one first. */
    public List<OrganisationView> organisations(Principal principal) {
        RoleChecks.requireServer(principal, Role.ADMINISTRATOR);
        List<User> users = access.users();
        List<OrganisationView> all = new ArrayList<>();
        all.add(view(OrganisationId.HOME, HOME_NAME, null, users));
        grants.holdings().organisations().forEach(each -> all.add(view(each.id(), each.name(), each.madeAt(), users)));
        return List.copyOf(all);
    }

    public OrganisationView add(Principal principal, NameRequest request) {
        RoleChecks.requireServer(principal, Role.ADMINISTRATOR);
        if (grants.holdings().organisations().size() >= most) {
            throw Rejection.of(
                    ServerProblem.LIMIT_REACHED,
                    "There are " + most + " organisations already.",
                    ProblemParameter.WHAT.is("organisations"),
                    ProblemParameter.MOST.is(most));
        }
        String id = "o"
                + secrets.token()
                        .toLowerCase(Locale.ROOT)
                        .replaceAll("[^a-z0-9]", "")
                        .substring(0, 10);
        Organisation made = new Organisation(
                new OrganisationId(id),
                free(request.name(), null),
                clock.instant().truncatedTo(ChronoUnit.MILLIS));
        grants.make(store -> store.save(made));
        return view(made.id(), made.name(), made.madeAt(), List.of());
    }

    public OrganisationView rename(Principal principal, String id, NameRequest request) {
        RoleChecks.requireServer(principal, Role.ADMINISTRATOR);
        Organisation before = find(id);
        Organisation renamed = new Organisation(before.id(), free(request.name(), before.id()), before.madeAt());
        grants.make(store -> store.save(renamed));
        return view(renamed.id(), renamed.name(), renamed.madeAt(), access.users());
    }

    /** Only when nobody and nothing belongs to it any more. */
    public void delete(Principal principal, String id) {
        RoleChecks.requireServer(principal, Role.ADMINISTRATOR);
        Organisation going = find(id);
        OrganisationView holds = view(going.id(), going.name(), going.madeAt(), access.users());
        if (holds.users() + holds.drones() > 0) {
            throw Rejection.of(
                    AccessProblem.ORGANISATION_NOT_EMPTY,
                    going.name() + " still has " + holds.users() + " users and " + holds.drones()
                            + " drones; only an empty organisation can be removed.",
                    ProblemParameter.USERS.is(holds.users()),
                    ProblemParameter.DRONES.is(holds.drones()));
        }
        zones.forget(going.id());
        grants.make(store -> store.deleteOrganisation(going.id()));
    }

    /** Null: the default one. */
    public OrganisationId named(@Nullable String id) {
        if (id == null || id.equals(OrganisationId.HOME.value())) {
            return OrganisationId.HOME;
        }
        return known(id)
                .map(Organisation::id)
                .orElseThrow(() -> InvalidInput.outside(
                        ValueProblem.REFERENCE_UNKNOWN, "organisation", ID_FORM, "\"" + id + "\""));
    }

    /** Only those who run the server invite into others than their own. */
    public OrganisationId invitedInto(Principal principal, @Nullable String id) {
        if (id == null) {
            return principal.organisation();
        }
        RoleChecks.requireServer(principal, Role.ADMINISTRATOR);
        return named(id);
    }

    /** Whether that drone has changed hands since. */
    public boolean wasGiven(DroneId drone, Instant since) {
        return grants.book()
                .lastGift(drone)
                .filter(gift -> gift.at().isAfter(since))
                .isPresent();
    }

    public void enrolled(DroneId drone, OrganisationId owner) {
        if (!grants.book().owner(drone).equals(owner)) {
            grants.make(store -> store.assign(drone, owner));
        }
    }

    /** A name that no other one has, whichever case it is written in. */
    private String free(@Nullable String name, @Nullable OrganisationId own) {
        String checked = NameRules.checked("name", name, LONGEST_NAME);
        boolean taken = HOME_NAME.equalsIgnoreCase(checked)
                || grants.holdings().organisations().stream()
                        .anyMatch(each -> each.name().equalsIgnoreCase(checked)
                                && !each.id().equals(own));
        if (taken) {
            throw Rejection.of(
                    AccessProblem.NAME_TAKEN,
                    "There is an organisation " + checked + " already.",
                    ProblemParameter.NAME.is(checked));
        }
        return checked;
    }

    Organisation find(String id) {
        return known(id).orElseThrow(() -> Rejection.unknown(NotFoundProblem.ORGANISATION, id));
    }

    private Optional<Organisation> known(String id) {
        return grants.holdings().organisations().stream()
                .filter(each -> each.id().value().equals(id))
                .findFirst();
    }

    private OrganisationView view(OrganisationId id, String name, @Nullable Instant madeAt, List<User> users) {
        return new OrganisationView(
                id.value(),
                name,
                users.stream().filter(user -> user.organisation().equals(id)).count(),
                cloud.drones().stream()
                        .filter(drone -> grants.book().owner(drone.id()).equals(id))
                        .count(),
                madeAt);
    }
}
