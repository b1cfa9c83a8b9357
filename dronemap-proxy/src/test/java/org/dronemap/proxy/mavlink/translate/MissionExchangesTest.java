package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.SetRallyPoints;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.mission.RallyPoint;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionWritePartialList;
import org.dronemap.proxy.mavlink.procedure.FloatMissionVehicle;
import org.dronemap.proxy.mavlink.procedure.MissionVehicle;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class MissionExchangesTest {
    private static final Outcome DONE = new Outcome.Succeeded();

    private final MissionVehicle vehicle = new MissionVehicle();

    private static Command.UploadMission mission(int changed, double altitude) {
        List<MissionItem> items = new ArrayList<>(IntStream.range(0, 10)
                .<MissionItem>mapToObj(number -> waypoint(number, 20))
                .toList());
        if (changed >= 0) {
            items.set(changed, waypoint(changed, altitude));
        }
        return new Command.UploadMission(new Mission(items));
    }

    private static MissionItem waypoint(int number, double altitude) {
        return new MissionItem.Waypoint(
                new Geodetic(47 + number / 1000.0, 8.5), new Altitude(altitude, Altitude.Reference.HOME), 0);
    }

    private AutopilotTestBench bench(boolean arduPilot) {
        AutopilotTestBench bench =
                new AutopilotTestBench(arduPilot ? AutopilotTestBench.ARDUCOPTER : AutopilotTestBench.PX4);
        bench.wire.peer(vehicle::take);
        assertThat(bench.perform(mission(-1, 20))).isEqualTo(DONE);
        bench.wire.sent().clear();
        return bench;
    }

    @Test
    void sendsOnlyWhatDiffersToAVehicleThatTakesParts() {
        AutopilotTestBench bench = bench(true);

        assertThat(bench.perform(mission(4, 33))).isEqualTo(DONE);

        assertThat(bench.wire.sent(MissionWritePartialList.class))
                .containsExactly(new MissionWritePartialList(1, 1, 5, 5, 0));
        assertThat(bench.wire.sent(MissionItemInt.class)).hasSize(1);
        assertThat(bench.wire.sent(MissionCount.class)).isEmpty();
        assertThat(vehicle.held).hasSize(11);
        assertThat(vehicle.held.get(5).z()).isEqualTo(33f);
    }

    @Test
    void saysWhenTheVehicleSilentlyHoldsAnItemOtherwiseThanSent() {
        AutopilotTestBench bench = new AutopilotTestBench(AutopilotTestBench.PX4);
        bench.wire.peer((wire, message) -> {
            if (message instanceof MissionItemInt item && item.seq() == 4) {
                vehicle.take(wire, higher(item));
            } else {
                vehicle.take(wire, message);
            }
        });

        Outcome outcome = bench.perform(mission(-1, 20));

        assertThat(outcome).isInstanceOf(Outcome.Failed.class);
        assertThat(outcome)
                .asString()
                .contains("The vehicle holds another mission than the one sent: item 5 differs. What it had taken was"
                        + " cleared; it holds no mission now.");
        assertThat(vehicle.held).isEmpty();
        assertThat(bench.wire.sent(MissionCount.class))
                .as("it is tried once more")
                .hasSize(2);
    }

    /** ArduPilot writes in place, so that it holds a part of what it refuses in the end. */
    @Test
    void clearsWhatAVehicleTookBeforeItRefusedTheRest() {
        AutopilotTestBench bench = bench(true);
        vehicle.refusesParts = true;
        bench.wire.peer((wire, message) -> {
            if (message instanceof MissionItemInt item && item.seq() == 4) {
                vehicle.held.set(3, higher(vehicle.held.get(3)));
                wire.answer(new MissionAck(255, 190, 9, 0));
            } else {
                vehicle.take(wire, message);
            }
        });

        Outcome outcome = bench.perform(mission(3, 25));

        assertThat(outcome).isInstanceOfSatisfying(Outcome.Refused.class, refused -> {
            assertThat(refused.code()).isEqualTo(OutcomeCode.MISSION_VALUE_NOT_TAKEN);
            assertThat(refused.reason()).endsWith("What it had taken was cleared; it holds no mission now.");
        });
        assertThat(vehicle.held).isEmpty();
    }

    @Test
    void leavesAVehicleThatRefusesWithTheMissionThatItHad() {
        AutopilotTestBench bench = bench(false);
        List<MissionItemInt> before = vehicle.held;
        bench.wire.peer((wire, message) -> {
            if (message instanceof MissionItemInt item && item.seq() == 4) {
                wire.answer(new MissionAck(255, 190, 9, 0));
            } else {
                vehicle.take(wire, message);
            }
        });

        Outcome outcome = bench.perform(mission(3, 25));

        assertThat(outcome)
                .isInstanceOfSatisfying(
                        Outcome.Refused.class,
                        refused -> assertThat(refused.reason()).doesNotContain("cleared"));
        assertThat(vehicle.held).isEqualTo(before).hasSize(10);
    }

    private static MissionItemInt higher(MissionItemInt item) {
        return new MissionItemInt(
                item.targetSystem(),
                item.targetComponent(),
                item.seq(),
                item.frame(),
                item.command(),
                item.current(),
                item.autocontinue(),
                item.param1(),
                item.param2(),
                item.param3(),
                item.param4(),
                item.x(),
                item.y(),
                item.z() + 5,
                item.missionType());
    }

    @Test
    void sendsAllToAVehicleThatRefusesParts() {
        AutopilotTestBench bench = bench(true);
        vehicle.refusesParts = true;

        assertThat(bench.perform(mission(4, 33))).isEqualTo(DONE);

        assertThat(bench.wire.sent(MissionCount.class)).hasSize(1);
        assertThat(vehicle.held.get(5).z()).isEqualTo(33f);
    }

    @Test
    void sendsAllToAPx4() {
        AutopilotTestBench bench = bench(false);

        assertThat(bench.perform(mission(4, 33))).isEqualTo(DONE);

        assertThat(bench.wire.sent(MissionWritePartialList.class)).isEmpty();
        assertThat(bench.wire.sent(MissionItemInt.class)).hasSize(10);
        assertThat(vehicle.held.get(4).z()).isEqualTo(33f);
    }

    @Test
    void sendsAllWhenSomebodyElseChangedTheMissionMeanwhile() {
        AutopilotTestBench bench = bench(true);
        vehicle.held.set(9, vehicle.held.get(3));

        assertThat(bench.perform(mission(4, 33))).isEqualTo(DONE);

        assertThat(bench.wire.sent(MissionCount.class)).hasSize(1);
        assertThat(vehicle.held.get(5).z()).isEqualTo(33f);
        assertThat(vehicle.held.get(9).x()).isEqualTo(470_080_000);
    }

    /** Each with its number, so that how far a vehicle is means the same here and there. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void putsTasksOnTheVehicleAsItemsOfTheirOwn(boolean arduPilot) {
        AutopilotTestBench bench = bench(arduPilot);
        List<MissionItem> items = List.of(
                waypoint(1, 20),
                new MissionItem.LookAt(new Geodetic(47.1, 8.6), new Altitude(-12.5, Altitude.Reference.AMSL)),
                new MissionItem.SetServo(9, 1_900),
                new MissionItem.TakePhoto(),
                new MissionItem.Wait(2.5),
                new MissionItem.LookAhead(),
                waypoint(2, 20));

        assertThat(bench.perform(new Command.UploadMission(new Mission(items)))).isEqualTo(DONE);

        int before = arduPilot ? 1 : 0;
        List<MissionItemInt> wire = vehicle.held.subList(before, vehicle.held.size());
        assertThat(wire)
                .extracting(MissionItemInt::command)
                .containsExactlyElementsOf(
                        arduPilot ? List.of(16, 201, 183, 203, 93, 201, 16) : List.of(16, 195, 183, 203, 93, 197, 16));
        assertThat(wire.get(1))
                .returns(471_000_000, MissionItemInt::x)
                .returns(86_000_000, MissionItemInt::y)
                .returns(-12.5f, MissionItemInt::z)
                .returns(0, MissionItemInt::frame);
        assertThat(wire.get(2)).returns(9f, MissionItemInt::param1).returns(1_900f, MissionItemInt::param2);
        assertThat(wire.get(3)).returns(1, MissionItemInt::x);
        assertThat(wire.get(4)).returns(2.5f, MissionItemInt::param1);
        assertThat(MissionCodec.fromWire(vehicle.held, before)).isEqualTo(items);
    }

    @Test
    void noticesATaskThatTheVehicleHoldsOtherwise() {
        AutopilotTestBench bench = new AutopilotTestBench(AutopilotTestBench.PX4);
        bench.wire.peer((wire, message) -> vehicle.take(
                wire,
                message instanceof MissionItemInt item && item.seq() == 1
                        ? order(item.seq(), 183, new float[] {9, 1_100, 0, 0}, 0)
                        : message));
        List<MissionItem> items = List.of(waypoint(1, 20), new MissionItem.SetServo(9, 1_900));

        Outcome outcome = bench.perform(new Command.UploadMission(new Mission(items)));

        assertThat(outcome).asString().contains("item 2 differs");
    }

    @Test
    void takesNoOrderForAnotherOne() {
        List<MissionItemInt> foreign = List.of(
                order(0, 93, new float[] {0, 12, 30, 0}, 0),
                order(1, 183, new float[] {0, 1_900, 0, 0}, 0),
                order(2, 183, new float[] {9, 0, 0, 0}, 0),
                order(3, 203, new float[] {0, 0, 0, 0}, 0),
                order(4, 2000, new float[] {0, 2, 5, 0}, 0));
        assertThat(MissionCodec.fromWire(foreign, 0)).allMatch(MissionItem.Other.class::isInstance);
        assertThat(MissionCodec.fromWire(List.of(order(0, 2000, new float[] {0, 0, 1, 3}, 0)), 0))
                .containsExactly(new MissionItem.TakePhoto());
        AutopilotAdapter copter = AutopilotAdapter.of(AutopilotTestBench.ARDUCOPTER);
        assertThat(copter.missionItemLoss(order(0, 203, new float[] {1, 0, 0, 0}, 1)))
                .contains("has settings that the cloud would lose; leave them empty.");
        assertThat(copter.missionItemLoss(order(0, 93, new float[] {5, -1, -1, -1}, 0)))
                .isEmpty();
    }

    /** The cloud plans no such item: it is shown, with its figure, and never uploaded. */
    @Test
    void tellsTheSpeedThatAMissionChangesTo() {
        List<MissionItemInt> held =
                List.of(order(0, 178, new float[] {1, 5, -1, 0}, 0), order(1, 178, new float[] {1, -1, 50, 0}, 0));

        assertThat(MissionCodec.fromWire(held, 0))
                .containsExactly(
                        new MissionItem.Other("change speed to 5.0 m/s"), new MissionItem.Other("change speed"));
    }

    private static MissionItemInt order(int seq, int command, float[] settings, int x) {
        return new MissionItemInt(
                1, 1, seq, 2, command, 0, 1, settings[0], settings[1], settings[2], settings[3], x, 0, 0, 0);
    }

    /** 500 ± 200 ms and a tenth lost each way, some doubled: as many items as a long survey has. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8})
    void bringsALongMissionUpABadLinkAndBack(int seed) {
        List<MissionItem> items = IntStream.range(0, 200)
                .<MissionItem>mapToObj(number -> waypoint(number, 20 + number % 30))
                .toList();
        AutopilotTestBench bench =
                new AutopilotTestBench(seed % 2 == 0 ? AutopilotTestBench.ARDUCOPTER : AutopilotTestBench.PX4);
        bench.wire.peer(vehicle::take);
        bench.wire.target().way().get().measured(20_000_000L);
        bench.wire.chatter(true);
        bench.wire.lossy(0.1, new Random(seed));
        bench.wire.slow(0.3, 0.7, 0.02);

        assertThat(bench.perform(new Command.UploadMission(new Mission(items)), 3_000))
                .isEqualTo(DONE);
        assertThat(MissionCodec.fromWire(vehicle.held, seed % 2 == 0 ? 1 : 0)).isEqualTo(items);
    }

    /** Where a float has no digit left, that is told and not taken for another mission. */
    @Test
    void bringsAMissionToAVehicleThatKnowsFloatsAloneAndSaysHowExact() {
        FloatMissionVehicle old = new FloatMissionVehicle();
        AutopilotTestBench bench = new AutopilotTestBench(AutopilotTestBench.ARDUCOPTER);
        bench.wire.peer(old::take);
        bench.wire.chatter(true);

        assertThat(bench.perform(mission(-1, 20))).isEqualTo(DONE);

        assertThat(old.held).hasSize(11);
        assertThat(bench.warnings)
                .containsExactly(
                        "This vehicle takes positions of missions in an old form only, exact to a metre or so.");
    }

    @Test
    void bringsRallyPointsToAVehicleThatKnowsFloatsAlone() {
        FloatMissionVehicle old = new FloatMissionVehicle();
        AutopilotTestBench bench = new AutopilotTestBench(AutopilotTestBench.ARDUCOPTER);
        bench.wire.peer(old::take);
        bench.wire.chatter(true);

        assertThat(bench.perform(new SetRallyPoints(List.of(new RallyPoint(new Geodetic(47.1234567, 8.7654321), 30)))))
                .isEqualTo(DONE);
        assertThat(old.held).hasSize(1);
    }

    @Test
    void tellsOfItsProgressAlsoWhileItReadsBack() {
        AutopilotTestBench bench = bench(true);

        assertThat(bench.progress)
                .startsWith("0/22")
                .contains("11/22", "12/22", "21/22")
                .endsWith("22/22");
    }
}
