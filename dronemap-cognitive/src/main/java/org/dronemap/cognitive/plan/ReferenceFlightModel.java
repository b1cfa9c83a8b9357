package org.dronemap.cognitive.plan;

import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Power;
import org.dronemap.cognitive.problem.Speeds;
import org.dronemap.cognitive.problem.UniformWind;
import org.dronemap.cognitive.problem.WindResponse;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;

/** A second flight model for checking plans, independent of the search's: time and energy of a straight piece. */
final class ReferenceFlightModel {
    private static final double STRAIGHT_UP_METERS = 0.05;

    private final Speeds speeds;
    private final Power power;
    private final WindResponse response;
    private final UniformWind wind;

    /** Time and energy of a piece. */
    record Effort(double seconds, double joules) {}

    ReferenceFlightModel(Craft craft, UniformWind wind) {
        this.speeds = craft.performance().speeds();
        this.power = craft.performance().power();
        this.response = craft.performance().response();
        this.wind = wind;
    }

    double hoverWatts() {
        return power.hover();
    }

    static boolean isStraightUp(TimedPlace from, TimedPlace to) {
        return length(from, to) < STRAIGHT_UP_METERS;
    }

    static double length(TimedPlace from, TimedPlace to) {
        return new PlanePoint(0, 0)
                .distanceMeters(
                        LocalPlane.offset(from.place().point(), to.place().point()));
    }

    Effort takeOff(TimedPlace from, TimedPlace to) {
        double seconds = climb(from, to) / speeds.climb();
        return new Effort(seconds, seconds * Math.max(power.hover(), power.climb()));
    }

    Effort landing(TimedPlace from, TimedPlace to) {
        double meters = -climb(from, to);
        double quick = Math.max(0, meters - Speeds.LANDING_METERS);
        double seconds = quick / speeds.descent() + (meters - quick) / speeds.landing();
        return new Effort(seconds, seconds * power.hover());
    }

    Effort cruise(TimedPlace from, TimedPlace to) {
        double climb = climb(from, to);
        double vertical = climb > 0 ? climb / speeds.climb() : climb / -speeds.descent();
        double meters = length(from, to);
        Air air = meters == 0 ? new Air(speeds.cruise(), speeds.cruise()) : air(from, to);
        double level = meters == 0 ? 0 : levelSeconds(meters, air.overGround());
        double extra = climb > 0 ? Math.max(0, power.climb() - power.hover()) * vertical : 0;
        double hovering = vertical > level ? (vertical - level) * power.hover() : 0;
        return new Effort(Math.max(level, vertical), level * watts(air.through()) + hovering + extra);
    }

    private static double climb(TimedPlace from, TimedPlace to) {
        return to.place().altitudeAmslMeters() - from.place().altitudeAmslMeters();
    }

    /** Speeds in m/s. */
    private record Air(double overGround, double through) {}

    private Air air(TimedPlace from, TimedPlace to) {
        if (response == WindResponse.UNTOUCHED) {
            return new Air(speeds.cruise(), speeds.cruise());
        }
        PlanePoint there = LocalPlane.offset(from.place().point(), to.place().point());
        double course = Math.atan2(there.eastMeters(), there.northMeters());
        double angle = Math.toRadians(wind.fromDegrees() + 180) - course;
        double across = wind.metersPerSecond() * Math.sin(angle);
        double along = wind.metersPerSecond() * Math.cos(angle);
        double most = response == WindResponse.KEEPS_AIRSPEED ? speeds.cruise() : speeds.greatestAirspeed();
        double crab = Math.asin(Math.max(-1, Math.min(1, across / most)));
        double overGround = most * Math.cos(crab) + along;
        if (Math.abs(across) >= most || overGround <= 0) {
            return new Air(0, most);
        }
        if (response == WindResponse.KEEPS_AIRSPEED || overGround <= speeds.cruise()) {
            return new Air(overGround, most);
        }
        return new Air(speeds.cruise(), Math.hypot(speeds.cruise() - along, across));
    }

    private double levelSeconds(double meters, double overGround) {
        double runUp = overGround * overGround / (2 * speeds.acceleration());
        if (2 * runUp >= meters) {
            return 2 * Math.sqrt(meters / speeds.acceleration());
        }
        return 2 * overGround / speeds.acceleration() + (meters - 2 * runUp) / overGround;
    }

    private double watts(double airspeed) {
        if (response != WindResponse.KEEPS_GROUND_SPEED) {
            return power.cruise();
        }
        double share = airspeed / speeds.cruise();
        double beyond = share * share - 1;
        double slope = power.cruise() - power.hover();
        return power.cruise() + (beyond > 0 ? Math.abs(slope) : slope) * beyond;
    }
}
