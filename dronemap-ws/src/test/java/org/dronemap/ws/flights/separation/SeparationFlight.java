package org.dronemap.ws.flights.separation;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.LaboratorySetup;

/** One scenario with one seed: each operation alone, and then, as often as wanted, all of them at once. */
final class SeparationFlight {
    private static final Duration LOOK = Duration.ofMillis(100);
    private static final double LONGEST_ALONE = 600;
    private static final double LONGEST_FACTOR = 3;
    private static final double LONGEST_SLACK = 120;
    private static final double GOES_ON = 5;
    private static final int REHEARSALS = 6;

    private final Scenario scenario;
    private final long seed;
    private final List<Party> parties;
    private final List<Alone> alone;
    private Meeting meeting;
    private FlownTogether rehearsal;

    private SeparationFlight(Scenario scenario, long seed, List<Party> parties, List<Alone> alone) {
        this.scenario = scenario;
        this.seed = seed;
        this.parties = parties;
        this.alone = alone;
        SplittableRandom chance = new SplittableRandom(~seed);
        meeting = Meeting.of(alone, chance);
        rehearsal = flown(false, Disturbance.NONE, 0);
        // A follow gives way to others by itself, and then is not where it was alone.
        for (int further = 1; further < REHEARSALS && rehearsal.leastShare() >= 1; further++) {
            meeting = Meeting.of(alone, chance);
            rehearsal = flown(false, Disturbance.NONE, 0);
        }
    }

    /**
     * Flies each of its operations alone, and all of them with nothing that keeps them apart, at times that are chosen until
     * they come too near to each other.
     */
    static SeparationFlight of(Scenario scenario, long seed) {
        List<Party> parties = scenario.parties(seed);
        return new SeparationFlight(
                scenario,
                seed,
                parties,
                parties.stream().map(party -> alone(party, seed)).toList());
    }

    private static Alone alone(Party party, long seed) {
        try (Laboratory lab = LaboratorySetup.seeded(seed).separation(false).build()) {
            Together flown = new Together(lab, List.of(party), List.of(0.0));
            if (!flown.fly(LONGEST_ALONE, Disturbance.NONE, 0)) {
                throw new AssertionError(party + " is not over: " + lab.now());
            }
            return Alone.of(flown.flights().get(0), flown.beganNanos());
        }
    }

    /** By then all would be down if nobody were in anybody's way, in seconds after the first moment. */
    double lastSecond() {
        double last = 0;
        for (int number = 0; number < parties.size(); number++) {
            last = Math.max(
                    last, meeting.begins().get(number) + alone.get(number).seconds());
        }
        return last;
    }

    Meeting meeting() {
        return meeting;
    }

    /** All at once, with nothing that keeps drones of different operations apart. */
    FlownTogether rehearsal() {
        return rehearsal;
    }

    /** All at once, kept apart if this version can. {@code disturbed}: seconds after the first moment at which that comes between. */
    FlownTogether together(Disturbance disturbance, double disturbed) {
        boolean separation = LaboratorySetup.isSeparationOn();
        boolean rehearsed = !separation && disturbance == Disturbance.NONE;
        return rehearsed ? rehearsal : flown(separation, disturbance, disturbed);
    }

    private FlownTogether flown(boolean separation, Disturbance disturbance, double disturbed) {
        double longest = 0;
        for (int number = 0; number < parties.size(); number++) {
            double own = LONGEST_FACTOR * alone.get(number).seconds() + LONGEST_SLACK;
            longest = Math.max(longest, meeting.begins().get(number) + own);
        }
        try (Laboratory lab =
                LaboratorySetup.seeded(seed).separation(separation).build()) {
            Together flown = new Together(lab, parties, meeting.begins());
            boolean unused = flown.fly(longest, disturbance, disturbed);
            return new FlownTogether(
                    new FlownTogether.Label(scenario, seed, lab.separates(), disturbance, disturbed),
                    parties,
                    alone,
                    meeting,
                    flown.flights(),
                    flown.beganNanos());
        }
    }

    /** Operations in one laboratory, each of which begins at its time. */
    private static final class Together {
        private final Laboratory lab;
        private final List<Party.Flight> flights;
        private final List<Double> begins;
        private final boolean[] begun;
        private final long beganNanos;

        Together(Laboratory lab, List<Party> parties, List<Double> begins) {
            this.lab = lab;
            this.begins = begins;
            begun = new boolean[parties.size()];
            List<Party.Flight> prepared = new ArrayList<>();
            parties.forEach(party -> prepared.add(party.prepared(lab)));
            flights = prepared;
            lab.goOn(LOOK.minusNanos(lab.time().nanos() % LOOK.toNanos()));
            beganNanos = lab.time().nanos();
        }

        List<LabDrone> drones() {
            return flights.stream().flatMap(flight -> flight.drones().stream()).toList();
        }

        List<Party.Flight> flights() {
            return flights;
        }

        long beganNanos() {
            return beganNanos;
        }

        /** False: it is not over after so many seconds. */
        boolean fly(double longest, Disturbance disturbance, double disturbed) {
            double end = disturbed + disturbance.lasts().toMillis() / 1e3;
            double least = disturbance == Disturbance.NONE ? 0 : end;
            double before = -1;
            boolean over = false;
            while (!over && seconds() < longest) {
                // Between what happens in the server: one of its threads may be waited for.
                if (before < disturbed && seconds() >= disturbed) {
                    disturbance.begin(lab, drones());
                }
                if (before < end && seconds() >= end) {
                    disturbance.end(lab, drones());
                }
                before = seconds();
                if (lab.isUp()) {
                    step();
                }
                lab.goOn(LOOK);
                over = seconds() > least && isOver(disturbance);
            }
            lab.goOn(Duration.ofMillis(Math.round(GOES_ON * 1_000)));
            return over;
        }

        private double seconds() {
            return (lab.time().nanos() - beganNanos) / 1e9;
        }

        private boolean isOver(Disturbance disturbance) {
            return haveAllBegun()
                    && drones().stream().allMatch(LabDrone::isDown)
                    && (disturbance.changesOperations() || flights.stream().allMatch(Party.Flight::isOver));
        }

        /** Those whose server does not come back never begin. */
        private boolean haveAllBegun() {
            return !lab.isUp() || IntStream.range(0, begun.length).allMatch(number -> begun[number]);
        }

        private void step() {
            for (int number = 0; number < begun.length; number++) {
                if (!begun[number] && seconds() >= begins.get(number)) {
                    begun[number] = true;
                    flights.get(number).begin();
                } else if (begun[number]) {
                    flights.get(number).step();
                }
            }
        }
    }
}
