package org.dronemap.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dronemap.mavlink.message.CameraFeedback;
import org.dronemap.mavlink.message.CameraImageCaptured;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.HomePosition;
import org.dronemap.mavlink.message.MissionCurrent;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionWritePartialList;
import org.dronemap.sim.control.ControlCommands;
import org.junit.jupiter.api.Test;

class PayloadTest {
    private static final int UNSUPPORTED = 3;
    private static final int FAILED = 4;

    private static double yaw(Bench bench) {
        return (Math.toDegrees(bench.vehicle.craft().body().yaw()) + 360) % 360;
    }

    private static String payload(Bench bench) {
        return ControlCommands.run("payload", List.of(bench.vehicle));
    }

    @Test
    void turnsTheLongWayRoundAtTheRateAskedFor() {
        Bench bench = Bench.flying(20);
        double before = yaw(bench);
        assertThat(bench.command(115, 270, 30, 1, 1)).isZero();
        bench.run(3);
        assertThat(yaw(bench) - before).isBetween(80.0, 100.0);
        bench.run(3);
        assertThat(yaw(bench) - before).isBetween(170.0, 190.0);
        bench.run(4);
        assertThat(yaw(bench) - before).isBetween(269.0, 271.0);
    }

    @Test
    void turnsLeftWhenToldTo() {
        Bench bench = Bench.flying(20);
        double before = yaw(bench);
        assertThat(bench.command(115, 90, 0, -1, 1)).isZero();
        bench.run(3);
        assertThat((before - yaw(bench) + 360) % 360).isBetween(89.0, 91.0);
        assertThat(bench.height()).isBetween(19.0, 21.0);
    }

    @Test
    void arduCopterCountsEveryPictureAndTellsOfIt() {
        Bench bench = Bench.flying(20);
        assertThat(bench.command(2000, 0, 0, 1, 5)).isZero();
        assertThat(bench.command(203, 0, 0, 0, 0, 1)).isZero();
        assertThat(bench.count(CameraFeedback.ID)).isEqualTo(2);
        CameraFeedback last =
                CameraFeedback.decode(bench.heard.get(bench.heard.size() - 2).frame());
        assertThat(last.imgIdx()).isEqualTo(2);
        assertThat(last.altRel()).isBetween(19f, 21f);
        assertThat(payload(bench)).contains("pictures 2");
    }

    @Test
    void px4TakesPicturesByItsOlderOrderOnly() {
        Bench bench = Bench.ready("--personality", "px4");
        assertThat(bench.command(2000, 0, 0, 1, 5)).isEqualTo(UNSUPPORTED);
        assertThat(bench.command(203, 0, 0, 0, 0, 1)).isZero();
        assertThat(bench.count(CameraImageCaptured.ID)).isOne();
        assertThat(bench.command(181, 0, 1)).isEqualTo(UNSUPPORTED);
        assertThat(payload(bench)).contains("pictures 1");
    }

    @Test
    void switchesItsSixRelays() {
        Bench bench = Bench.ready();
        assertThat(bench.command(181, 2, 1)).isZero();
        assertThat(bench.command(181, 3, 2)).isZero();
        assertThat(bench.command(181, 4, 2)).isZero();
        assertThat(bench.command(181, 4, 2)).isZero();
        assertThat(bench.command(181, 6, 1)).isEqualTo(FAILED);
        assertThat(payload(bench)).contains("relays on: 2 3\n");
        assertThat(bench.command(181, 2, 0)).isZero();
        assertThat(payload(bench)).contains("relays on: 3\n");
    }

    @Test
    void takesAHomeInTheFrameThatIsNamed() {
        Bench bench = Bench.ready();
        double before = bench.vehicle.craft().home().altitudeAmsl();
        bench.send(new CommandInt(1, 1, 3, 179, 0, 0, 0, 0, 0, 0, 473_000_000, 85_000_000, 10));
        assertThat(bench.vehicle.craft().home().altitudeAmsl()).isEqualTo(before + 10);
        bench.send(new CommandInt(1, 1, 0, 179, 0, 0, 0, 0, 0, 0, 473_000_000, 85_000_000, 510));
        assertThat(bench.vehicle.craft().home().altitudeAmsl()).isEqualTo(510);
        assertThat(bench.count(HomePosition.ID)).isEqualTo(2);
    }

    @Test
    void px4TakesAHomeAboveTheSea() {
        Bench bench = Bench.ready("--personality", "px4");
        bench.send(new CommandInt(1, 1, 0, 179, 0, 0, 0, 0, 0, Float.NaN, 473_000_000, 85_000_000, 510));
        assertThat(bench.vehicle.craft().home().altitudeAmsl()).isEqualTo(510);
        assertThat(bench.vehicle.craft().home().latitude()).isEqualTo(47.3);
    }

    @Test
    void arduCopterTakesAPartOfAMissionInPlace() {
        Bench bench = Bench.ready();
        bench.upload(bench.item(0, 16, 0, 0, 0), bench.item(1, 22, 0, 0, 20), bench.item(2, 16, 40, 0, 20));
        bench.send(new MissionWritePartialList(1, 1, 2, 2, 0));
        bench.send(bench.item(2, 16, 80, 0, 35));
        assertThat(bench.vehicle.autopilot().plan().size()).isEqualTo(3);
        assertThat(bench.vehicle.autopilot().plan().item(1).command()).isEqualTo(22);
        assertThat(bench.vehicle.autopilot().plan().item(2).z()).isEqualTo(35f);
        bench.send(new MissionWritePartialList(1, 1, 2, 5, 0));
        assertThat(bench.texts()).contains("Flight plan received", "Flight plan update rejected");
    }

    @Test
    void px4GivesEveryMissionANumberOfItsOwn() {
        Bench bench = Bench.ready("--personality", "px4");
        MissionItemInt[] items = {bench.item(0, 22, 0, 0, 20), bench.item(1, 16, 40, 0, 20)};
        bench.upload(items);
        bench.run(2);
        long first = stamp(bench);
        bench.run(2);
        assertThat(stamp(bench)).isEqualTo(first).isNotZero();
        bench.upload(items);
        bench.run(2);
        assertThat(stamp(bench)).isNotEqualTo(first).isNotZero();
    }

    private static long stamp(Bench bench) {
        return bench.heard.stream()
                .filter(h -> h.frame().messageId() == MissionCurrent.ID)
                .reduce((one, later) -> later)
                .orElseThrow()
                .frame()
                .u32(6);
    }
}
