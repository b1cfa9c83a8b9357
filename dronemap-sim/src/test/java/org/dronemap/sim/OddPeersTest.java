package org.dronemap.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.BatteryStatus;
import org.dronemap.mavlink.message.EkfStatusReport;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.Statustext;
import org.dronemap.mavlink.message.SysStatus;
import org.dronemap.sim.control.SimulatorControlCommands;
import org.junit.jupiter.api.Test;

/** What real links have beside one plain vehicle: others with heartbeats, long texts, batteries, another system id. */
class OddPeersTest {
    private static final String LONG =
            "Compass 1 and compass 2 disagree by more than sixty degrees, calibrate them again";

    private static String order(VehicleTestBench bench, String line) {
        return SimulatorControlCommands.run(line, List.of(bench.vehicle));
    }

    private static Stream<VehicleTestBench.Heard> heard(VehicleTestBench bench, int messageId) {
        return bench.heard.stream().filter(heard -> heard.frame().messageId() == messageId);
    }

    @Test
    void othersOnItsLinkSendHeartbeatsOfTheirOwn() {
        VehicleTestBench bench = VehicleTestBench.ready("--companions", "gimbal,camera,computer,adsb,station");
        bench.run(2);
        assertThat(heard(bench, Heartbeat.ID)
                        .map(heard -> heard.frame().systemId() + "/"
                                + heard.frame().componentId() + " "
                                + Heartbeat.decode(heard.frame()).type()))
                .contains("1/1 2", "1/154 26", "1/100 30", "1/191 18", "1/156 27", "255/190 6");
        assertThat(order(bench, "companions all none")).startsWith("ok");
        bench.heard.clear();
        bench.run(2);
        assertThat(heard(bench, Heartbeat.ID)).allMatch(heard -> heard.frame().componentId() == 1);
        assertThat(order(bench, "companions all toaster")).startsWith("err no companion is called 'toaster'");
        assertThatThrownBy(() -> VehicleTestBench.ready("--companions", "toaster"))
                .hasMessageContaining("there are gimbal, camera, computer, adsb, station");
    }

    @Test
    void longTextsComeInPiecesWhoseNumbersBeginAnewAfterAReboot() {
        VehicleTestBench bench = VehicleTestBench.ready("--companions", "computer");
        assertThat(order(bench, "text 1 vehicle " + LONG)).startsWith("ok");
        assertThat(order(bench, "text 1 computer " + LONG)).startsWith("ok");
        assertThat(heard(bench, Statustext.ID)
                        .map(heard -> heard.frame().componentId() + " "
                                + Statustext.decode(heard.frame()).id() + " "
                                + Statustext.decode(heard.frame()).chunkSeq()))
                .containsExactly("1 1 0", "1 1 1", "191 1 0", "191 1 1");
        assertThat(String.join("", bench.texts())).isEqualTo(LONG + LONG);
        assertThat(order(bench, "text 1 vehicle " + LONG)).startsWith("ok");
        assertThat(bench.last(Statustext.ID, Statustext::decode).id()).isEqualTo(2);
        bench.vehicle.reboot();
        bench.run(3);
        order(bench, "text 1 vehicle " + LONG);
        assertThat(bench.last(Statustext.ID, Statustext::decode).id()).isOne();
    }

    /** Only a zero says that nothing follows. */
    @Test
    void aTextThatFillsItsLastPieceEndsWithAnEmptyOne() {
        VehicleTestBench bench = VehicleTestBench.ready();
        assertThat(order(bench, "text 1 vehicle " + "x".repeat(100))).startsWith("ok");
        assertThat(heard(bench, Statustext.ID)
                        .map(heard -> Statustext.decode(heard.frame()).text()))
                .containsExactly("x".repeat(50), "x".repeat(50), "");
        assertThat(order(bench, "text 1 vehicle " + "y".repeat(50))).startsWith("ok");
        assertThat(bench.last(Statustext.ID, Statustext::decode).id()).isZero();
    }

    @Test
    void aSystemIdThatIsWrittenCountsFromTheNextStart() {
        VehicleTestBench bench = VehicleTestBench.ready();
        bench.parameter("SYSID_THISMAV", 42);
        bench.run(2);
        assertThat(system(bench)).isEqualTo(1);
        bench.vehicle.reboot();
        bench.run(3);
        assertThat(system(bench)).isEqualTo(42);
    }

    private static int system(VehicleTestBench bench) {
        return bench.last(Heartbeat.ID, Frame::systemId);
    }

    @Test
    void tellsOfTwoBatteriesInTurn() {
        VehicleTestBench bench = VehicleTestBench.ready("--parameter", "BATT2_MONITOR=4");
        bench.command(511, BatteryStatus.ID, 1_000_000);
        bench.run(6);
        List<Integer> ids = heard(bench, BatteryStatus.ID)
                .map(heard -> BatteryStatus.decode(heard.frame()).id())
                .toList();
        assertThat(ids).hasSizeGreaterThan(4).startsWith(1, 0, 1, 0);
    }

    private static List<Integer> cells(int[] told) {
        return Arrays.stream(told).boxed().toList();
    }

    @Test
    void tellsFourteenCellsAndThenThatItKnowsNothing() {
        VehicleTestBench bench = VehicleTestBench.ready("--cells", "14");
        bench.command(512, BatteryStatus.ID);
        BatteryStatus known = bench.last(BatteryStatus.ID, BatteryStatus::decode);
        assertThat(cells(known.voltages())).allMatch(cell -> cell > 800 && cell < 1_000);
        assertThat(cells(known.voltagesExt())).allMatch(cell -> cell > 800 && cell < 1_000);
        assertThat(order(bench, "fault all battery-unknown on")).startsWith("ok");
        bench.command(512, BatteryStatus.ID);
        BatteryStatus unknown = bench.last(BatteryStatus.ID, BatteryStatus::decode);
        assertThat(cells(unknown.voltages())).allMatch(cell -> cell == 0xFFFF);
        assertThat(cells(unknown.voltagesExt())).allMatch(cell -> cell == 0);
        assertThat(unknown.batteryRemaining()).isEqualTo(-1);
        bench.command(512, SysStatus.ID);
        assertThat(bench.last(SysStatus.ID, SysStatus::decode).voltageBattery()).isEqualTo(0xFFFF);
    }

    @Test
    void losesItsGpsForSoLongAsItIsTold() {
        VehicleTestBench bench = VehicleTestBench.flying(20);
        assertThat(order(bench, "fault all gps 4s")).startsWith("ok");
        bench.run(3.5);
        assertThat(bench.vehicle.craft().navigation().hasFix()).isFalse();
        bench.run(2);
        assertThat(bench.vehicle.craft().navigation().hasFix()).isTrue();
        bench.command(512, EkfStatusReport.ID);
        assertThat(bench.last(EkfStatusReport.ID, EkfStatusReport::decode).flags())
                .isEqualTo(831);
        assertThat(order(bench, "fault all gps soon")).startsWith("err gps wants on or off");
    }
}
