package org.dronemap.ws.run;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.dronemap.cognitive.operation.run.RunState;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunOrder;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.zone.Zone;
import org.dronemap.ws.plan.PlanRequest;
import org.dronemap.ws.plan.PlanWaypointReader;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.FieldRanges;
import org.dronemap.ws.reading.NameRules;
import org.dronemap.ws.zone.ZoneFeature;
import org.dronemap.ws.zone.ZoneReader;
import org.jspecify.annotations.Nullable;

/** Turns a client's request about a mission run into inputs of the run, or rejects the faulty field. */
final class RunReader {
    static final int MOST_AT_ONCE = 500;
    private static final String COUNT = "1 to " + MOST_AT_ONCE + " waypoints";
    static final int MOST_SEARCH_SECONDS = 60;
    static final int LONGEST_NAME = 60;
    private static final double USUAL_SEARCH_SECONDS = 2;
    private static final double MILLIS = 1_000;

    private final String by;
    private final Instant at;

    /** {@code by}: the user who wants it. */
    RunReader(String by, Instant at) {
        this.by = by;
        this.at = at;
    }

    static String name(RunRequest.StartRequest request) {
        return request.name() == null ? "Mission run" : NameRules.checked("name", request.name(), LONGEST_NAME);
    }

    static RunOrder.ApprovalMode mode(@Nullable String name) {
        return switch (name == null ? "automatic" : name) {
            case "automatic" -> RunOrder.ApprovalMode.AUTOMATIC;
            case "askFirst" -> RunOrder.ApprovalMode.ASK_FIRST;
            default ->
                throw InvalidInput.outside(
                        ValueProblem.VALUE_NOT_ALLOWED, "mode", "automatic or askFirst", "\"" + name + "\"");
        };
    }

    static MissionCloudLossPolicy onCloudLoss(@Nullable String name) {
        return switch (name == null ? "continue" : name) {
            case "continue" -> MissionCloudLossPolicy.CONTINUE;
            case "rtl" -> MissionCloudLossPolicy.RETURN_TO_LAUNCH;
            default ->
                throw InvalidInput.outside(
                        ValueProblem.VALUE_NOT_ALLOWED, "onCloudLoss", "continue or rtl", "\"" + name + "\"");
        };
    }

    static Duration search(@Nullable Double seconds) {
        double checked = FieldRanges.checked(
                "searchSeconds", seconds == null ? USUAL_SEARCH_SECONDS : seconds, 0, MOST_SEARCH_SECONDS, "seconds");
        return Duration.ofMillis(Math.round(checked * MILLIS));
    }

    RunInput added(RunState run, RunRequest.WaypointsRequest request) {
        List<PlanRequest.@Nullable WaypointRequest> asked = request.waypoints();
        if (asked != null && asked.size() > MOST_AT_ONCE) {
            throw InvalidInput.outside(
                    ValueProblem.SIZE_OUT_OF_RANGE, "waypoints", COUNT, asked.size(), ProblemParameter.LEAST.is(1));
        }
        List<Waypoint> waypoints = new PlanWaypointReader(crafts(run)).read(named(run, asked));
        for (int index = 0; index < waypoints.size(); index++) {
            String id = waypoints.get(index).id();
            if (run.target(id).isPresent()) {
                throw new InvalidInput(
                        ValueProblem.VALUE_NOT_UNIQUE,
                        "waypoints[" + index + "].id",
                        "another one each",
                        "There is a waypoint “" + id + "” in this run already.");
            }
        }
        return new RunInput.AddWaypoints(at, by, waypoints);
    }

    /** Those without a name go on counting where the run's end. */
    private static @Nullable List<PlanRequest.@Nullable WaypointRequest> named(
            RunState run, @Nullable List<PlanRequest.@Nullable WaypointRequest> asked) {
        if (asked == null) {
            return null;
        }
        Set<String> taken = new HashSet<>();
        run.targets().forEach(target -> taken.add(target.id()));
        asked.forEach(one -> {
            if (one != null && one.id() != null) {
                taken.add(one.id());
            }
        });
        List<PlanRequest.@Nullable WaypointRequest> named = new ArrayList<>();
        int number = 1;
        for (PlanRequest.WaypointRequest one : asked) {
            if (one == null || one.id() != null) {
                named.add(one);
                continue;
            }
            while (!taken.add(String.valueOf(number))) {
                number++;
            }
            named.add(one.called(String.valueOf(number)));
        }
        return named;
    }

    RunInput moved(RunState run, RunWaypoint target, RunRequest.MoveRequest request) {
        Place place = target.waypoint().place();
        Double latitude = request.latitude();
        Double longitude = request.longitude();
        Geodetic point = new Geodetic(
                latitude == null ? place.point().latitudeDegrees() : FieldRanges.latitude("latitude", latitude),
                longitude == null ? place.point().longitudeDegrees() : FieldRanges.longitude("longitude", longitude));
        if (latitude == null && longitude == null && request.altitude() == null) {
            throw InvalidInput.missing("latitude", "where the waypoint goes, or a longitude, or an altitude");
        }
        if (request.altitude() == null && request.altitudeReference() != null) {
            throw InvalidInput.missing("altitude", "metres, when altitudeReference is given");
        }
        double amsl = request.altitude() == null
                ? place.altitudeAmslMeters()
                : new PlanWaypointReader(crafts(run)).amslMeters("", request.altitude(), request.altitudeReference());
        return new RunInput.MoveWaypoint(at, by, target.id(), new Place(point, amsl));
    }

    RunInput cancelled(RunWaypoint target) {
        return new RunInput.CancelWaypoint(at, by, target.id());
    }

    /** Binds all drones of the run, until it is over. */
    RunInput barrier(ZoneFeature feature) {
        ZoneReader reader = new ZoneReader("", feature);
        ZoneFeature.ZoneProperties properties = feature.properties();
        if (properties != null
                && (properties.user() != null
                        || properties.drone() != null
                        || properties.from() != null
                        || properties.until() != null
                        || properties.onBreach() != null)) {
            throw new InvalidInput(
                    ValueProblem.VALUE_NOT_ALLOWED,
                    "properties",
                    "name, kind, radius, floor, ceiling and altitudeReference",
                    "A zone of a run binds all of its drones from now on; make a zone of the cloud for anything else.");
        }
        String words = Zone.words(reader.shape(), reader.name());
        return new RunInput.AddBarrier(at, by, new Barrier(words, reader.shape(), reader.band(), Set.of()));
    }

    RunInput joined(Craft craft, DroneState drone) {
        return new RunInput.JoinDrone(
                at, by, craft, drone.name(), drone.identification().kind());
    }

    RunInput resumed(DroneId drone) {
        return new RunInput.ResumeDrone(at, by, drone);
    }

    RunInput givenUp(DroneId drone) {
        return new RunInput.GiveUpDrone(at, by, drone);
    }

    RunInput answered(String proposal, RunRequest.AnswerRequest request) {
        if (!proposal.matches("[0-9]{1,9}")) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_MALFORMED, "proposal", "the number of a proposal", "\"" + proposal + "\"");
        }
        if (request.accept() == null) {
            throw InvalidInput.missing("accept", "true or false");
        }
        return new RunInput.AnswerProposal(at, by, Integer.parseInt(proposal), request.accept());
    }

    RunInput paused() {
        return new RunInput.Pause(at, by);
    }

    RunInput wentOn() {
        return new RunInput.Resume(at, by);
    }

    RunInput stopped() {
        return new RunInput.Stop(at, by);
    }

    private static List<Craft> crafts(RunState run) {
        return run.drones().stream().map(RunDrone::craft).toList();
    }
}
