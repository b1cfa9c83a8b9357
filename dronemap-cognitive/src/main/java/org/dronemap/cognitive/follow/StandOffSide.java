package org.dronemap.cognitive.follow;

import org.dronemap.core.stored.Stored;

/** The side of its target that a following drone stays on: behind, ahead, a fixed bearing or an orbit. */
public sealed interface StandOffSide {
    /** Behind the target, by its direction of motion. */
    @Stored(as = "Behind")
    record Behind() implements StandOffSide {}

    /** Ahead of the target, by its direction of motion. */
    @Stored(as = "Ahead")
    record Ahead() implements StandOffSide {}

    /** Always in the same direction, degrees clockwise from north. */
    @Stored(as = "Fixed", names = "bearingDegrees")
    record Fixed(double bearingDegrees) implements StandOffSide {
        public Fixed {
            if (!(Math.abs(bearingDegrees) <= 360)) {
                throw new IllegalArgumentException("a bearing is -360 to 360 degrees: " + bearingDegrees);
            }
        }
    }

    /** Round and round, degrees a second clockwise seen from above; negative: the other way. */
    @Stored(as = "Orbit", names = "degreesPerSecond")
    record Orbit(double degreesPerSecond) implements StandOffSide {
        private static final double FASTEST = 30;

        public Orbit {
            if (!(Math.abs(degreesPerSecond) <= FASTEST) || degreesPerSecond == 0) {
                throw new IllegalArgumentException(
                        "an orbit turns 30 degrees a second at most, and not 0: " + degreesPerSecond);
            }
        }
    }
}
