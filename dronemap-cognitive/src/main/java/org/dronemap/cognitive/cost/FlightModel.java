package org.dronemap.cognitive.cost;

import org.dronemap.cognitive.problem.Performance;
import org.dronemap.cognitive.problem.Power;
import org.dronemap.cognitive.problem.Speeds;
import org.dronemap.cognitive.problem.UniformWind;
import org.dronemap.cognitive.problem.WindResponse;

/**
 * The planner's flight model: time and energy that one type of drone takes for a straight piece of flight. It gathers
 * speed, cruises and brakes; it climbs or descends meanwhile, and stays where it is for what is left of that.
 */
final class FlightModel {
    /** Below this share of its cruising speed a drone is held not to get anywhere. */
    private static final double LEAST_SHARE = 0.1;

    private final Speeds speeds;
    private final Power power;
    private final boolean calm;
    private final boolean keepsAirspeed;
    private final double windEast;
    private final double windNorth;
    private final double windSquared;
    private final double airspeedSquared;
    private final double cruise;
    private final double brakeSeconds;
    private final double brakeMeters;

    FlightModel(Performance performance, UniformWind wind) {
        this.speeds = performance.speeds();
        this.power = performance.power();
        this.calm = wind.metersPerSecond() == 0 || performance.response() == WindResponse.UNTOUCHED;
        this.keepsAirspeed = performance.response() == WindResponse.KEEPS_AIRSPEED;
        this.windEast = wind.eastMetersPerSecond();
        this.windNorth = wind.northMetersPerSecond();
        this.windSquared = wind.metersPerSecond() * wind.metersPerSecond();
        double airspeed = keepsAirspeed ? speeds.cruise() : speeds.greatestAirspeed();
        this.airspeedSquared = airspeed * airspeed;
        this.cruise = speeds.cruise();
        this.brakeSeconds = cruise / speeds.acceleration();
        this.brakeMeters = cruise * brakeSeconds;
    }

    /** Infinite where the wind is too strong. */
    double seconds(double east, double north, double up) {
        double meters = Math.sqrt(east * east + north * north);
        return Math.max(levelSeconds(east, north, meters), verticalSeconds(up));
    }

    double joules(double east, double north, double up) {
        double meters = Math.sqrt(east * east + north * north);
        double level = levelSeconds(east, north, meters);
        double vertical = verticalSeconds(up);
        if (level == Double.POSITIVE_INFINITY) {
            return level;
        }
        double hovering = Math.max(0, vertical - level);
        double climbing = up > 0 ? (power.climb() - power.hover()) * vertical : 0;
        return cruiseWatts(east, north, meters) * level + power.hover() * hovering + Math.max(0, climbing);
    }

    private double verticalSeconds(double up) {
        return up > 0 ? up / speeds.climb() : -up / speeds.descent();
    }

    private double levelSeconds(double east, double north, double meters) {
        if (meters == 0) {
            return 0;
        }
        if (calm) {
            return meters >= brakeMeters
                    ? meters / cruise + brakeSeconds
                    : 2 * Math.sqrt(meters / speeds.acceleration());
        }
        double speed = groundSpeed(east, north, meters);
        if (speed < LEAST_SHARE * cruise) {
            return Double.POSITIVE_INFINITY;
        }
        double braking = speed / speeds.acceleration();
        return meters >= speed * braking ? meters / speed + braking : 2 * Math.sqrt(meters / speeds.acceleration());
    }

    /** The wind triangle: the course is kept, so that part of the airspeed goes against what blows across it. */
    private double groundSpeed(double east, double north, double meters) {
        double along = (east * windEast + north * windNorth) / meters;
        double room = airspeedSquared - Math.max(0, windSquared - along * along);
        if (room <= 0) {
            return 0;
        }
        double most = along + Math.sqrt(room);
        return keepsAirspeed ? most : Math.min(cruise, most);
    }

    /** Grows with the square of the airspeed, from hovering through cruising; beyond cruising never below it. */
    private double cruiseWatts(double east, double north, double meters) {
        if (calm || keepsAirspeed || meters == 0) {
            return power.cruise();
        }
        double along = (east * windEast + north * windNorth) / meters;
        double ahead = groundSpeed(east, north, meters) - along;
        double share = (ahead * ahead + Math.max(0, windSquared - along * along)) / (cruise * cruise);
        double more = power.cruise() - power.hover();
        return share <= 1 ? power.hover() + more * share : power.cruise() + Math.abs(more) * (share - 1);
    }

    double riseSeconds(double meters) {
        return meters / speeds.climb();
    }

    double riseJoules(double meters) {
        return riseSeconds(meters) * Math.max(power.climb(), power.hover());
    }

    /** Down to the ground. */
    double landingSeconds(double meters) {
        double slow = Math.min(meters, Speeds.LANDING_METERS);
        return slow / speeds.landing() + (meters - slow) / speeds.descent();
    }

    double landingJoules(double meters) {
        return landingSeconds(meters) * power.hover();
    }

    double hoverWatts() {
        return power.hover();
    }
}
