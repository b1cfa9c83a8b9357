package org.dronemap.ws.follow;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.dronemap.cognitive.follow.StandOffSide;
import org.dronemap.cognitive.operation.follow.FollowOrder;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.operation.TargetReport;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.FieldRanges;
import org.dronemap.ws.reading.NameRules;
import org.jspecify.annotations.Nullable;

/** Turns a client's request about a follow into inputs of the follow operation, or rejects the faulty field. */
final class FollowReader {
    private static final FollowOrder.RelativePlace USUAL =
            new FollowOrder.RelativePlace(new StandOffSide.Behind(), 8, 15);
    static final int LONGEST_NAME = 60;
    static final int MOST_POSITIONS = 60;
    static final int MOST_MINUTES = 60;
    /** Of a drone, in m/s. */
    static final int FASTEST = 15;
    /** In m/s. */
    static final int FASTEST_PHONE = 100;
    /** In seconds. */
    static final int LEAST_PATIENCE = 10;

    static final int MOST_PATIENCE = 600;
    /** In degrees. */
    static final int FULL_CIRCLE = 360;
    /** In degrees a second, either way. */
    static final int MOST_TURN = 30;
    /** In metres on the ground. */
    static final int FARTHEST = 200;
    /** In milliseconds. */
    static final int LONGEST_ROUND_TRIP = 60_000;
    /** In metres. */
    static final int WORST_ACCURACY = 100_000;

    /** All that a page's numbers tell apart. */
    static final long MOST_ID = (1L << 53) - 1;

    private static final Instant EARLIEST = Instant.EPOCH;
    private static final Instant LATEST = Instant.parse("2200-01-01T00:00:00Z");
    /** A phone's receiver may be so far ahead of its own clock. */
    private static final Duration AHEAD = Duration.ofSeconds(60);

    private static final double USUAL_MINUTES = 10;
    private static final double USUAL_SPEED = 12;
    private static final double USUAL_PATIENCE = 60;
    private static final double USUAL_ACCURACY = 10;
    private static final String SIDES = "behind, ahead, fixed or orbit";
    private static final String COUNT = "up to " + MOST_POSITIONS + " positions";

    private FollowReader() {}

    static String name(FollowRequest.OpenRequest request) {
        return request.name() == null ? "Follow" : NameRules.checked("name", request.name(), LONGEST_NAME);
    }

    static Geodetic near(FollowRequest.OpenRequest request) {
        return new Geodetic(
                FieldRanges.latitude("latitude", request.latitude()),
                FieldRanges.longitude("longitude", request.longitude()));
    }

    static double minutes(FollowRequest.OpenRequest request) {
        return FieldRanges.checked("minutes", or(request.minutes(), USUAL_MINUTES), 1, MOST_MINUTES, "minutes");
    }

    static double speed(FollowRequest.OpenRequest request) {
        return FieldRanges.checked("speed", or(request.speed(), USUAL_SPEED), 1, FASTEST, "m/s");
    }

    static int patience(FollowRequest.OpenRequest request) {
        return (int) FieldRanges.checked(
                "patience", or(request.patience(), USUAL_PATIENCE), LEAST_PATIENCE, MOST_PATIENCE, "seconds");
    }

    static FollowOrder.RelativePlace place(FollowRequest.OpenRequest request) {
        FollowRequest.PlaceRequest place = request.place();
        return place == null ? USUAL : place(place, USUAL, "place.");
    }

    static FollowOrder.RelativePlace place(
            FollowRequest.PlaceRequest request, FollowOrder.RelativePlace before, String above) {
        return new FollowOrder.RelativePlace(
                side(request, before.side(), above),
                FieldRanges.checked(
                        above + "distance", or(request.distance(), before.distanceMeters()), 0, FARTHEST, "m"),
                FieldRanges.checked(
                        above + "height",
                        or(request.height(), before.heightMeters()),
                        (int) FollowOrder.LOWEST_METERS,
                        (int) FollowOrder.HIGHEST_METERS,
                        "m"));
    }

    private static StandOffSide side(FollowRequest.PlaceRequest request, StandOffSide before, String above) {
        if (request.side() == null) {
            return before;
        }
        return switch (request.side()) {
            case "behind" -> new StandOffSide.Behind();
            case "ahead" -> new StandOffSide.Ahead();
            case "fixed" ->
                new StandOffSide.Fixed(FieldRanges.checked(
                        above + "bearing", request.bearing(), -FULL_CIRCLE, FULL_CIRCLE, "degrees"));
            case "orbit" -> orbit(request, above);
            default ->
                throw InvalidInput.outside(
                        ValueProblem.VALUE_NOT_ALLOWED, above + "side", SIDES, "\"" + request.side() + "\"");
        };
    }

    private static StandOffSide orbit(FollowRequest.PlaceRequest request, String above) {
        double turn = FieldRanges.checked(above + "turn", request.turn(), -MOST_TURN, MOST_TURN, "degrees a second");
        if (turn == 0) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_OUT_OF_RANGE,
                    above + "turn",
                    "-30 to 30 degrees a second, not 0",
                    turn,
                    ProblemParameter.LEAST.is(-30),
                    ProblemParameter.MOST.is(30),
                    ProblemParameter.UNIT.is("degrees a second"));
        }
        return new StandOffSide.Orbit(turn);
    }

    private static double or(@Nullable Double value, double otherwise) {
        return value == null ? otherwise : value;
    }

    static List<TargetReport> sightings(FollowRequest.PositionsRequest request, Instant heard) {
        Instant sent = request.sent();
        if (sent == null) {
            throw InvalidInput.missing("sent", "a time");
        }
        List<FollowRequest.@Nullable PositionRequest> positions = request.positions();
        if (positions == null) {
            throw InvalidInput.missing("positions", COUNT);
        }
        if (positions.size() > MOST_POSITIONS) {
            throw InvalidInput.outside(
                    ValueProblem.SIZE_OUT_OF_RANGE,
                    "positions",
                    COUNT,
                    positions.size(),
                    ProblemParameter.MOST.is(MOST_POSITIONS));
        }
        Double roundTrip = request.roundTrip();
        Duration measured = roundTrip == null
                ? null
                : Duration.ofMillis(
                        (long) FieldRanges.checked("roundTrip", roundTrip, 0, LONGEST_ROUND_TRIP, "milliseconds"));
        List<TargetReport> sightings = new ArrayList<>();
        for (int index = 0; index < positions.size(); index++) {
            sightings.add(sighting(
                    positions.get(index),
                    "positions[" + index + "]",
                    new Transmission(time("sent", sent), heard, measured)));
        }
        sightings.sort(Comparator.comparingLong(TargetReport::number));
        return sightings;
    }

    private static Instant time(String field, Instant time) {
        if (time.isBefore(EARLIEST) || time.isAfter(LATEST)) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_OUT_OF_RANGE, field, EARLIEST + " to " + LATEST, time.toString());
        }
        return time;
    }

    private record Transmission(
            Instant sent, Instant receivedAt, @Nullable Duration roundTrip) {}

    private static TargetReport sighting(
            FollowRequest.@Nullable PositionRequest position, String field, Transmission said) {
        if (position == null || position.at() == null) {
            throw InvalidInput.missing(field + ".at", "a time");
        }
        Instant at = time(field + ".at", position.at());
        Long id = position.id();
        if (id != null && (id < 0 || id > MOST_ID)) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_OUT_OF_RANGE,
                    field + ".id",
                    "0 to " + MOST_ID,
                    id,
                    ProblemParameter.LEAST.is(0),
                    ProblemParameter.MOST.is(MOST_ID));
        }
        if (at.isAfter(said.sent().plus(AHEAD))) {
            String allowed = "at most " + AHEAD.toSeconds() + " s after \"sent\"";
            throw InvalidInput.outside(ValueProblem.VALUE_OUT_OF_RANGE, field + ".at", allowed, at.toString());
        }
        Double speed = optional(field + ".speed", position.speed(), 0, FASTEST_PHONE, "m/s");
        Double course = optional(field + ".course", position.course(), -FULL_CIRCLE, FULL_CIRCLE, "degrees");
        Instant then = at.isAfter(said.sent()) ? said.sent() : at;
        return new TargetReport(
                // By the time that it is taken for: nothing that comes later may seem to be known.
                id == null ? then.toEpochMilli() : id,
                then,
                said.sent(),
                said.receivedAt(),
                said.roundTrip(),
                new Geodetic(
                        FieldRanges.latitude(field + ".latitude", position.latitude()),
                        FieldRanges.longitude(field + ".longitude", position.longitude())),
                FieldRanges.checked(
                        field + ".accuracy", or(position.accuracy(), USUAL_ACCURACY), 0, WORST_ACCURACY, "m"),
                speed == null || course == null ? null : new TargetReport.Motion(speed, course));
    }

    private static @Nullable Double optional(String field, @Nullable Double value, int least, int most, String unit) {
        return value == null ? null : Double.valueOf(FieldRanges.checked(field, value, least, most, unit));
    }
}
