package org.dronemap.core.virtual;

import java.util.ArrayList;
import java.util.Collection;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.jspecify.annotations.Nullable;

/**
 * Selects, for a virtual drone or a follow, the drones that can serve and the best of them; a pure function. Same
 * input, same answer; touches nothing.
 *
 * @param candidates those that can
 * @param choice empty when there are none
 */
public record DroneSelection(List<DroneCandidate> candidates, Optional<DroneChoice> choice, List<Unfit> unfit) {
    /** That much is to be in the battery when the mission is over. */
    public static final int RESERVE_PERCENT = 20;

    /** A link that loses more than this is not trusted with a mission. */
    public static final int WORST_LOSS_PERCENT = 20;

    private static final int DISTANCE_STEP_METERS = 50;
    private static final int BATTERY_STEP_PERCENT = 5;

    /** What every mission takes. */
    private static final Set<Capability> FLYING =
            EnumSet.of(Capability.ARM, Capability.UPLOAD_MISSION, Capability.START_MISSION);

    public DroneSelection {
        candidates = List.copyOf(candidates);
        unfit = List.copyOf(unfit);
    }

    /** A drone that cannot serve, and why. */
    public record Unfit(DroneId drone, UnfitReason why) {}

    /** Check for further reasons against a drone: who has control of it, zones, rights. */
    public interface ExternalCheck {
        Optional<UnfitReason> to(DroneState drone, VirtualTourSection share);
    }

    /** A drone and what became of it: exactly one of the two is there. */
    private record Judged(
            @Nullable DroneCandidate candidate, @Nullable UnfitReason unfit) {
        static Judged unfit(UnfitCode code, String sentence) {
            return unfit(UnfitReason.of(code, sentence));
        }

        static Judged unfit(UnfitReason why) {
            return new Judged(null, why);
        }
    }

    /** Recordings are no drones. */
    public static DroneSelection of(ServiceDemand demand, Collection<DroneState> drones, ExternalCheck objection) {
        List<DroneCandidate> candidates = new ArrayList<>();
        List<Unfit> unfit = new ArrayList<>();
        for (DroneState drone : drones) {
            if (drone.replay()) {
                continue;
            }
            Judged judged = judge(demand, drone, objection);
            if (judged.candidate() != null) {
                candidates.add(judged.candidate());
            } else if (judged.unfit() != null) {
                unfit.add(new Unfit(drone.id(), judged.unfit()));
            }
        }
        return new DroneSelection(candidates, DroneChoice.among(candidates, sentences(unfit)), unfit);
    }

    private static List<DroneChoice.Unfit> sentences(List<Unfit> unfit) {
        return unfit.stream()
                .map(one -> new DroneChoice.Unfit(one.drone(), one.why().sentence()))
                .toList();
    }

    private static Judged judge(ServiceDemand demand, DroneState drone, ExternalCheck objection) {
        Optional<UnfitReason> why = notReady(drone).or(() -> notWanted(demand.needs(), drone));
        if (why.isPresent()) {
            return Judged.unfit(why.get());
        }
        Position position = drone.position();
        Geodetic stand = position == null ? null : position.point();
        Battery battery = drone.battery();
        Integer percent = battery == null ? null : battery.percent();
        if (stand == null || drone.home() == null) {
            return Judged.unfit(
                    stand == null ? UnfitCode.POSITION_UNKNOWN : UnfitCode.HOME_UNKNOWN,
                    "Where it stands, or its home, is not known.");
        }
        if (percent == null) {
            return Judged.unfit(UnfitCode.BATTERY_UNKNOWN, "How full its battery is, is not known.");
        }
        RequiredArea area = demand.needs().area();
        if (area != null && !area.contains(stand)) {
            return Judged.unfit(UnfitCode.OUTSIDE_AREA, "It does not stand " + area.words() + ".");
        }
        return energetic(demand, drone, new Charge(stand, percent), objection);
    }

    /** Position of a drone on the ground, and the charge of its battery in per cent. */
    private record Charge(Geodetic stand, int percent) {}

    private static Judged energetic(ServiceDemand demand, DroneState drone, Charge charge, ExternalCheck objection) {
        VehicleKind kind = drone.identification().kind();
        Optional<UnfitReason> tooShort = lastsTooShort(demand.needs().enduranceMinutes(), charge, kind);
        if (tooShort.isPresent()) {
            return Judged.unfit(tooShort.get());
        }
        TourEnergyEstimate energy =
                TourEnergyEstimate.of(demand.tour(), demand.first(), drone, charge.stand(), demand.wind());
        if (Double.isInfinite(energy.minutes())) {
            return Judged.unfit(
                    UnfitCode.NO_HEADWAY, "It makes no headway on its way: the mission takes " + energy.words() + ".");
        }
        double left = charge.percent() - energy.percent();
        if (left < RESERVE_PERCENT) {
            return Judged.unfit(
                    UnfitCode.BATTERY_TOO_LOW,
                    "Its battery has " + charge.percent() + " %; the mission takes " + energy.words() + ", and "
                            + RESERVE_PERCENT + " % are kept in reserve.");
        }
        Optional<VirtualTour.TakeOff> takeOff = demand.tour().takeOff(drone, demand.first());
        if (takeOff.isEmpty()) {
            return Judged.unfit(UnfitCode.TAKE_OFF_UNKNOWN, "How high it has to take off is not known.");
        }
        Double height = takeOff.get().meters();
        Optional<UnfitReason> against = objection.to(drone, demand.tour().share(demand.first(), height));
        if (against.isPresent()) {
            return Judged.unfit(against.get());
        }
        double away = Geodesy.distanceMeters(
                charge.stand(), demand.tour().waypoints().get(demand.first()).point());
        return new Judged(
                new DroneCandidate(
                        drone.id(),
                        step(away, DISTANCE_STEP_METERS),
                        step(left, BATTERY_STEP_PERCENT),
                        loss(drone),
                        height,
                        energy.words()),
                null);
    }

    private static Optional<UnfitReason> lastsTooShort(@Nullable Integer minutes, Charge charge, VehicleKind kind) {
        double lasts = TourEnergyEstimate.minutesOf(charge.percent(), kind);
        return minutes == null || lasts >= minutes
                ? Optional.empty()
                : Optional.of(UnfitReason.of(
                        UnfitCode.ENDURANCE_TOO_SHORT,
                        String.format(
                                Locale.ROOT, "Its battery lasts for some %.0f min, not for %d.", lasts, minutes)));
    }

    private static int step(double value, int step) {
        return (int) Math.floor(value / step) * step;
    }

    private static int loss(DroneState drone) {
        Double share = drone.link().quality().lossShort();
        return share == null ? 100 : (int) Math.round(share * 100);
    }

    private static Optional<UnfitReason> notReady(DroneState drone) {
        if (drone.link().state() != LinkState.LIVE) {
            return Optional.of(UnfitReason.of(UnfitCode.CONTACT_NOT_GOOD, "There is no good contact with it."));
        }
        if (!Boolean.FALSE.equals(drone.armed()) || drone.airborne()) {
            return Optional.of(UnfitReason.of(UnfitCode.NOT_AT_REST, "It is armed or in the air."));
        }
        if (Boolean.FALSE.equals(drone.readyToArm())) {
            return Optional.of(UnfitReason.of(UnfitCode.NOT_READY, "Its own checks do not let it arm."));
        }
        if (drone.link().trend().isFalling()) {
            return Optional.of(
                    UnfitReason.of(UnfitCode.LINK_FALLING, drone.link().trend().words()));
        }
        Double lost = drone.link().quality().lossShort();
        return lost != null && lost * 100 > WORST_LOSS_PERCENT
                ? Optional.of(UnfitReason.of(
                        UnfitCode.LINK_TOO_LOSSY, "Its link loses " + Math.round(lost * 100) + " % of its messages."))
                : Optional.empty();
    }

    private static Optional<UnfitReason> notWanted(DroneRequirements needs, DroneState drone) {
        VehicleKind kind = drone.identification().kind();
        if (needs.kind() != null && needs.kind() != kind) {
            return Optional.of(UnfitReason.of(
                    UnfitCode.OTHER_KIND, "It is a " + words(kind) + ", not a " + words(needs.kind()) + "."));
        }
        EnumSet<Capability> wanted = EnumSet.copyOf(FLYING);
        wanted.addAll(needs.capabilities());
        return wanted.stream()
                .filter(capability -> !drone.capabilities().commands().contains(capability))
                .map(capability ->
                        UnfitReason.of(UnfitCode.CAPABILITY_MISSING, "It cannot " + capability.phrase() + "."))
                .findFirst();
    }

    private static String words(VehicleKind kind) {
        return kind.name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }
}
