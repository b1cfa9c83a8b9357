package org.dronemap.ws.organisation;

import io.swagger.v3.oas.annotations.media.Schema;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.time.Clock;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import org.dronemap.core.access.Gift;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.conduct.VirtualDrones;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.lease.Lease;
import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.core.recording.RecordingArchive;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.problem.CommandProblem;
import org.dronemap.ws.problem.DroneProblem;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.reading.WireTimes;
import org.jspecify.annotations.Nullable;

/**
 * Transfers drones from one organisation to another and back, only while they are on the ground and uncontrolled. Any
 * thread.
 */
final class GiftService {
    private static final int NEWEST = 50;

    private final GrantChanges grants;
    private final CloudManager cloud;
    private final VirtualDrones virtuals;
    private final DroneService drones;
    private final OrganisationService organisations;
    private final RecordingArchive recordings;
    private final Clock clock;

    /** Options of a gift of a drone: whether its history goes along; without the option it does not. */
    @Schema(name = "GiftRequest")
    record GiftRequest(
            @Schema(
                    description =
                            "Whether the new owners see flights, recordings, commands and telemetry of before, without names of people")
            @Nullable
            Boolean histories) {}

    /** A drone that was given, and what that means. */
    @Schema(name = "GiftView")
    record GiftView(
            @Schema(description = "Id of the drone") String drone,
            @Schema(description = "As it was called then") String droneName,

            @Schema(description = "Id of the organisation that gave it")
            String from,

            @Schema(description = "Id of the organisation that it belongs to now")
            String to,

            Instant at,
            boolean histories,

            @Schema(description = "What goes along, and what does not")
            String notice) {
        static GiftView of(Gift gift) {
            return new GiftView(
                    gift.drone().value(),
                    gift.droneName(),
                    gift.from().value(),
                    gift.to().value(),
                    WireTimes.shown(gift.at()),
                    gift.histories(),
                    notice(gift));
        }

        private static String notice(Gift gift) {
            return (gift.histories()
                            ? "Its flights, recordings, commands and telemetry until now go along without names of"
                                    + " people, notes, and who sent what;"
                            : "Its flights, recordings, commands and telemetry until now do not go along;")
                    + " those who had it still see them. What is on board goes along with it, and its keys still hold:"
                    + " change them.";
        }
    }

    /** The drones of an organisation that others gave to it. */
    @Schema(name = "Gifts")
    record Gifts(List<GiftView> gifts) {}

    GiftService(
            GrantChanges grants,
            CloudManager cloud,
            VirtualDrones virtuals,
            DroneService drones,
            OrganisationService organisations,
            RecordingArchive recordings,
            Clock clock) {
        this.recordings = recordings;
        this.grants = grants;
        this.cloud = cloud;
        this.virtuals = virtuals;
        this.drones = drones;
        this.organisations = organisations;
        this.clock = clock;
    }

    /** Those that it still has, the last one last. */
    Gifts gifts(Principal principal, String organisation) {
        RoleChecks.requireServer(principal, Role.ADMINISTRATOR);
        OrganisationId id = organisations.find(organisation).id();
        return new Gifts(grants.holdings().gifts().stream()
                .filter(gift -> isWith(gift.drone(), id)
                        && grants.book()
                                .lastGift(gift.drone())
                                .filter(gift::equals)
                                .isPresent())
                .map(GiftView::of)
                .toList());
    }

    /** Gives one of the default organisation's drones away. */
    GiftView give(Principal principal, String organisation, String drone, @Nullable GiftRequest request) {
        RoleChecks.requireServer(principal, Role.ADMINISTRATOR);
        OrganisationId to = organisations.find(organisation).id();
        boolean histories = request != null && Boolean.TRUE.equals(request.histories());
        return pass(drones.state(principal, drone), to, histories);
    }

    /** Brings a drone back to those who gave it; what it did meanwhile is shown to those who had it, alone. */
    GiftView revoke(Principal principal, String organisation, String drone) {
        RoleChecks.requireServer(principal, Role.ADMINISTRATOR);
        OrganisationId from = organisations.find(organisation).id();
        DroneState state = cloud.drones().stream()
                .filter(each -> each.id().value().equals(drone) && isWith(each.id(), from))
                .findFirst()
                .orElseThrow(() -> Rejection.unknown(NotFoundProblem.DRONE, drone));
        // What came to it otherwise was never the asker's.
        Gift gift =
                grants.book().lastGift(state.id()).orElseThrow(() -> Rejection.unknown(NotFoundProblem.DRONE, drone));
        return pass(state, gift.from(), false);
    }

    private boolean isWith(DroneId drone, OrganisationId organisation) {
        return grants.book().owner(drone).equals(organisation);
    }

    private GiftView pass(DroneState drone, OrganisationId to, boolean histories) {
        requireAtRest(drone);
        // Before it is others': they would be told who had it.
        cloud.controls().clear(drone.id());
        // After all that was told of it so far, and after the gift before.
        Instant now = clock.instant().truncatedTo(ChronoUnit.MICROS).plus(1, ChronoUnit.MICROS);
        Instant at = grants.book()
                .lastGift(drone.id())
                .map(before -> before.at().plus(1, ChronoUnit.MICROS))
                .filter(now::isBefore)
                .orElse(now);
        Gift gift = new Gift(drone.id(), drone.name(), grants.book().owner(drone.id()), to, at, histories);
        grants.make(store -> store.give(gift));
        part(drone.id());
        return GiftView.of(gift);
    }

    private void part(DroneId drone) {
        try {
            recordings.part(drone);
        } catch (IOException e) {
            throw new UncheckedIOException("the drone was given, and what is recorded of it is not parted", e);
        }
    }

    /** Whoever flies it, or lets it be flown, has to end that first: nobody else could. */
    private void requireAtRest(DroneState drone) {
        if (drone.replay()) {
            throw Rejection.of(
                    new CommandProblem(OutcomeCode.DRONE_IS_A_RECORDING),
                    "This is a recording, which goes along with its drone.",
                    ProblemParameter.DRONE.is(drone.id().value()));
        }
        if (Boolean.TRUE.equals(drone.armed()) || drone.airborne()) {
            throw Rejection.of(
                    DroneProblem.DRONE_NOT_AT_REST,
                    "It is armed or in the air; land and disarm it first.",
                    ProblemParameter.DRONE.is(drone.id().value()));
        }
        Lease tenure = cloud.controls().control(drone.id()).tenure();
        if (tenure != null && tenure.holder() instanceof LeaseHolder.Operation) {
            throw Rejection.of(
                    DroneProblem.DRONE_IN_OPERATION,
                    "An operation has control of it; end that first.",
                    ProblemParameter.DRONE.is(drone.id().value()));
        }
        if (cloud.gate().commandsOf(drone.id(), NEWEST).stream().anyMatch(command -> command.outcome() == null)) {
            throw Rejection.of(
                    new CommandProblem(OutcomeCode.COMMAND_UNDER_WAY),
                    "A command to it is under way; wait for its end.",
                    ProblemParameter.DRONE.is(drone.id().value()));
        }
        if (virtuals.warehouse().contains(drone.id())) {
            throw Rejection.of(
                    DroneProblem.DRONE_IN_WAREHOUSE,
                    "It may serve virtual drones; take it out of the warehouse first.",
                    ProblemParameter.DRONE.is(drone.id().value()));
        }
    }
}
