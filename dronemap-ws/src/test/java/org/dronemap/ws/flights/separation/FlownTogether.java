package org.dronemap.ws.flights.separation;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.VehicleTrack;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** A flight of all operations of a scenario at once: where its vehicles truly were, and what was to be flown. */
final class FlownTogether {
    private static final double AIRBORNE_METERS = 2;
    private static final double NANOS = 1e9;

    private final Label label;
    private final List<Party> parties;
    private final List<Alone> alone;
    private final Meeting meeting;
    private final List<Party.Flight> flights;
    private final long beganNanos;

    /** {@code disturbed}: seconds after the first moment. */
    record Label(Scenario scenario, long seed, boolean separation, Disturbance disturbance, double disturbed) {
        String words() {
            return isDisturbed() ? scenario.words() + "-" + disturbance.words() : scenario.words();
        }

        boolean isDisturbed() {
            return disturbance != Disturbance.NONE;
        }

        /** Of its own among all flights. */
        String folder() {
            String moment = isDisturbed() ? String.format(Locale.ROOT, "-%.1f", disturbed) : "";
            return words() + "-" + seed + moment + (separation ? "-on" : "-off");
        }
    }

    FlownTogether(
            Label label,
            List<Party> parties,
            List<Alone> alone,
            Meeting meeting,
            List<Party.Flight> flights,
            long beganNanos) {
        this.label = label;
        this.parties = parties;
        this.alone = alone;
        this.meeting = meeting;
        this.flights = flights;
        this.beganNanos = beganNanos;
    }

    private List<LabDrone> drones() {
        return flights.stream().flatMap(flight -> flight.drones().stream()).toList();
    }

    /** The nearest approach of any two in the air; 1: just as far apart as they have to be. */
    double leastShare() {
        List<List<VehicleTrack.Fix>> tracks =
                drones().stream().map(drone -> drone.track().since(beganNanos)).toList();
        List<Double> grounds = drones().stream().map(LabDrone::groundAmsl).toList();
        double least = Double.POSITIVE_INFINITY;
        for (int step = 0; step < tracks.get(0).size(); step++) {
            List<Spot> airborne = new ArrayList<>();
            for (int drone = 0; drone < tracks.size(); drone++) {
                VehicleTrack.Fix fix = tracks.get(drone).get(step);
                if (fix.amsl() - grounds.get(drone) > AIRBORNE_METERS) {
                    airborne.add(Spot.of(fix.place(), fix.amsl()));
                }
            }
            least = Math.min(least, leastShare(airborne));
        }
        return least;
    }

    /** How many of them are in the air so many seconds after the first moment. */
    long airborneAt(double second) {
        return drones().stream().filter(drone -> isAirborne(drone, second)).count();
    }

    private boolean isAirborne(LabDrone drone, double second) {
        long at = beganNanos + Math.round(second * NANOS);
        return drone.track().since(at).stream()
                .limit(1)
                .anyMatch(fix -> fix.amsl() - drone.groundAmsl() > AIRBORNE_METERS);
    }

    private static double leastShare(List<Spot> airborne) {
        double least = Double.POSITIVE_INFINITY;
        for (int one = 0; one < airborne.size(); one++) {
            for (int other = one + 1; other < airborne.size(); other++) {
                least = Math.min(least, Meeting.share(airborne.get(one), airborne.get(other)));
            }
        }
        return least;
    }

    /** Waypoints that nobody passed, and vehicles that are not down, as sentences. */
    List<String> faults() {
        List<String> faults = new ArrayList<>();
        for (int number = 0; number < parties.size(); number++) {
            Party party = parties.get(number);
            if (isAsMeant(party)) {
                party.waypoints().stream()
                        .filter(spot -> nearest(spot) > Vehicles.SERVED_METERS)
                        .forEach(spot -> faults.add(party.name() + " left out " + spot));
            }
        }
        drones().stream().filter(drone -> !drone.isDown()).forEach(drone -> faults.add(drone.words()));
        return faults;
    }

    private boolean isAsMeant(Party party) {
        return !label.disturbance().changesOperations() && party.isFlownToItsEnd();
    }

    private double nearest(Spot spot) {
        return drones().stream()
                .mapToDouble(drone -> drone.track().nearest(spot.place(), spot.amsl()))
                .min()
                .orElse(Double.POSITIVE_INFINITY);
    }

    /** Writes {@code tracks.csv} and {@code facts.json} for those who judge, into a folder of its own in that one. */
    Path writeInto(Path folder) {
        Path own = folder.resolve(label.folder());
        try {
            Files.createDirectories(own);
            try (BufferedWriter out = Files.newBufferedWriter(own.resolve("tracks.csv"))) {
                out.write("seed,second,vehicle,latitude,longitude,amsl,above_pad,armed\n");
                for (LabDrone drone : drones()) {
                    for (VehicleTrack.Fix fix : drone.track().since(beganNanos)) {
                        out.write(row(drone, fix));
                    }
                }
            }
            Files.writeString(own.resolve("facts.json"), facts().toPrettyString() + "\n");
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return own;
    }

    private String row(LabDrone drone, VehicleTrack.Fix fix) {
        return String.format(
                Locale.ROOT,
                "%d,%.1f,%s,%.9f,%.9f,%.3f,%.3f,%d%n",
                label.seed(),
                (fix.atNanos() - beganNanos) / NANOS,
                drone.name(),
                fix.place().latitudeDegrees(),
                fix.place().longitudeDegrees(),
                fix.amsl(),
                fix.amsl() - drone.groundAmsl(),
                fix.armed() ? 1 : 0);
    }

    private ObjectNode facts() {
        ObjectNode facts = JsonMapper.shared().createObjectNode();
        facts.put("scenario", label.words());
        facts.put("seed", label.seed());
        if (label.isDisturbed()) {
            facts.put("moment", label.disturbed());
        }
        facts.put("mechanism", label.separation());
        facts.put("meeting", meeting.seconds());
        facts.put("served", Vehicles.SERVED_METERS);
        ArrayNode operations = facts.putArray("operations");
        for (int number = 0; number < parties.size(); number++) {
            operation(operations.addObject(), number);
        }
        return facts;
    }

    private void operation(ObjectNode operation, int number) {
        Party party = parties.get(number);
        boolean asMeant = !label.disturbance().changesOperations();
        operation.put("name", party.name());
        operation.put("begins", meeting.begins().get(number));
        if (asMeant) {
            operation.put("undisturbed", alone.get(number).seconds());
        } else {
            operation.putNull("undisturbed");
        }
        operation.put("required", isAsMeant(party));
        ArrayNode vehicles = operation.putArray("vehicles");
        flights.get(number).drones().forEach(drone -> vehicles.add(drone.name()));
        ArrayNode waypoints = operation.putArray("waypoints");
        List<Spot> spots = party.waypoints();
        for (int spot = 0; spot < spots.size(); spot++) {
            ObjectNode waypoint = waypoints.addObject();
            waypoint.put("name", Integer.toString(spot + 1));
            waypoint.put("latitude", spots.get(spot).place().latitudeDegrees());
            waypoint.put("longitude", spots.get(spot).place().longitudeDegrees());
            waypoint.put("amsl", spots.get(spot).amsl());
        }
    }
}
