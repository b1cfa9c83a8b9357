package org.dronemap.proxy.mavlink.procedure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.IntStream;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionItemInt;
import org.junit.jupiter.api.Test;

/** The link breaks at the end of an upload, and the vehicle still hopes for the rest. */
class InterruptedUploadTest {
    private static final int ITEMS = 8;
    private static final Outcome DONE = new Outcome.Succeeded();

    private final TestWire wire = new TestWire();
    private final MissionVehicle vehicle = new MissionVehicle();

    private static List<MissionItemInt> items() {
        return IntStream.range(0, ITEMS)
                .mapToObj(seq -> new MissionItemInt(1, 1, seq, 3, 16, 0, 1, 0f, 0f, 0f, 0f, 10 + seq, 20, 30f, 0))
                .toList();
    }

    @Test
    void sendsTheLastItemAgainBeforeItCallsTheMissionTaken() {
        AtomicLong endOfBreak = new AtomicLong();
        wire.peer((w, message) -> {
            if (message instanceof MissionItemInt item && item.seq() == ITEMS - 1) {
                endOfBreak.compareAndSet(0, w.now() + 4_000_000_000L);
            }
            if (w.now() >= endOfBreak.get()) {
                vehicle.take(w, message);
            }
        });
        MissionUpload upload = new MissionUpload(wire.target(), MavMissionType.MISSION, items(), ExchangeObserver.NONE);
        upload.start(wire.now());
        assertThat(wire.run(upload, 4)).isNull();
        wire.chatter(true);

        assertThat(wire.run(upload, 60)).isEqualTo(DONE);
        assertThat(vehicle.held).containsExactlyElementsOf(items());
    }

    @Test
    void waitsWithReadingUntilTheVehicleHasGivenTheUploadUp() {
        vehicle.held = new ArrayList<>(items());
        long givenUp = wire.now() + 6_000_000_000L;
        wire.peer((w, message) -> {
            if (w.now() < givenUp) {
                w.answer(new MissionAck(255, 190, MavMissionResult.DENIED, 0));
            } else {
                vehicle.take(w, message);
            }
        });

        assertThat(wire.runWhole(MissionDownload.whole(wire.target(), MavMissionType.MISSION)))
                .isEqualTo(DONE);
    }

    @Test
    void takesARefusalThatLastsForOne() {
        wire.peer((w, message) -> w.answer(new MissionAck(255, 190, MavMissionResult.DENIED, 0)));

        assertThat(wire.runWhole(MissionDownload.whole(wire.target(), MavMissionType.MISSION)))
                .isEqualTo(new Outcome.Refused(
                        "vehicle", "The vehicle takes and gives no mission now.", OutcomeCode.VEHICLE_DENIED));
    }
}
