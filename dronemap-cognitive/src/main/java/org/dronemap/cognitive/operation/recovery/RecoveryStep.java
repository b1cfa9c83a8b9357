package org.dronemap.cognitive.operation.recovery;

import java.util.List;
import org.dronemap.core.stored.Stored;

/** A step of a drone on its way down, in their order: it moves in every other one, and stands in those between. */
@Stored(names = "ALOFT LEVELLING LEVEL UNDER_WAY OVER_HOME DESCENDING DOWN")
public enum RecoveryStep {
    /** It stands where it was when the recovery began. */
    ALOFT,
    /** It climbs or descends to the height at which it flies home. */
    LEVELLING,
    /** It stands at that height. */
    LEVEL,
    UNDER_WAY,
    /** It stands above its home. */
    OVER_HOME,
    DESCENDING,
    DOWN;

    static final List<RecoveryStep> MOVES = List.of(LEVELLING, UNDER_WAY, DESCENDING);

    boolean isMove() {
        return MOVES.contains(this);
    }

    boolean isBefore(RecoveryStep other) {
        return compareTo(other) < 0;
    }

    RecoveryStep next() {
        return switch (this) {
            case ALOFT -> LEVELLING;
            case LEVELLING -> LEVEL;
            case LEVEL -> UNDER_WAY;
            case UNDER_WAY -> OVER_HOME;
            case OVER_HOME -> DESCENDING;
            case DESCENDING, DOWN -> DOWN;
        };
    }

    RecoveryStep before() {
        return switch (this) {
            case ALOFT, LEVELLING -> ALOFT;
            case LEVEL -> LEVELLING;
            case UNDER_WAY -> LEVEL;
            case OVER_HOME -> UNDER_WAY;
            case DESCENDING -> OVER_HOME;
            case DOWN -> DESCENDING;
        };
    }
}
