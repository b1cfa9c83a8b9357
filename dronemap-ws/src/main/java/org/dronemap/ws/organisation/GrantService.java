package org.dronemap.ws.organisation;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Clock;
import java.time.DateTimeException;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.UUID;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.Grant;
import org.dronemap.core.access.GrantObject;
import org.dronemap.core.access.GrantSubject;
import org.dronemap.core.access.Permission;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneId;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.key.AccessKeyRequest;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ServerProblem;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/** Lets administrators of an organisation grant users and groups rights on drones, and take them back. Any thread. */
public final class GrantService {
    private static final int MOST = 2_000;
    private static final String ONE_SUBJECT = "a user or a group, and not both";
    private static final String ONE_OBJECT = "one of drones, fleet, \"virtual\": true or \"all\": true";
    private static final String MOMENT = "a time such as 2026-07-01T12:00:00Z";

    private final GrantChanges grants;
    private final AccessStore access;
    private final GroupService groups;
    private final Clock clock;

    /** A grant as an administrator writes it; from now on, and without end, unless it says otherwise. */
    @Schema(name = "GrantRequest")
    public record GrantRequest(
            @Nullable String user,
            @Nullable String group,
            @Nullable Boolean all,
            @Nullable Boolean virtual,
            @Nullable List<@Nullable String> drones,
            @Nullable String fleet,
            @EnumValues(Permission.class) @Nullable List<@Nullable String> operations,
            @Nullable String from,
            @Nullable String until) {}

    /** Request to restrict a user or group to the drones granted to it, or to end that restriction. */
    @Schema(name = "OnlyGrantedRequest")
    public record OnlyGrantedRequest(@Nullable Boolean onlyGranted) {}

    /**
     * A grant as administrators see it.
     *
     * @param virtual the user's own virtual drones alone
     * @param drones null: not by their ids
     * @param state inForce, toCome or over
     */
    @Schema(name = "GrantView")
    public record GrantView(
            String id,
            @Nullable String user,
            @Nullable String group,
            boolean all,
            boolean virtual,
            @Nullable List<String> drones,
            @Nullable String fleet,
            @EnumValues(Permission.class) List<String> operations,
            Instant from,
            @Nullable Instant until,

            @Schema(allowableValues = {"inForce", "toCome", "over"})
            String state,

            String by,
            Instant at) {}

    public GrantService(GrantChanges grants, AccessStore access, GroupService groups, Clock clock) {
        this.grants = grants;
        this.access = access;
        this.groups = groups;
        this.clock = clock;
    }

    /** Oldest first. */
    public List<GrantView> grants(Principal principal) {
        RoleChecks.requireForAll(principal, Role.ADMINISTRATOR);
        Instant now = clock.instant();
        return of(principal).stream().map(grant -> view(grant, now)).toList();
    }

    public GrantView add(Principal principal, GrantRequest request) {
        RoleChecks.requireForAll(principal, Role.ADMINISTRATOR);
        if (of(principal).size() >= MOST) {
            throw Rejection.of(
                    ServerProblem.LIMIT_REACHED,
                    "There are " + MOST + " grants; take back some first.",
                    ProblemParameter.WHAT.is("grants"),
                    ProblemParameter.MOST.is(MOST));
        }
        Instant now = clock.instant().truncatedTo(ChronoUnit.MILLIS);
        Instant from = request.from() == null ? now : moment("from", request.from());
        Instant until = request.until() == null ? null : moment("until", request.until());
        if (until != null && (!until.isAfter(from) || !until.isAfter(now))) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_OUT_OF_RANGE, "until", "later than its beginning, and than now", until);
        }
        List<@Nullable String> operations = request.operations();
        if (operations == null || operations.isEmpty()) {
            throw InvalidInput.missing("operations", AccessKeyRequest.OPERATIONS);
        }
        Grant grant = new Grant(
                UUID.randomUUID().toString(),
                principal.organisation(),
                subject(principal, request),
                object(principal, request),
                AccessKeyRequest.permissions(operations),
                from,
                until,
                principal.name(),
                now);
        grants.make(store -> store.add(grant));
        return view(grant, now);
    }

    /** Gone at once, on open streams too. */
    public void revoke(Principal principal, String id) {
        RoleChecks.requireForAll(principal, Role.ADMINISTRATOR);
        String going = of(principal).stream()
                .map(Grant::id)
                .filter(id::equals)
                .findFirst()
                .orElseThrow(() -> Rejection.unknown(NotFoundProblem.GRANT, id));
        grants.make(store -> store.deleteGrant(going));
    }

    public void setUserOnlyGranted(Principal principal, String name, OnlyGrantedRequest request) {
        RoleChecks.requireForAll(principal, Role.ADMINISTRATOR);
        boolean only = only(request);
        if (!isOf(principal, name)) {
            throw Rejection.unknown(NotFoundProblem.USER, name);
        }
        if (only && name.equals(principal.name())) {
            throw Rejection.of(
                    AccessProblem.NOT_TO_ONESELF, "You cannot do this to yourself; ask another administrator.");
        }
        grants.make(store -> store.setOnlyGranted(new GrantSubject.OfUser(name), only));
    }

    public void setGroupOnlyGranted(Principal principal, String id, OnlyGrantedRequest request) {
        RoleChecks.requireForAll(principal, Role.ADMINISTRATOR);
        boolean only = only(request);
        if (groups.group(principal, id).members().contains(principal.name()) && only) {
            throw Rejection.of(AccessProblem.NOT_TO_ONESELF, "You are in this group, and cannot do this to yourself.");
        }
        grants.make(store -> store.setOnlyGranted(new GrantSubject.OfGroup(id), only));
    }

    private static boolean only(OnlyGrantedRequest request) {
        if (request.onlyGranted() == null) {
            throw InvalidInput.missing("onlyGranted", "true or false");
        }
        return request.onlyGranted();
    }

    private List<Grant> of(Principal principal) {
        return grants.holdings().grants().stream()
                .filter(grant -> grant.organisation().equals(principal.organisation()))
                .toList();
    }

    private GrantSubject subject(Principal principal, GrantRequest request) {
        String user = request.user();
        String group = request.group();
        if ((user == null) == (group == null)) {
            throw new InvalidInput(
                    ValueProblem.VALUES_EXCLUSIVE, "user", ONE_SUBJECT, "A grant is for " + ONE_SUBJECT + ".");
        }
        if (group != null) {
            return new GrantSubject.OfGroup(groups.group(principal, group).id());
        }
        if (user == null || !isOf(principal, user)) {
            throw InvalidInput.outside(
                    ValueProblem.REFERENCE_UNKNOWN, "user", "the name of a user", "\"" + user + "\"");
        }
        return new GrantSubject.OfUser(user);
    }

    private boolean isOf(Principal principal, String user) {
        return access.user(user)
                .filter(known -> known.organisation().equals(principal.organisation()))
                .isPresent();
    }

    private GrantObject object(Principal principal, GrantRequest request) {
        boolean all = Boolean.TRUE.equals(request.all());
        boolean virtual = Boolean.TRUE.equals(request.virtual());
        String fleet = request.fleet();
        List<@Nullable String> drones = request.drones();
        if ((all ? 1 : 0) + (virtual ? 1 : 0) + (fleet == null ? 0 : 1) + (drones == null ? 0 : 1) != 1) {
            throw new InvalidInput(
                    ValueProblem.VALUES_EXCLUSIVE, "drones", ONE_OBJECT, "A grant needs " + ONE_OBJECT + ".");
        }
        if (fleet != null) {
            return new GrantObject.OfFleet(groups.fleet(principal, fleet).id());
        }
        if (drones == null) {
            return virtual ? new GrantObject.Virtual() : new GrantObject.Everything();
        }
        if (drones.isEmpty()) {
            throw InvalidInput.missing("drones", "ids of drones");
        }
        return new GrantObject.Drones(groups.drones(principal, drones));
    }

    private static Instant moment(String field, String text) {
        try {
            return OffsetDateTime.parse(text).toInstant().truncatedTo(ChronoUnit.MILLIS);
        } catch (DateTimeException e) {
            throw InvalidInput.outside(ValueProblem.VALUE_MALFORMED, field, MOMENT, "\"" + text + "\"");
        }
    }

    private static GrantView view(Grant grant, Instant now) {
        GrantObject object = grant.object();
        return new GrantView(
                grant.id(),
                grant.subject() instanceof GrantSubject.OfUser user ? user.name() : null,
                grant.subject() instanceof GrantSubject.OfGroup group ? group.id() : null,
                object instanceof GrantObject.Everything,
                object instanceof GrantObject.Virtual,
                object instanceof GrantObject.Drones drones
                        ? drones.ids().stream().map(DroneId::value).sorted().toList()
                        : null,
                object instanceof GrantObject.OfFleet fleet ? fleet.id() : null,
                grant.permissions().stream().map(WireNames::camel).toList(),
                grant.from(),
                grant.until(),
                state(grant, now),
                grant.madeBy(),
                grant.madeAt());
    }

    private static String state(Grant grant, Instant now) {
        if (grant.isInForce(now)) {
            return "inForce";
        }
        return grant.from().isAfter(now) ? "toCome" : "over";
    }
}
