package org.dronemap.sim;

import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.sim.physics.NeuPosition;

/** What was done with a vehicle before the recording began, where that is more than parameters of a fail-safe. */
final class FirmwarePreparations {
    private static final int RALLY = 2;
    private static final int RALLY_POINT = 5100;

    private FirmwarePreparations() {}

    static void prepare(VehicleTestBench bench, String preparation) {
        switch (preparation) {
            case "after a return" -> flyAndReturn(bench);
            case "150 m north" -> uploadWayNorth(bench, 150);
            case "fence" -> setFence(bench, 1);
            case "fence, 150 m north" -> {
                setFence(bench, 1);
                uploadWayNorth(bench, 150);
            }
            case "fence that tells, 75 m north" -> {
                setFence(bench, 0);
                uploadWayNorth(bench, 75);
            }
            case "rally point 60 m east" -> uploadRallyPoint(bench, 60, 20);
            case "two batteries" -> bench.parameter("BATT2_MONITOR", 4);
            default -> throw new IllegalArgumentException("no such preparation: " + preparation);
        }
    }

    private static void setFence(VehicleTestBench bench, int action) {
        bench.parameter("FENCE_TYPE", 3);
        bench.parameter("FENCE_RADIUS", 60);
        bench.parameter("FENCE_ALT_MAX", 40);
        bench.parameter("FENCE_ACTION", action);
        bench.parameter("FENCE_ENABLE", 1);
    }

    private static void uploadRallyPoint(VehicleTestBench bench, double east, float up) {
        var home = bench.vehicle.craft().home();
        NeuPosition place = new NeuPosition(0, east, 0);
        int latitude = (int) Math.round(home.latitudeOf(place) * 1e7);
        int longitude = (int) Math.round(home.longitudeOf(place) * 1e7);
        bench.send(new MissionCount(1, 1, 1, RALLY));
        bench.send(new MissionItemInt(1, 1, 0, 3, RALLY_POINT, 0, 1, 0, 0, 0, 0, latitude, longitude, up, RALLY));
    }

    private static void uploadWayNorth(VehicleTestBench bench, double north) {
        bench.upload(bench.item(0, 16, 0, 0, 0), bench.item(1, 16, north, 0, 20));
    }

    private static void flyAndReturn(VehicleTestBench bench) {
        bench.command(176, 1, 4);
        bench.command(400, 1);
        bench.command(22, 0, 0, 0, 0, 0, 0, 8);
        bench.run(15);
        bench.command(176, 1, 6);
        runUntilDisarmed(bench);
    }

    /** The mission that is stored, from the ground to its end. */
    static void flyMission(VehicleTestBench bench) {
        bench.command(176, 1, 4);
        bench.command(400, 1);
        bench.command(176, 1, 3);
        bench.command(300);
        runUntilDisarmed(bench);
    }

    private static void runUntilDisarmed(VehicleTestBench bench) {
        for (int seconds = 0; seconds < 240 && bench.armed(); seconds++) {
            bench.run(1);
        }
        bench.run(2);
    }
}
