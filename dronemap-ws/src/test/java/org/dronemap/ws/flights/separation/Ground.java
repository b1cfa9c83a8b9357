package org.dronemap.ws.flights.separation;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;

/** A square area with pads along its edges, from which chance puts operations together that all fly in one narrow band of heights. */
final class Ground {
    private static final double BEFORE_THE_EDGE = 30;
    private static final double PADS_APART = 30;
    private static final double SCATTER = 6;
    private static final double BAND_FROM = 20;
    private static final double BAND_TO = 21.5;
    private static final double UNEVEN = 0.5;
    private static final double WAYPOINTS_APART = 15;
    private static final int TRIES = 200;
    private static final double HAND_SECONDS = 110;
    private static final double BEYOND = 45;
    private static final double FOLLOWED_METERS = 100;

    private final SplittableRandom chance;
    private final double side;
    private final long seed;
    private final String onCloudLoss;

    /** An edge of the area, along which pads lie. */
    enum Edge {
        SOUTH,
        EAST,
        NORTH,
        WEST
    }

    /** {@code onCloudLoss}: what drones on missions do that hear no server any more. */
    Ground(SplittableRandom chance, double side, long seed, String onCloudLoss) {
        this.chance = chance;
        this.side = side;
        this.seed = seed;
        this.onCloudLoss = onCloudLoss;
    }

    int chance(int bound) {
        return chance.nextInt(bound);
    }

    boolean isEven() {
        return seed % 2 == 0;
    }

    RunParty run(String name, Edge edge, int drones) {
        return RunParty.whole(name, pads(edge, 0, drones), waypoints(4 + chance.nextInt(3) + drones / 4), onCloudLoss);
    }

    RunParty stoppedRun(String name, Edge edge, int drones) {
        return new RunParty(name, pads(edge, 0, drones), waypoints(5), onCloudLoss, chance.nextDouble(25, 35));
    }

    VirtualParty virtual(String name, Edge edge, int number) {
        return new VirtualParty(name, pad(edge, number), waypoints(3 + chance.nextInt(4)), onCloudLoss);
    }

    HandParty byHand(String name, Edge edge, int number) {
        Spot corner = new Spot(0, 0, height());
        return new HandParty(name, pad(edge, number), chance.nextLong(), corner, side, HAND_SECONDS);
    }

    /** From the west to the east, more or less. */
    FollowParty follow(String name, Edge edge, int number) {
        Spot pad = pad(edge, number);
        double speed = chance.nextDouble(1.4, 2.2);
        double direction = chance.nextDouble(-0.3, 0.3);
        Spot phone = new Spot(chance.nextDouble(0.35, 0.65) * side, 0, 0);
        return new FollowParty(
                name,
                pad,
                phone,
                speed * Math.sin(direction),
                speed * Math.cos(direction),
                FOLLOWED_METERS / speed,
                height());
    }

    ReturnParty returning(String name, Edge edge, int number) {
        Spot away = new Spot(side + BEYOND, chance.nextDouble(0.2, 0.8) * side, height());
        return new ReturnParty(name, pad(edge, number), away);
    }

    private List<Spot> pads(Edge edge, int first, int count) {
        return IntStream.range(first, first + count)
                .mapToObj(number -> pad(edge, number))
                .toList();
    }

    /** Far enough from all other pads that nobody is in anybody's way there. */
    private Spot pad(Edge edge, int number) {
        double along = number * PADS_APART + chance.nextDouble(SCATTER);
        double before = -BEFORE_THE_EDGE + chance.nextDouble(-SCATTER, SCATTER);
        double beyond = side - before;
        double up = chance.nextDouble(-UNEVEN, UNEVEN);
        return switch (edge) {
            case SOUTH -> new Spot(before, along, up);
            case EAST -> new Spot(along, beyond, up);
            case NORTH -> new Spot(beyond, along, up);
            case WEST -> new Spot(along, before, up);
        };
    }

    private List<Spot> waypoints(int count) {
        List<Spot> found = new ArrayList<>();
        for (int attempt = 0; found.size() < count && attempt < TRIES; attempt++) {
            Spot spot = new Spot(chance.nextDouble(side), chance.nextDouble(side), height());
            if (found.stream().allMatch(other -> other.metersOverGroundTo(spot) > WAYPOINTS_APART)) {
                found.add(spot);
            }
        }
        return found;
    }

    private double height() {
        return chance.nextDouble(BAND_FROM, BAND_TO);
    }
}
