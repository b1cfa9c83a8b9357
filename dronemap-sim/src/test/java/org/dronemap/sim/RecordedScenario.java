package org.dronemap.sim;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.dronemap.mavlink.message.EkfStatusReport;
import org.dronemap.mavlink.message.ExtendedSysState;
import org.dronemap.mavlink.message.FenceStatus;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.mavlink.message.MissionCurrent;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.dronemap.mavlink.message.SysStatus;
import org.dronemap.mavlink.message.VfrHud;

/** One recorded exchange: how the vehicle is brought to where it began, and what was said and answered from then on. */
final class RecordedScenario {
    private static final int HOME_LATITUDE = -353_632_610;
    private static final int HOME_LONGITUDE = 1_491_652_299;
    private static final String REAL_READY_SECONDS = "40.4";
    private static final String NEVER_SECONDS = "600";
    private static final String PLANE_READY_SECONDS = "36.5";
    /** The first heartbeat of its first mode comes a few milliseconds before it says that it is ready. */
    private static final long FIRST_BEAT_MILLIS = 10;

    private final List<RecordedLine> lines;
    private final VehicleTestBench bench;
    private final long begin;
    private final long start;

    RecordedScenario(RecordedExchange exchange) {
        double height = exchange.height;
        boolean fromPowerUp = exchange.preparation.equals("power-up");
        List<RecordedLine> all = RecordedLine.read(exchange.fileName());
        // Nothing said before the real one had booted is replayed: it forgets that when it is ready.
        this.begin = fromPowerUp ? millisOf(all, "ArduPilot Ready") - FIRST_BEAT_MILLIS : 0;
        this.lines = all.stream().filter(line -> line.millis() >= begin).toList();
        RecordedVehicle vehicle = RecordedVehicle.of(exchange);
        this.bench = exchange.preparation.equals("never a position")
                ? VehicleTestBench.ready(vehicle.optionsReadyAfter(NEVER_SECONDS))
                : fromPowerUp
                        ? new VehicleTestBench(vehicle.optionsReadyAfter(
                                vehicle == RecordedVehicle.PLANE ? PLANE_READY_SECONDS : REAL_READY_SECONDS))
                        : standingOrFlying(height, vehicle.options());
        prepare(exchange.preparation);
        if (height > 0) {
            flyToWhereItBegan(height);
        }
        askForTelemetry();
        bench.runTo(fromPowerUp ? begin : bench.now());
        bench.heard.clear();
        this.start = bench.now() - begin;
    }

    private static long millisOf(List<RecordedLine> lines, String text) {
        return lines.stream()
                .filter(line -> line.text("text").equals(text))
                .mapToLong(RecordedLine::millis)
                .findFirst()
                .orElseThrow();
    }

    private static VehicleTestBench standingOrFlying(double height, String[] options) {
        return height > 0 ? VehicleTestBench.flying(height, options) : VehicleTestBench.ready(options);
    }

    private void prepare(String preparation) {
        switch (preparation) {
            case "battery" -> {
                bench.parameter("BATT_LOW_VOLT", 11.5);
                bench.parameter("BATT_CRT_VOLT", 10.5);
                bench.parameter("BATT_FS_LOW_ACT", 2);
                bench.parameter("BATT_FS_CRT_ACT", 1);
            }
            case "guided" -> bench.command(176, 1, 4);
            case "ground station" -> bench.parameter("FS_GCS_ENABLE", 1);
            case "six items" -> bench.upload(recordedItems(6));
            case "five items" -> bench.upload(recordedItems(5));
            case "in AUTO" -> flyMission();
            case "in AUTO, ground station" -> {
                bench.parameter("FS_GCS_ENABLE", 1);
                bench.parameter("FS_OPTIONS", 2);
                flyMission();
            }
            case "without GPS" -> {
                bench.parameter("SIM_GPS_DISABLE", 1);
                bench.run(12);
            }
            case "without GPS and checks" -> {
                bench.parameter("SIM_GPS_DISABLE", 1);
                bench.parameter("ARMING_CHECK", 0);
                bench.run(12);
            }
            case "after a mission" -> {
                bench.upload(recordedItems(6));
                FirmwarePreparations.flyMission(bench);
            }
            case "", "power-up" -> {}
            case "never a position" -> bench.parameter("ARMING_CHECK", 0);
            default -> prepareOtherwise(preparation);
        }
    }

    private void prepareOtherwise(String preparation) {
        if (!preparation.contains("=")) {
            FirmwarePreparations.prepare(bench, preparation);
            return;
        }
        for (String setting : preparation.split(" ")) {
            String[] parts = setting.split("=");
            bench.parameter(parts[0], Double.parseDouble(parts[1]));
        }
    }

    /** At the rates of the recorder. */
    private void askForTelemetry() {
        for (int id : new int[] {GlobalPositionInt.ID, VfrHud.ID, ExtendedSysState.ID}) {
            bench.command(511, id, 100_000);
        }
        bench.command(511, MissionCurrent.ID, 200_000);
        bench.command(511, FenceStatus.ID, 200_000);
        bench.command(511, EkfStatusReport.ID, 500_000);
        bench.command(511, SysStatus.ID, 500_000);
    }

    private void flyMission() {
        bench.upload(recordedItems(5));
        bench.command(176, 1, 3);
        runUntil(() -> bench.vehicle.autopilot().currentItem() == 2);
    }

    private void runUntil(BooleanSupplier condition) {
        for (int tenths = 0; tenths < 300 && !condition.getAsBoolean(); tenths++) {
            bench.run(0.1);
        }
    }

    /** The items of the recorded upload, which the recorded flights then flew. */
    private static MissionItemInt[] recordedItems(int count) {
        return RecordedLine.read("mission_upload").stream()
                .filter(line -> line.isSaid() && line.is("MISSION_ITEM_INT"))
                .limit(count)
                .map(GroundStationReplayer::item)
                .toArray(MissionItemInt[]::new);
    }

    private void flyToWhereItBegan(double height) {
        long latitude = lines.stream()
                .filter(line -> line.is("GLOBAL_POSITION_INT"))
                .mapToLong(line -> line.integer("lat"))
                .findFirst()
                .orElse(HOME_LATITUDE);
        if (Math.abs(latitude - HOME_LATITUDE) > 500) {
            bench.send(new SetPositionTargetGlobalInt(
                    0, 1, 1, 6, 3576, (int) latitude, HOME_LONGITUDE, (float) height, 0, 0, 0, 0, 0, 0, 0, 0));
            bench.run(25);
        }
    }

    /** Says everything at its time; afterwards the bench holds what the simulated vehicle sent. */
    VehicleTestBench play() {
        boolean ownBeats = lines.stream().noneMatch(line -> line.isSaid() && line.is("HEARTBEAT"));
        bench.groundTalks(ownBeats);
        for (RecordedLine line : lines) {
            bench.runTo(start + line.millis());
            if (line.isSaid()) {
                GroundStationReplayer.say(bench, line);
            }
        }
        bench.run(1);
        return bench;
    }

    String mode() {
        return "" + bench.mode();
    }

    VehicleTestBench bench() {
        return bench;
    }

    /** What was really said and heard, as far as it is replayed. */
    Transcript recorded() {
        return new Transcript(lines);
    }

    /** What the simulated vehicle made of it. */
    Transcript played() {
        return Transcript.of(lines, bench.heard, start);
    }

    List<VehicleAnswer> real() {
        return lines.stream()
                .filter(line -> !line.isSaid())
                .map(VehicleAnswer::fromRecording)
                .flatMap(Optional::stream)
                .toList();
    }

    List<VehicleAnswer> simulated() {
        List<VehicleAnswer> answers = new ArrayList<>();
        bench.heard.forEach(heard -> VehicleAnswer.fromVehicle(heard, start).ifPresent(answers::add));
        return answers;
    }
}
