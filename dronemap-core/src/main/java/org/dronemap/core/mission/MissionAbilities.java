package org.dronemap.core.mission;

import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Mission items that a vehicle takes and flies as they are written, as its autopilot adapter declares them.
 *
 * @param kinds of items; what is not among them the firmware does not know, or skips without a word
 */
public record MissionAbilities(Set<MissionItem.Kind> kinds, Hold hold, Landing landing) {
    /** Seconds that it waits at a waypoint by the waypoint's own setting. */
    public enum Hold {
        NONE,
        /** More exact ones are cut by the vehicle. */
        WHOLE_SECONDS,
        ANY
    }

    /** The way in which it lands by a mission. */
    public enum Landing {
        /** Straight down, where it is or at a place. */
        VERTICAL,
        /** Straight down at a place that it is given. */
        AT_PLACE,
        /** As a fixed wing: at a place, on a straight way down from the waypoint before. */
        APPROACH
    }

    /** Of a vehicle that takes each item that the cloud can plan. */
    public static final MissionAbilities ALL = new MissionAbilities(plannable(), Hold.ANY, Landing.VERTICAL);

    private static final int LONGEST_HOLD_SECONDS = 3_600;

    public MissionAbilities {
        kinds = Set.copyOf(kinds);
    }

    private static Set<MissionItem.Kind> plannable() {
        return EnumSet.complementOf(EnumSet.of(MissionItem.Kind.OTHER));
    }

    /** The same without those kinds of items. */
    public MissionAbilities without(MissionItem.Kind... left) {
        Set<MissionItem.Kind> fewer = EnumSet.copyOf(kinds);
        List.of(left).forEach(fewer::remove);
        return new MissionAbilities(fewer, hold, landing);
    }

    public MissionAbilities with(Hold other) {
        return new MissionAbilities(kinds, other, landing);
    }

    public MissionAbilities with(Landing other) {
        return new MissionAbilities(kinds, hold, other);
    }

    public boolean supports(MissionItem.Kind kind) {
        return kinds.contains(kind);
    }

    /** Whether it waits so long at a waypoint, no more and no less. */
    public boolean supportsHold(double seconds) {
        return switch (hold) {
            case NONE -> seconds == 0;
            case WHOLE_SECONDS -> seconds == Math.rint(seconds);
            case ANY -> true;
        };
    }

    /** The first item that it does not fly as it is written. */
    public Optional<MissionItemFault> fault(Mission mission) {
        List<MissionItem> items = mission.items();
        for (int index = 0; index < items.size(); index++) {
            Optional<MissionItemFault> fault = fault(items, index);
            if (fault.isPresent()) {
                return fault;
            }
        }
        return Optional.empty();
    }

    private Optional<MissionItemFault> fault(List<MissionItem> items, int index) {
        MissionItem item = items.get(index);
        if (!supports(item.kind())) {
            return Optional.of(new MissionItemFault(
                    index, "type", "one of " + words(), "does not fly such an item in a mission; it flies " + words()));
        }
        return switch (item.kind()) {
            case WAYPOINT -> hold(index, ((MissionItem.Waypoint) item).holdSeconds());
            case LAND -> landing(items, index, (MissionItem.Land) item);
            case TAKE_OFF, RETURN_TO_LAUNCH, WAIT, TAKE_PHOTO, SET_SERVO, LOOK_AT, LOOK_AHEAD, OTHER ->
                Optional.empty();
        };
    }

    private Optional<MissionItemFault> landing(List<MissionItem> items, int index, MissionItem.Land land) {
        return switch (landing) {
            case VERTICAL -> Optional.empty();
            case AT_PLACE ->
                land.place() != null
                        ? Optional.empty()
                        : Optional.of(new MissionItemFault(
                                index,
                                "latitude",
                                "the place of the landing, -90 to 90 degrees",
                                "lands at a place; give the landing a latitude and a longitude, or end with return to"
                                        + " launch"));
            case APPROACH -> FixedWingLanding.fault(items, index);
        };
    }

    private Optional<MissionItemFault> hold(int index, double seconds) {
        if (supportsHold(seconds)) {
            return Optional.empty();
        }
        String allowed = hold == Hold.NONE ? "0" : "whole seconds, 0 to " + LONGEST_HOLD_SECONDS;
        String does = hold == Hold.NONE ? "does not wait" : "waits for whole seconds";
        return Optional.of(new MissionItemFault(
                index,
                "holdSeconds",
                allowed,
                does + " at a waypoint; \"holdSeconds\" must be " + allowed + ", not " + seconds));
    }

    private String words() {
        return kinds.stream().sorted().map(MissionItemFault::words).collect(Collectors.joining(", "));
    }
}
