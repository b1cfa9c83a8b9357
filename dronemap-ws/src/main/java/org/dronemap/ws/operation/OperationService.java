package org.dronemap.ws.operation;

import java.time.Clock;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.BiPredicate;
import java.util.random.RandomGenerator;
import org.dronemap.core.access.Principal;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.conduct.Operations;
import org.dronemap.core.conduct.Operations.Snapshot;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.lease.Lease;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.core.operation.Objection;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.OperationKind;
import org.dronemap.core.operation.OperationObjection;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.time.Time;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.ObjectionProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ServerProblem;

/**
 * Common part of the mission run and follow services: finds, starts and sends inputs to one kind of operation. Any
 * thread.
 *
 * @param <S> its state
 * @param <I> its inputs
 */
public final class OperationService<S, I> {
    private static final String LETTERS = "abcdefghjkmnpqrstuvwxyz23456789";
    private static final int ID_LENGTH = 16;
    private static final int MOST_UNDER_WAY = 50;
    private static final int MOST_LISTED = 50;

    private final Operations operations;
    private final OperationKind<S, I> kind;
    private final CloudManager cloud;
    private final Terms words;
    private final BiPredicate<Principal, Snapshot<S>> shown;
    private final Clock clock;
    private final RandomGenerator random;

    /**
     * Words for a kind of operation in ids, sentences and problems.
     *
     * @param idPrefix its ids begin with it
     * @param one "mission run"
     * @param flies "a mission run flies"
     */
    public record Terms(char idPrefix, String one, String flies, NotFoundProblem unknown) {}

    /** {@code shown}: for others of its organisation it does not exist. */
    public OperationService(
            Operations operations,
            OperationKind<S, I> kind,
            CloudManager cloud,
            Terms words,
            BiPredicate<Principal, Snapshot<S>> shown,
            Time time) {
        this.operations = operations;
        this.kind = kind;
        this.cloud = cloud;
        this.words = words;
        this.shown = shown;
        this.clock = time.clock();
        this.random = time.random();
    }

    /** Those under way and the newest that are over, the newest first. */
    public List<Snapshot<S>> all(Principal principal) {
        List<Snapshot<S>> all = new ArrayList<>(operations.underWay(kind));
        all.addAll(operations.setAside(kind));
        operations.latest(principal.organisation(), kind, MOST_LISTED).stream()
                .filter(saved -> saved.endedAt() != null)
                .flatMap(saved -> picture(saved).stream())
                .forEach(all::add);
        return all.stream()
                .filter(one -> isShown(principal, one))
                .sorted(Comparator.comparing((Snapshot<S> one) -> one.saved().beganAt())
                        .reversed())
                .toList();
    }

    /** As it is stored; empty: it is another kind of operation, or cannot be read. */
    public Optional<Snapshot<S>> picture(SavedOperation saved) {
        return operations.picture(kind, saved);
    }

    private boolean isShown(Principal principal, Snapshot<S> one) {
        return principal.organisation().equals(one.saved().organisation()) && shown.test(principal, one);
    }

    public Snapshot<S> find(Principal principal, String id) {
        return parse(id)
                .flatMap(known -> operations.find(kind, known))
                .filter(one -> isShown(principal, one))
                .orElseThrow(() -> Rejection.unknown(words.unknown(), id));
    }

    private static Optional<OperationId> parse(String id) {
        try {
            return Optional.of(new OperationId(id));
        } catch (IllegalArgumentException notAnId) {
            return Optional.empty();
        }
    }

    /** It flies on without whoever started it, as its user: bounds of a key cannot be kept. */
    public void requireWithoutBounds(Principal principal) {
        if (principal.scope().isBounded()) {
            throw Rejection.of(
                    AccessProblem.KEY_BOUNDED,
                    "This access key has an area or heights, and " + words.flies() + " without them.");
        }
    }

    public void requireRoom(Principal principal) {
        long underWay = operations.underWay(kind).stream()
                .filter(one -> one.saved().organisation().equals(principal.organisation()))
                .count();
        if (underWay >= MOST_UNDER_WAY) {
            throw Rejection.of(
                    ServerProblem.LIMIT_REACHED,
                    "Your organisation has " + underWay + " " + words.one() + "s under way already.",
                    ProblemParameter.WHAT.is(words.one() + "s"),
                    ProblemParameter.MOST.is(MOST_UNDER_WAY));
        }
    }

    /** What a user has in hand goes over to the operation of the same user. */
    public void releaseControl(Principal principal, DroneId drone) {
        if (cloud.controls().control(drone).isHeldBy(principal.name())) {
            cloud.controls().apply(drone, new LeaseEvent.Release(principal.name()));
        }
    }

    /**
     * Makes the way free for the operation before it hears a wish for that drone: control goes over from the user, and from
     * the pilot at the vehicle as well, before whom goes who says so in so many words. Nothing changes hands for a wish that
     * would be refused.
     */
    public void releaseForRequest(Principal principal, String id, S state, I wish, DroneId drone) {
        kind.machine().refusal(state, wish).ifPresent(why -> {
            throw ObjectionProblem.rejection(why, id);
        });
        Lease tenure = cloud.controls().control(drone).tenure();
        if (tenure != null && tenure.holder() instanceof LeaseHolder.Pilot) {
            cloud.controls().apply(drone, new LeaseEvent.TakeControl(principal.name()));
        }
        releaseControl(principal, drone);
    }

    public Snapshot<S> begin(Principal principal, OperationId id, String name, S state, Instant at) {
        kind.machine().drones(state).forEach(drone -> releaseControl(principal, drone));
        SavedOperation begun = SavedOperation.begun(
                id,
                kind.name(),
                new SavedOperation.Owner(principal.name(), principal.account(), principal.organisation()),
                name,
                at);
        try {
            return operations.begin(kind, begun, state);
        } catch (Operations.Refused refused) {
            throw ObjectionProblem.rejection(refused.objection(), id.value());
        } catch (Operations.NoControl held) {
            throw cloud.drone(held.drone())
                    .map(drone -> Rejection.held(
                            held.why(), drone.id(), cloud.controls().control(drone.id())))
                    .orElseGet(() -> Rejection.unknown(
                            NotFoundProblem.DRONE, held.drone().value()));
        }
    }

    public Snapshot<S> submit(Snapshot<S> one, I input) {
        try {
            return operations.request(kind, one.saved().id(), input);
        } catch (Operations.Refused refused) {
            throw ObjectionProblem.rejection(
                    refused.objection(), one.saved().id().value());
        }
    }

    public Rejection over(String id) {
        return ObjectionProblem.rejection(
                Objection.of(OperationObjection.OVER, "This " + words.one() + " is over."), id);
    }

    public Instant now() {
        return clock.instant().truncatedTo(ChronoUnit.MICROS);
    }

    public OperationId newId() {
        StringBuilder id = new StringBuilder().append(words.idPrefix());
        while (id.length() < ID_LENGTH) {
            id.append(LETTERS.charAt(random.nextInt(LETTERS.length())));
        }
        return new OperationId(id.toString());
    }
}
