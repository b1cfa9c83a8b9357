package org.dronemap.cognitive.cost;

/** Costs of straight legs between places, where no barriers are in the way; computed anew each time. Never changes. */
final class DirectLegs implements Legs {
    private final PlaceTable track;
    private final FlightModel[] paces;

    DirectLegs(PlaceTable track, FlightModel[] paces) {
        this.track = track;
        this.paces = paces.clone();
    }

    @Override
    public int places() {
        return track.places;
    }

    @Override
    public double eastMeters(int place) {
        return track.x[place] * track.stretch[place];
    }

    @Override
    public double northMeters(int place) {
        return track.north[place];
    }

    @Override
    public double seconds(int type, int from, int to) {
        FlightModel pace = paces[type];
        double east = track.east(from, to);
        double north = track.north(from, to);
        if (from < track.waypoints && to < track.waypoints) {
            return pace.seconds(east, north, track.altitude[to] - track.altitude[from]);
        }
        double leaves = track.leaves(from, to);
        double reaches = track.reaches(from, to);
        double seconds = pace.seconds(east, north, reaches - leaves);
        if (track.ground[from]) {
            seconds += pace.riseSeconds(leaves - track.altitude[from]);
        }
        return track.ground[to] ? seconds + pace.landingSeconds(reaches - track.altitude[to]) : seconds;
    }

    @Override
    public double meters(int type, int from, int to) {
        double leaves = track.leaves(from, to);
        double reaches = track.reaches(from, to);
        double east = track.east(from, to);
        double north = track.north(from, to);
        double up = reaches - leaves;
        return Math.sqrt(east * east + north * north + up * up)
                + (leaves - track.altitude[from])
                + (reaches - track.altitude[to]);
    }

    @Override
    public double joules(int type, int from, int to) {
        FlightModel pace = paces[type];
        double leaves = track.leaves(from, to);
        double reaches = track.reaches(from, to);
        double joules = pace.joules(track.east(from, to), track.north(from, to), reaches - leaves);
        if (track.ground[from]) {
            joules += pace.riseJoules(leaves - track.altitude[from]);
        }
        return track.ground[to] ? joules + pace.landingJoules(reaches - track.altitude[to]) : joules;
    }
}
