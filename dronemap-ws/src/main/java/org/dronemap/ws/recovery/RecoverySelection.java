package org.dronemap.ws.recovery;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronemap.cognitive.operation.recovery.RecoveryDrone;
import org.dronemap.cognitive.operation.recovery.RecoveryManner;
import org.dronemap.cognitive.operation.recovery.RecoveryOrder;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.lease.Lease;
import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.core.mission.Altitude;
import org.dronemap.ws.problem.CommandProblem;
import org.dronemap.ws.problem.DroneProblem;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.OperationProblem;
import org.dronemap.ws.problem.ProblemCode;
import org.jspecify.annotations.Nullable;

/** Chooses the drones of a recovery among those that its user may command, and says why each of the others is left alone. */
final class RecoverySelection {
    private static final double BETWEEN_HEIGHTS_METERS = 5;

    private final CloudManager cloud;
    private final Principal principal;
    private final RecoveryOrder order;
    private final boolean takeOver;

    /** Reason for leaving a drone alone: a code for programs, and a sentence. */
    private record Reason(ProblemCode code, String sentence) {}

    /**
     * Drones that come, and those that are left alone.
     *
     * @param highest above each drone's home, the most that it may fly home at
     */
    record Chosen(List<DroneState> drones, Map<DroneId, Double> highest, List<RecoveryPreview.LeftOutView> leftOut) {
        double highest(DroneId drone) {
            return highest.getOrDefault(drone, RecoveryOrder.USUAL_CEILING_METERS);
        }

        /** Those that are heard, as they are planned for. */
        List<RecoveryDrone> standing() {
            List<RecoveryDrone> standing = new ArrayList<>();
            for (DroneState drone : drones) {
                Position position = drone.position();
                Home home = drone.home();
                Geodetic point = point(drone);
                Double height = position == null ? null : position.altitudeAboveHomeMeters();
                if (drone.link().state() == LinkState.LIVE && point != null && height != null && home != null) {
                    standing.add(new RecoveryDrone(drone.id(), drone.name(), point, height, home, highest(drone.id())));
                }
            }
            return standing;
        }
    }

    RecoverySelection(CloudManager cloud, Principal principal, RecoveryOrder order, boolean takeOver) {
        this.cloud = cloud;
        this.principal = principal;
        this.order = order;
        this.takeOver = takeOver;
    }

    static @Nullable Geodetic point(DroneState drone) {
        Position position = drone.position();
        return position == null ? null : position.point();
    }

    /** {@code named}: null: all in the air. */
    Chosen choose(@Nullable List<@Nullable String> named) {
        List<DroneState> drones = new ArrayList<>();
        Map<DroneId, Double> highest = new LinkedHashMap<>();
        List<RecoveryPreview.LeftOutView> leftOut = new ArrayList<>();
        if (named != null) {
            named.stream()
                    .distinct()
                    .filter(id -> find(id).isEmpty())
                    .map(String::valueOf)
                    .map(id -> leftOut(
                            id,
                            id,
                            new Reason(NotFoundProblem.DRONE, "There is no drone of this id, or you do not see it.")))
                    .forEach(leftOut::add);
        }
        for (DroneState drone : named == null ? all() : named(named)) {
            Optional<Reason> why = whyNot(drone);
            if (why.isPresent()) {
                leftOut.add(leftOut(drone.id().value(), drone.name(), why.get()));
            } else {
                drones.add(drone);
                highest.put(drone.id(), highest(drone));
            }
        }
        return new Chosen(drones, highest, leftOut);
    }

    private static RecoveryPreview.LeftOutView leftOut(String id, String name, Reason why) {
        return new RecoveryPreview.LeftOutView(id, name, why.code().word(), why.sentence());
    }

    private List<DroneState> all() {
        return cloud.drones().stream()
                .filter(drone -> !drone.replay() && drone.airborne() && principal.may(Role.OPERATOR, drone.id()))
                .toList();
    }

    private List<DroneState> named(List<@Nullable String> ids) {
        return ids.stream().distinct().flatMap(id -> find(id).stream()).toList();
    }

    private Optional<DroneState> find(@Nullable String id) {
        return cloud.drones().stream()
                .filter(drone -> drone.id().value().equals(id) && principal.sees(drone.id()))
                .findFirst();
    }

    private Optional<Reason> whyNot(DroneState drone) {
        if (!principal.may(Role.OPERATOR, drone.id())) {
            return reason(OutcomeCode.ROLE_MAY_NOT_COMMAND, "You may not command it.");
        }
        if (drone.replay() || !drone.airborne()) {
            return reason(OutcomeCode.NOT_AIRBORNE, "It is not in the air.");
        }
        VehicleKind kind = drone.identification().kind();
        if (!kind.isRotorcraft()) {
            return Optional.of(new Reason(OperationProblem.RECOVERY_NOT_FOR_KIND, whyNotOfKind(kind)));
        }
        return whyNotHeld(drone).or(() -> whyUnable(drone));
    }

    private static String whyNotOfKind(VehicleKind kind) {
        String words = switch (kind) {
            case FIXED_WING -> "A plane";
            case VTOL -> "A VTOL plane";
            case AIRSHIP -> "An airship";
            case UNKNOWN, MULTICOPTER, HELICOPTER, ROVER, BOAT, SUBMARINE -> "A vehicle whose kind is not known";
        };
        return words
                + " does not stand in the air until its turn comes. Once the others are down, send it home by itself:"
                + " return to launch.";
    }

    private static Optional<Reason> reason(OutcomeCode code, String sentence) {
        return Optional.of(new Reason(new CommandProblem(code), sentence));
    }

    private Optional<Reason> whyUnable(DroneState drone) {
        Command last = order.manner() == RecoveryManner.LAND ? new Command.Land() : new Command.ReturnToLaunch();
        Set<Capability> able = drone.capabilities().commands();
        boolean can = able.contains(Capability.HOLD)
                && able.contains(last.needs())
                && (order.manner() == RecoveryManner.LAND || able.contains(Capability.GO_TO));
        if (!can) {
            return reason(OutcomeCode.CAPABILITY_MISSING, "It cannot hold and come down when it is told to.");
        }
        if (drone.link().state() != LinkState.LIVE) {
            return Optional.empty();
        }
        Position position = drone.position();
        if (drone.home() == null) {
            return reason(OutcomeCode.HOME_UNKNOWN, "Where its home is, is not known.");
        }
        if (point(drone) == null || position == null || position.altitudeAboveHomeMeters() == null) {
            return Optional.of(new Reason(DroneProblem.POSITION_UNKNOWN, "Where it is, is not known."));
        }
        return cloud.gate()
                .whyNot(principal, drone, last)
                .map(refusal -> new Reason(new CommandProblem(refusal.code()), refusal.sentence()));
    }

    /** By the rules of control: what others hold is for supervisors, and what the same user's operations hold for takeOver. */
    private Optional<Reason> whyNotHeld(DroneState drone) {
        Lease tenure = cloud.controls().control(drone.id()).tenure();
        if (tenure == null || tenure.holder().is(principal.name())) {
            return Optional.empty();
        }
        LeaseHolder holder = tenure.holder();
        boolean mine = holder instanceof LeaseHolder.Pilot
                || holder.userName().filter(principal.name()::equals).isPresent();
        boolean may = mine || principal.may(Role.SUPERVISOR, drone.id());
        if (takeOver && may) {
            return Optional.empty();
        }
        String held = cloud.controls().control(drone.id()).sentence();
        return may
                ? Optional.of(new Reason(
                        OperationProblem.RECOVERY_NEEDS_TAKE_OVER, held + " Ask with takeOver to take it over."))
                : reason(OutcomeCode.CONTROL_HELD, held);
    }

    /** As zones let it climb where it is. */
    private double highest(DroneState drone) {
        Geodetic point = point(drone);
        if (point == null
                || order.manner() == RecoveryManner.LAND
                || drone.link().state() != LinkState.LIVE) {
            return order.ceilingMeters();
        }
        for (double height = order.ceilingMeters(); height >= order.lowestMeters(); height -= BETWEEN_HEIGHTS_METERS) {
            Command climb = new Command.GoTo(point, Altitude.aboveHome(height));
            if (cloud.gate().whyNot(principal, drone, climb).isEmpty()) {
                return height;
            }
        }
        return order.ceilingMeters();
    }
}
