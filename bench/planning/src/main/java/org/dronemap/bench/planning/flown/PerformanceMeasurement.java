package org.dronemap.bench.planning.flown;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.bench.planning.flown.SimulatedTestFlight.FlightEffort;
import org.dronemap.cognitive.problem.Performance;
import org.dronemap.cognitive.problem.Power;
import org.dronemap.cognitive.problem.Speeds;
import org.dronemap.cognitive.problem.WindResponse;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.sim.physics.LocalFrame;
import org.dronemap.sim.physics.NeuPosition;
import org.dronemap.sim.physics.WindModel;

/**
 * The figures of a vehicle, from short flights in calm air as anybody can fly them: each differs from another one in one
 * thing alone. What the autopilot is set to (its speeds) is taken from there.
 */
final class PerformanceMeasurement {
    private static final double LOW = 20;
    private static final double HIGH = 80;
    private static final double LONG = 600;
    private static final double SHORT = 300;
    private static final double HOLD = 60;
    private static final double CRUISE = 10;
    private static final double LANDING = 0.5;
    private static final double GREATEST_AIRSPEED = 25;
    private static final int LEGS = 10;
    private static final double LEG = 60;

    private final LocalFrame home;

    PerformanceMeasurement(LocalFrame home) {
        this.home = home;
    }

    Performance performance() {
        FlightEffort hover = fly(LOW, HOLD, List.of()).minus(fly(LOW, 0, List.of()));
        FlightEffort higher = fly(HIGH, 0, List.of()).minus(fly(LOW, 0, List.of()));
        FlightEffort further = fly(LOW, 0, List.of(LONG)).minus(fly(LOW, 0, List.of(SHORT)));
        double cruise = (LONG - SHORT) / further.seconds();
        double watts = hover.joules() / hover.seconds();
        double climb = 2.5;
        double descent = 1.5;
        double up = (HIGH - LOW) / climb;
        double down = (HIGH - LOW) / descent;
        double climbing = (higher.joules() - down * watts) / up;
        // What each start and stop takes beside the way at full speed.
        List<Double> many = new ArrayList<>();
        for (int leg = 0; leg <= LEGS; leg++) {
            many.add(leg % 2 * LEG);
        }
        FlightEffort stops = fly(LOW, 0, many).minus(fly(LOW, 0, List.of(0.0)));
        double each = stops.seconds() / LEGS - LEG / cruise;
        return new Performance(
                new Speeds(Math.min(cruise, CRUISE), climb, descent, LANDING, GREATEST_AIRSPEED, cruise / each),
                new Power(watts, further.joules() / further.seconds(), climbing),
                WindResponse.KEEPS_GROUND_SPEED);
    }

    /** Up, so far north in turn, and down there. */
    private FlightEffort fly(double height, double holdSeconds, List<Double> north) {
        List<MissionItem> items = new ArrayList<>();
        items.add(new MissionItem.TakeOff(height));
        if (holdSeconds > 0) {
            items.add(new MissionItem.Wait(holdSeconds));
        }
        for (double meters : north) {
            NeuPosition there = new NeuPosition(meters, 0, height);
            Geodetic point = new Geodetic(home.latitudeOf(there), home.longitudeOf(there));
            items.add(new MissionItem.Waypoint(
                    point, new Altitude(home.altitudeAmsl() + height, Altitude.Reference.AMSL), 0));
        }
        items.add(new MissionItem.Land());
        return new SimulatedTestFlight(home, new WindModel(0, 0, 1)).fly(items);
    }
}
