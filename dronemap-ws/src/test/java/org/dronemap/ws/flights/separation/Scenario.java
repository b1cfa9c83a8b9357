package org.dronemap.ws.flights.separation;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;

/** A mixture of operations whose ways cross at equal heights; pads, waypoints and heights come from a seed. */
enum Scenario {
    /** A mission run, and the mission of a virtual drone. */
    VIRTUAL_DRONE {
        @Override
        List<Party> parties(Ground ground) {
            return List.of(
                    ground.run("run 1", Ground.Edge.SOUTH, 2 + ground.chance(2)),
                    ground.virtual("virtual 1", Ground.Edge.EAST, 0));
        }
    },

    /** A mission run, and a drone that somebody flies by hand through its area. */
    BY_HAND {
        @Override
        List<Party> parties(Ground ground) {
            return List.of(
                    ground.run("run 1", Ground.Edge.SOUTH, 2 + ground.chance(3)),
                    ground.byHand("hand 1", Ground.Edge.EAST, 0));
        }
    },

    /** Mission runs of two users. */
    TWO_RUNS {
        @Override
        List<Party> parties(Ground ground) {
            return List.of(
                    ground.run("run 1", Ground.Edge.SOUTH, 2 + ground.chance(2)),
                    ground.run("run 2", Ground.Edge.EAST, 2 + ground.chance(2)));
        }
    },

    /** A mission run, and a phone that walks straight through its area with a drone behind it. */
    FOLLOW {
        @Override
        List<Party> parties(Ground ground) {
            return List.of(
                    ground.run("run 1", Ground.Edge.SOUTH, 3 + ground.chance(2)),
                    ground.follow("follow 1", Ground.Edge.WEST, 0));
        }

        @Override
        double side() {
            return 100;
        }
    },

    /** A drone, or with every second seed all of another run, that is called home through all of the others. */
    RETURN {
        @Override
        List<Party> parties(Ground ground) {
            List<Party> parties = new ArrayList<>(List.of(
                    ground.run("run 1", Ground.Edge.SOUTH, 2 + ground.chance(2)),
                    ground.follow("follow 1", Ground.Edge.WEST, 0),
                    ground.virtual("virtual 1", Ground.Edge.EAST, 0)));
            parties.add(
                    ground.isEven()
                            ? ground.returning("return 1", Ground.Edge.SOUTH, 4)
                            : ground.stoppedRun("run 2", Ground.Edge.NORTH, 2));
            return parties;
        }
    },

    /** Seven to eighteen drones: runs of two users, virtual drones, and a follow with every third seed. */
    MIXED {
        @Override
        List<Party> parties(Ground ground) {
            List<Party> parties = new ArrayList<>();
            parties.add(ground.run("run 1", Ground.Edge.SOUTH, 3 + ground.chance(3)));
            parties.add(ground.run("run 2", Ground.Edge.EAST, 3 + ground.chance(3)));
            int virtuals = 1 + ground.chance(7);
            for (int number = 0; number < virtuals; number++) {
                Ground.Edge edge = number % 2 == 0 ? Ground.Edge.NORTH : Ground.Edge.WEST;
                parties.add(ground.virtual("virtual " + (number + 1), edge, 1 + number / 2));
            }
            if (ground.chance(3) == 0) {
                parties.add(ground.follow("follow 1", Ground.Edge.WEST, 0));
            }
            return parties;
        }

        @Override
        double side() {
            return 300;
        }

        @Override
        String onCloudLoss() {
            return "continue";
        }
    },

    /** Thirty drones: four runs, eight virtual drones, a follow, and one that is flown by hand. */
    FLEET {
        private static final int VIRTUALS = 8;

        @Override
        List<Party> parties(Ground ground) {
            List<Party> parties = new ArrayList<>();
            Ground.Edge[] edges = Ground.Edge.values();
            for (int number = 0; number < edges.length; number++) {
                parties.add(ground.run("run " + (number + 1), edges[number], 5));
            }
            for (int number = 0; number < VIRTUALS; number++) {
                parties.add(ground.virtual(
                        "virtual " + (number + 1), edges[number % edges.length], 5 + number / edges.length));
            }
            parties.add(ground.follow("follow 1", Ground.Edge.WEST, 7));
            parties.add(ground.byHand("hand 1", Ground.Edge.EAST, 7));
            return parties;
        }

        @Override
        double side() {
            return 300;
        }
    };

    private static final long SEEDS_APART = 7_919;

    abstract List<Party> parties(Ground ground);

    /** Of the area in which waypoints lie, m. */
    double side() {
        return 130;
    }

    /** What drones on missions do that hear no server any more. */
    String onCloudLoss() {
        return "rtl";
    }

    /** The operations of that seed. */
    final List<Party> parties(long seed) {
        return parties(new Ground(new SplittableRandom(seed * SEEDS_APART + ordinal()), side(), seed, onCloudLoss()));
    }

    final String words() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
