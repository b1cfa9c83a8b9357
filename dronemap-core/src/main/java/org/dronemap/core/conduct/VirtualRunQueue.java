package org.dronemap.core.conduct;

import java.time.Clock;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.Wind;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.virtual.DroneCandidate;
import org.dronemap.core.virtual.DroneChoice;
import org.dronemap.core.virtual.DroneSelection;
import org.dronemap.core.virtual.MissionShares;
import org.dronemap.core.virtual.ServiceDemand;
import org.dronemap.core.virtual.UnfitCode;
import org.dronemap.core.virtual.UnfitReason;
import org.dronemap.core.virtual.VirtualDrone;
import org.dronemap.core.virtual.VirtualDroneId;
import org.dronemap.core.virtual.VirtualRun;
import org.dronemap.core.virtual.VirtualRunMachine;
import org.dronemap.core.virtual.VirtualTour;
import org.dronemap.core.virtual.VirtualTourSection;
import org.jspecify.annotations.Nullable;

/**
 * Queue of the virtual drones' missions that wait for real drones: divides those that several may share, and assigns a
 * drone to each share. Owned by the conductor's thread.
 */
final class VirtualRunQueue {
    private final CloudManager cloud;
    private final VirtualDroneRegistry book;
    private final DroneGateway crew;
    private final VirtualRunMachine machine;
    private final VirtualDroneRights rights;
    private final Clock clock;
    private final ConcurrentHashMap<VirtualDroneId, List<DroneSelection.Unfit>> waitingFor = new ConcurrentHashMap<>();

    VirtualRunQueue(
            CloudManager cloud, VirtualDroneRegistry book, DroneGateway crew, VirtualRunExecutor.Context means) {
        this.cloud = cloud;
        this.book = book;
        this.crew = crew;
        this.machine = means.machine();
        this.rights = means.rights();
        this.clock = means.time().clock();
    }

    /** Why the drones of the warehouse cannot serve it now; nothing when it does not wait. Any thread. */
    List<DroneSelection.Unfit> waitingFor(VirtualDroneId id) {
        return waitingFor.getOrDefault(id, List.of());
    }

    /**
     * What waits, in its turn, and why that drone could not serve it if it were in the warehouse and nobody had control of
     * it; what it could serve it would be sent to fly at once.
     */
    List<VirtualDroneMatch> prospects(DroneState drone) {
        return book.waiting().stream()
                .filter(waiting ->
                        rights.mayFly(waiting.account()) && rights.mayServe(waiting.organisation(), drone.id()))
                .flatMap(waiting -> match(waiting, drone).stream())
                .toList();
    }

    /** Of several shares the first that it could fly. */
    private Optional<VirtualDroneMatch> match(VirtualDrone waiting, DroneState drone) {
        List<VirtualDroneMatch> matches = waiting.runs().stream()
                .filter(VirtualRun::isWaiting)
                .map(run -> new VirtualDroneMatch(waiting, run, whyNot(waiting, run, drone)))
                .toList();
        return matches.stream()
                .filter(match -> match.whyNot().isEmpty())
                .findFirst()
                .or(() -> matches.stream().findFirst());
    }

    private Optional<UnfitReason> whyNot(VirtualDrone waiting, VirtualRun run, DroneState drone) {
        List<DroneState> alone = List.of(drone);
        return DroneSelection.of(demand(waiting, run, alone), alone, (state, share) -> hindrance(waiting, state, share))
                .unfit()
                .stream()
                .map(DroneSelection.Unfit::why)
                .findFirst();
    }

    /** Each takes the best of what is free; what one cannot use is left to the ones behind it. */
    void serve() {
        List<VirtualDrone> waiting = book.waiting();
        waitingFor.keySet().retainAll(waiting.stream().map(VirtualDrone::id).toList());
        waiting.forEach(this::serve);
    }

    private void serve(VirtualDrone waiting) {
        if (!rights.mayFly(waiting.account())) {
            book.put(waiting.with(waiting.runs().stream()
                    .map(run -> run.isWaiting() ? machine.stop(run, clock.instant()) : run)
                    .toList()));
            return;
        }
        List<DroneState> serving = cloud.drones().stream()
                .filter(state ->
                        book.warehouse().contains(state.id()) && rights.mayServe(waiting.organisation(), state.id()))
                .toList();
        VirtualDrone drone = divided(waiting, serving);
        for (int share = 0; share < drone.runs().size(); share++) {
            if (drone.runs().get(share).isWaiting()) {
                drone = serve(drone, share, serving);
            }
        }
        if (!drone.isWaiting()) {
            waitingFor.remove(drone.id());
        }
    }

    /** In as many shares as there are drones for now; as it is while there are not several. */
    private VirtualDrone divided(VirtualDrone drone, List<DroneState> serving) {
        VirtualRun run = drone.runs().get(0);
        List<DroneState> free = serving.stream()
                .filter(state -> crew.whyBusy(state.id()).isEmpty())
                .toList();
        Optional<Geodetic> home = run.isDivisible() ? nearest(run.tour(), free) : Optional.empty();
        if (home.isEmpty()) {
            return drone;
        }
        int most = Math.min(run.order().upTo(), free.size());
        while (most > 1) {
            List<Mission> shares = MissionShares.of(run.mission(), home.get(), most);
            VirtualDrone divided = drone.with(run.divided(shares, clock.instant()));
            if (shares.size() == 1) {
                return drone;
            }
            if (canAllBeServed(divided, free)) {
                return divided;
            }
            most = shares.size() - 1;
        }
        return drone;
    }

    /** Where the drone stands that is nearest to where the mission begins. */
    private static Optional<Geodetic> nearest(VirtualTour tour, List<DroneState> drones) {
        Geodetic first = tour.waypoints().get(0).point();
        return drones.stream()
                .map(DroneState::position)
                .filter(Objects::nonNull)
                .map(Position::point)
                .filter(Objects::nonNull)
                .min(Comparator.comparingDouble(stand -> Geodesy.distanceMeters(stand, first)));
    }

    /** Each share has a drone of its own. */
    private boolean canAllBeServed(VirtualDrone divided, List<DroneState> free) {
        Set<DroneId> chosen = new HashSet<>();
        for (VirtualRun run : divided.runs()) {
            List<DroneState> others =
                    free.stream().filter(state -> !chosen.contains(state.id())).toList();
            Optional<DroneChoice> choice = select(divided, run, others).choice();
            if (choice.isEmpty()) {
                return false;
            }
            chosen.add(choice.get().chosen());
        }
        return true;
    }

    private VirtualDrone serve(VirtualDrone drone, int share, List<DroneState> serving) {
        DroneSelection selection = select(drone, drone.runs().get(share), serving);
        waitingFor.put(drone.id(), selection.unfit());
        return selection
                .choice()
                .map(choice -> bind(drone, share, choice, selection.candidates()))
                .orElse(drone);
    }

    private DroneSelection select(VirtualDrone drone, VirtualRun run, Collection<DroneState> serving) {
        return DroneSelection.of(
                demand(drone, run, serving), serving, (state, share) -> objection(drone, state, share));
    }

    private ServiceDemand demand(VirtualDrone drone, VirtualRun run, Collection<DroneState> serving) {
        return new ServiceDemand(drone.needs(), run.tour(), run.flown(), wind(run, serving));
    }

    /** Of others' drones nothing is told, not even what wind they feel. */
    private @Nullable Wind wind(VirtualRun run, Collection<DroneState> drones) {
        int next = Math.min(run.flown(), run.total() - 1);
        return Wind.near(run.tour().waypoints().get(next).point(), drones, clock.instant())
                .orElse(null);
    }

    private Optional<UnfitReason> objection(VirtualDrone drone, DroneState state, VirtualTourSection share) {
        return crew.whyBusy(state.id())
                .map(held -> UnfitReason.of(new Refusal(OutcomeCode.CONTROL_HELD, held)))
                .or(() -> hindrance(drone, state, share));
    }

    /** What speaks against it though nobody has control of it. */
    private Optional<UnfitReason> hindrance(VirtualDrone drone, DroneState state, VirtualTourSection share) {
        return drone.avoids(state, clock.instant())
                ? Optional.of(
                        UnfitReason.of(UnfitCode.FAILED_BEFORE, "It could not go on with this mission a while ago."))
                : crew.refusal(VirtualLeaseHolders.of(drone), state, new Command.UploadMission(share.mission()))
                        .map(UnfitReason::of);
    }

    /** As it is when somebody was quicker. */
    private VirtualDrone bind(VirtualDrone drone, int share, DroneChoice choice, List<DroneCandidate> candidates) {
        if (crew.engage(VirtualLeaseHolders.of(drone), choice.chosen()).isPresent()) {
            return drone;
        }
        Double takeOff = candidates.stream()
                .filter(candidate -> candidate.drone().equals(choice.chosen()))
                .findFirst()
                .map(DroneCandidate::takeOffMeters)
                .orElse(null);
        VirtualRun bound = drone.runs().get(share).bound(choice, takeOff, clock.instant());
        try {
            VirtualDrone next = drone.with(share, bound);
            book.put(next);
            return next;
        } catch (RuntimeException e) {
            crew.release(VirtualLeaseHolders.of(drone), choice.chosen());
            throw e;
        }
    }
}
