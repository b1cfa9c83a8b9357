package org.dronemap.proxy.mavlink.procedure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.dronemap.core.command.Outcome;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionItem;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionRequest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** In which form a vehicle is given the items of its mission, by how it asks and what it takes. */
class MissionItemFormTest {
    private static final int ITEMS = 6;
    private static final Outcome DONE = new Outcome.Succeeded();

    private final TestWire wire = new TestWire();
    private final Map<Integer, MissionItemInt> held = new TreeMap<>();
    private int expected;

    private static List<MissionItemInt> items() {
        return IntStream.range(0, ITEMS)
                .mapToObj(seq -> new MissionItemInt(1, 1, seq, 3, 16, 0, 1, 0f, 0f, 0f, 0f, 10 + seq, 20, 30f, 0))
                .toList();
    }

    /** Every message in either direction has a number; some are lost. */
    /** As Copter up to 3.3: it asks in the old form and does not know integer items at all. */
    private void oldVehicle(TestWire w, Message message, int kind) {
        if (message instanceof MissionCount count) {
            expected = count.count();
            held.clear();
            wire.answer(new MissionRequest(255, 190, 0, kind));
        } else if (message instanceof MissionItem item) {
            if (item.seq() == held.size()) {
                held.put(item.seq(), LegacyMissionItems.exact(item));
            }
            wire.answer(
                    held.size() == expected
                            ? new MissionAck(255, 190, 0, kind)
                            : new MissionRequest(255, 190, held.size(), kind));
        }
    }

    @ParameterizedTest
    @EnumSource(MavMissionType.class)
    void givesFloatsToAVehicleThatKnowsNothingElse(MavMissionType kind) {
        wire.chatter(true);
        wire.peer((w, message) -> oldVehicle(w, message, kind.number()));
        List<MissionItemInt> items = IntStream.range(0, ITEMS)
                .mapToObj(seq -> new MissionItemInt(
                        1,
                        1,
                        seq,
                        3,
                        16,
                        0,
                        1,
                        0f,
                        0f,
                        0f,
                        0f,
                        470_000_000 + seq * 10_000,
                        85_000_000,
                        30f,
                        kind.number()))
                .toList();

        Outcome outcome = wire.runWhole(new MissionUpload(wire.target(), kind, items, ExchangeObserver.NONE));

        assertThat(outcome).isEqualTo(DONE);
        assertThat(held.values()).extracting(MissionItemInt::seq).containsExactly(0, 1, 2, 3, 4, 5);
        assertThat(held.values())
                .allSatisfy(item -> assertThat(Math.abs(item.x() - 470_000_000 - item.seq() * 10_000))
                        .isLessThan(40));
        assertThat(wire.sent(MissionItemInt.class))
                .as("what it does not know is not sent on and on")
                .hasSizeLessThan(5);
    }

    @Test
    void saysWhenAVehicleAsksForItemsAndTakesThemInNoForm() {
        wire.chatter(true);
        wire.peer((w, message) -> {
            if (message instanceof MissionCount) {
                w.answer(new MissionRequest(255, 190, 0, 0));
            }
        });

        Outcome outcome =
                wire.runWhole(new MissionUpload(wire.target(), MavMissionType.MISSION, items(), ExchangeObserver.NONE));

        assertThat(outcome)
                .isInstanceOfSatisfying(
                        Outcome.Failed.class,
                        failed -> assertThat(failed.reason())
                                .contains("neither as MISSION_ITEM_INT nor as MISSION_ITEM"));
    }

    /** ArduPilot up to 4.0 asks in the old form and takes integers: they are exact, and stay the first choice. */
    @Test
    void givesIntegersToAVehicleThatAsksInTheOldFormAndTakesThem() {
        wire.chatter(true);
        wire.peer((w, message) -> {
            if (message instanceof MissionCount count) {
                expected = count.count();
                wire.answer(new MissionRequest(255, 190, 0, 0));
            } else if (message instanceof MissionItemInt item) {
                held.putIfAbsent(item.seq(), item);
                wire.answer(
                        held.size() == expected
                                ? new MissionAck(255, 190, 0, 0)
                                : new MissionRequest(255, 190, held.size(), 0));
            }
        });

        assertThat(wire.runWhole(
                        new MissionUpload(wire.target(), MavMissionType.MISSION, items(), ExchangeObserver.NONE)))
                .isEqualTo(DONE);
        assertThat(wire.sent(MissionItem.class)).isEmpty();
        assertThat(held.values()).containsExactlyElementsOf(items());
    }
}
