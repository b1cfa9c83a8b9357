package org.dronemap.cognitive.follow;

import java.time.Instant;
import org.dronemap.core.geo.Geodetic;
import org.jspecify.annotations.Nullable;

/**
 * A position that a followed phone reported, with its accuracy and, if known, its speed and course.
 *
 * @param at by the cloud's clock, see {@link PhoneClockOffset}
 * @param accuracyMeters the phone is within so much of the place in two cases of three, by its own word
 * @param course how it moves, which receivers measure apart from where they are; null: it does not say
 */
public record PhoneFix(
        Instant at,
        Geodetic point,
        double accuracyMeters,
        @Nullable Course course) {
    /** Over the ground, m/s, and degrees clockwise from north. */
    public record Course(double speed, double degrees) {
        public Course {
            if (!(speed >= 0 && speed <= FASTEST)) {
                throw new IllegalArgumentException("a speed is 0 to 100 m/s: " + speed);
            }
            if (!(Math.abs(degrees) <= 360)) {
                throw new IllegalArgumentException("a course is -360 to 360 degrees: " + degrees);
            }
        }

        double eastward() {
            return speed * Math.sin(Math.toRadians(degrees));
        }

        double northward() {
            return speed * Math.cos(Math.toRadians(degrees));
        }
    }

    private static final double FASTEST = 100;

    public PhoneFix(Instant at, Geodetic point, double accuracyMeters) {
        this(at, point, accuracyMeters, null);
    }

    public PhoneFix {
        if (!(accuracyMeters >= 0)) {
            throw new IllegalArgumentException("an accuracy is 0 or more metres: " + accuracyMeters);
        }
    }
}
