package org.dronemap.core.virtual;

import java.util.Comparator;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/**
 * A drone that could serve a virtual drone or a follow, with the quantities by which it is compared. Its quantities are
 * measured as coarsely as they are known: positions, assumed speeds and short measurements of links bear no finer
 * comparison.
 *
 * @param distanceMeters in steps of 50
 * @param batteryLeftPercent in steps of 5
 * @param lossPercent whole; 100: not known
 * @param takeOffMeters above home; null: it does not take off
 * @param energy what the mission takes, in words
 */
public record DroneCandidate(
        DroneId drone,
        int distanceMeters,
        int batteryLeftPercent,
        int lossPercent,
        @Nullable Double takeOffMeters,
        String energy) {
    /** The best one first. */
    static final Comparator<DroneCandidate> BEST_FIRST = Comparator.comparingInt(DroneCandidate::distanceMeters)
            .thenComparing(
                    Comparator.comparingInt(DroneCandidate::batteryLeftPercent).reversed())
            .thenComparingInt(DroneCandidate::lossPercent)
            .thenComparing(candidate -> candidate.drone().value());

    /** The first quantity by which it differs from another one. */
    SelectionCriterion decidingAgainst(DroneCandidate other) {
        if (distanceMeters != other.distanceMeters) {
            return SelectionCriterion.DISTANCE;
        }
        if (batteryLeftPercent != other.batteryLeftPercent) {
            return SelectionCriterion.BATTERY_LEFT;
        }
        return lossPercent == other.lossPercent ? SelectionCriterion.ORDER : SelectionCriterion.LINK_LOSS;
    }

    /** {@code place} is what it has in the order of ids. */
    double value(SelectionCriterion quantity, int place) {
        return switch (quantity) {
            case DISTANCE -> distanceMeters;
            case BATTERY_LEFT -> batteryLeftPercent;
            case LINK_LOSS -> lossPercent;
            case ORDER -> place;
        };
    }
}
