package org.dronemap.proxy.mavlink.procedure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionItem;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionRequest;
import org.dronemap.mavlink.message.MissionRequestInt;
import org.dronemap.mavlink.message.MissionRequestList;
import org.dronemap.mavlink.message.MissionWritePartialList;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class MissionTransferTest {
    private static final int ITEMS = 6;
    private static final Outcome DONE = new Outcome.Succeeded();

    private final TestWire wire = new TestWire();
    private final Map<Integer, MissionItemInt> held = new TreeMap<>();
    private int expected;
    private int passed;
    private long endOfCut;
    private IntPredicate lost = number -> false;

    private static List<MissionItemInt> items() {
        return IntStream.range(0, ITEMS)
                .mapToObj(seq -> new MissionItemInt(1, 1, seq, 3, 16, 0, 1, 0f, 0f, 0f, 0f, 10 + seq, 20, 30f, 0))
                .toList();
    }

    /** Every message in either direction has a number; some are lost. */
    private boolean passes() {
        return !lost.test(passed++);
    }

    private void say(Message message) {
        if (passes()) {
            wire.answer(message);
        }
    }

    /** A vehicle that takes and gives missions in order, as autopilots do. */
    private void vehicle(TestWire w, Message message) {
        if (!passes()) {
            return;
        }
        if (message instanceof MissionCount count) {
            expected = count.count();
            held.clear();
            say(new MissionRequestInt(255, 190, 0, 0));
        } else if (message instanceof MissionItemInt item) {
            if (item.seq() == held.size() && held.size() < expected) {
                held.put(item.seq(), item);
            }
            say(
                    held.size() == expected
                            ? new MissionAck(255, 190, 0, 0)
                            : new MissionRequestInt(255, 190, held.size(), 0));
        } else if (message instanceof MissionRequestList) {
            say(new MissionCount(255, 190, held.size(), 0));
        } else if (message instanceof MissionRequestInt request) {
            say(held.get(request.seq()));
        }
    }

    static IntStream everyMessage() {
        return IntStream.range(0, 2 * ITEMS + 4);
    }

    @ParameterizedTest
    @MethodSource("everyMessage")
    void uploadsThoughOneMessageIsLost(int number) {
        lost = n -> n == number;
        wire.peer(this::vehicle);
        assertThat(wire.runWhole(
                        new MissionUpload(wire.target(), MavMissionType.MISSION, items(), ExchangeObserver.NONE)))
                .isEqualTo(DONE);
        assertThat(held.values()).containsExactlyElementsOf(items());
    }

    @ParameterizedTest
    @MethodSource("everyMessage")
    void downloadsThoughOneMessageIsLost(int number) {
        items().forEach(item -> held.put(item.seq(), item));
        lost = n -> n == number;
        wire.peer(this::vehicle);
        MissionDownload download = MissionDownload.whole(wire.target(), MavMissionType.MISSION);
        assertThat(wire.runWhole(download)).isEqualTo(DONE);
        assertThat(download.items()).containsExactlyElementsOf(items());
    }

    @Test
    void uploadsThoughEveryThirdMessageIsLost() {
        lost = n -> n % 3 == 1;
        wire.peer(this::vehicle);
        assertThat(wire.runWhole(
                        new MissionUpload(wire.target(), MavMissionType.MISSION, items(), ExchangeObserver.NONE)))
                .isEqualTo(DONE);
        assertThat(held.values()).containsExactlyElementsOf(items());
    }

    @Test
    void takesEveryAnswerTwiceWithoutHarm() {
        wire.peer((w, message) -> {
            vehicle(w, message);
            if (message instanceof MissionItemInt) {
                w.answer(new MissionRequestInt(255, 190, Math.min(held.size(), ITEMS - 1), 0));
            }
        });
        assertThat(wire.runWhole(
                        new MissionUpload(wire.target(), MavMissionType.MISSION, items(), ExchangeObserver.NONE)))
                .isEqualTo(DONE);
        assertThat(held.values()).containsExactlyElementsOf(items());
    }

    @Test
    void saysThatAVehicleNeverAnswered() {
        wire.chatter(true);
        assertThat(wire.runWhole(
                        new MissionUpload(wire.target(), MavMissionType.MISSION, items(), ExchangeObserver.NONE)))
                .isInstanceOf(Outcome.TimedOut.class);
        assertThat(wire.sent()).hasSize(9);
    }

    @Test
    void saysWhyAVehicleRefusesAMission() {
        wire.peer((w, message) -> w.answer(new MissionAck(255, 190, 4, 0)));

        assertThat(wire.runWhole(
                        new MissionUpload(wire.target(), MavMissionType.MISSION, items(), ExchangeObserver.NONE)))
                .isEqualTo(new Outcome.Refused(
                        "vehicle", "The vehicle has no room for so many mission items.", OutcomeCode.MISSION_TOO_LONG));
    }

    @Test
    void beginsAgainWhenTheVehicleCancels() {
        List<Message> counts = new ArrayList<>();
        wire.peer((w, message) -> {
            if (message instanceof MissionCount) {
                counts.add(message);
            }
            if (counts.size() == 1) {
                w.answer(new MissionAck(255, 190, 15, 0));
            } else {
                vehicle(w, message);
            }
        });

        assertThat(wire.runWhole(
                        new MissionUpload(wire.target(), MavMissionType.MISSION, items(), ExchangeObserver.NONE)))
                .isEqualTo(DONE);
        assertThat(held).hasSize(ITEMS);
    }

    @Test
    void beginsAgainWhenTheVehicleHasForgottenTheTransfer() {
        List<Message> counts = new ArrayList<>();
        wire.chatter(true);
        wire.peer((w, message) -> {
            if (message instanceof MissionCount) {
                counts.add(message);
            }
            boolean forgotten = counts.size() == 1 && held.size() >= 3;
            if (!forgotten) {
                vehicle(w, message);
            }
        });

        assertThat(wire.runWhole(
                        new MissionUpload(wire.target(), MavMissionType.MISSION, items(), ExchangeObserver.NONE)))
                .isEqualTo(DONE);
        assertThat(counts).hasSize(2);
        assertThat(held.values()).containsExactlyElementsOf(items());
    }

    @Test
    void sendsNothingAnewWhenOnlyTheLastWordIsLost() {
        wire.chatter(true);
        wire.peer((w, message) -> {
            // The vehicle has all items and is done with the transfer; its acknowledgement was lost.
            boolean last = message instanceof MissionItemInt item && item.seq() == ITEMS - 1;
            if (!last) {
                vehicle(w, message);
            }
        });

        assertThat(wire.runWhole(
                        new MissionUpload(wire.target(), MavMissionType.MISSION, items(), ExchangeObserver.NONE)))
                .isEqualTo(DONE);
        assertThat(wire.sent(MissionCount.class)).hasSize(1);
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void readsAllAnewWhenTheMissionChangesWhileItIsRead(boolean inAnyOrder) {
        List<MissionItemInt> newer = items().stream()
                .map(old -> new MissionItemInt(1, 1, old.seq(), 3, 16, 0, 1, 0f, 0f, 0f, 0f, old.x(), 20, 77f, 0))
                .toList();
        items().forEach(item -> held.put(item.seq(), item));
        AtomicBoolean changed = new AtomicBoolean();
        wire.peer((w, message) -> {
            if (message instanceof MissionRequestInt request && request.seq() == 3 && !changed.getAndSet(true)) {
                newer.forEach(item -> held.put(item.seq(), item));
                w.answer(new MissionAck(255, 190, 1, 0));
            } else {
                vehicle(w, message);
            }
        });
        MissionDownload download = MissionDownload.whole(wire.target(), MavMissionType.MISSION);
        if (inAnyOrder) {
            wire.target().roundTrip().measured(400_000_000L);
            download.inAnyOrder();
        }

        assertThat(wire.runWhole(download)).isEqualTo(DONE);
        assertThat(download.items()).containsExactlyElementsOf(newer);
    }

    @Test
    void overlooksThatItemsOfAnEarlierRoundCameLate() {
        wire.peer((w, message) -> {
            if (message instanceof MissionCount) {
                for (int late = 0; late < ITEMS; late++) {
                    w.answer(new MissionAck(255, 190, 13, 0));
                }
            }
            vehicle(w, message);
        });

        assertThat(wire.runWhole(
                        new MissionUpload(wire.target(), MavMissionType.MISSION, items(), ExchangeObserver.NONE)))
                .isEqualTo(DONE);
        assertThat(held.values()).containsExactlyElementsOf(items());
    }

    @Test
    void ignoresFencesAndRallyPoints() {
        wire.peer((w, message) -> {
            w.answer(new MissionCount(255, 190, 3, 1));
            vehicle(w, message);
        });
        MissionDownload download = MissionDownload.whole(wire.target(), MavMissionType.MISSION);

        assertThat(wire.runWhole(download)).isEqualTo(DONE);
        assertThat(download.items()).isEmpty();
    }

    @ParameterizedTest
    @MethodSource("everyMessage")
    void goesOnAfterTheLinkWasCutAtAnyMessage(int number) {
        MissionVehicle vehicle = new MissionVehicle();
        wire.peer((w, message) -> {
            vehicle.take(w, message);
            w.cut(w.crossed() >= number && w.now() < endOfCut);
        });
        endOfCut = wire.now() + 30_000_000_000L;
        MissionUpload upload = new MissionUpload(wire.target(), MavMissionType.MISSION, items(), ExchangeObserver.NONE);
        MissionDownload readBack = MissionDownload.whole(wire.target(), MavMissionType.MISSION);
        ExchangeSequence both = new ExchangeSequence(
                List.of(ExchangeSequence.Step.of(() -> upload), ExchangeSequence.Step.of(() -> readBack)));
        both.start(wire.now());
        for (int second = 0; second < 100 && both.outcome() == null; second++) {
            wire.run(both, 1);
            wire.cut(wire.crossed() >= number && wire.now() < endOfCut);
        }

        assertThat(both.outcome()).isEqualTo(DONE);
        assertThat(vehicle.held).containsExactlyElementsOf(items());
        assertThat(readBack.items()).containsExactlyElementsOf(items());
    }

    @Test
    void sendsOnlyThePartThatItIsToldTo() {
        MissionVehicle vehicle = new MissionVehicle();
        vehicle.held = new ArrayList<>(items());
        wire.peer(vehicle::take);

        assertThat(wire.runWhole(MissionUpload.part(
                        wire.target(),
                        MavMissionType.MISSION,
                        items(),
                        new MissionUpload.Span(2, 3),
                        ExchangeObserver.NONE)))
                .isEqualTo(DONE);
        assertThat(wire.sent(MissionWritePartialList.class))
                .containsExactly(new MissionWritePartialList(1, 1, 2, 3, 0));
        assertThat(wire.sent(MissionItemInt.class)).containsExactly(items().get(2), items().get(3));
        assertThat(wire.sent(MissionCount.class)).isEmpty();
    }

    @Test
    void readsAPartAndHowManyThereAre() {
        MissionVehicle vehicle = new MissionVehicle();
        vehicle.held = new ArrayList<>(items());
        wire.peer(vehicle::take);
        MissionDownload middle = MissionDownload.part(wire.target(), MavMissionType.MISSION, 3, 2);
        MissionDownload end = MissionDownload.part(wire.target(), MavMissionType.MISSION, 5, 20);

        assertThat(wire.runWhole(middle)).isEqualTo(DONE);
        assertThat(wire.runWhole(end)).isEqualTo(DONE);
        assertThat(middle.items()).containsExactly(items().get(3), items().get(4));
        assertThat(middle.count()).isEqualTo(ITEMS);
        assertThat(end.items()).containsExactly(items().get(5));
    }

    @Test
    void asksForFloatingPointItemsOnlyWhoNeverGivesIntegers() {
        items().forEach(item -> held.put(item.seq(), item));
        AtomicInteger lostAnswers = new AtomicInteger();
        wire.chatter(true);
        wire.peer((w, message) -> {
            // The answer about the fourth item is lost seven times.
            if (message instanceof MissionRequestInt request
                    && request.seq() == 3
                    && lostAnswers.incrementAndGet() < 8) {
                return;
            }
            vehicle(w, message);
        });
        MissionDownload download = MissionDownload.whole(wire.target(), MavMissionType.MISSION);

        assertThat(wire.runWhole(download)).isEqualTo(DONE);
        assertThat(download.isExact()).isTrue();
        assertThat(wire.sent(MissionRequest.class)).isEmpty();
    }

    @Test
    void readsFromOldVehiclesThatKnowFloatingPointItemsOnly() {
        wire.peer((w, message) -> {
            if (message instanceof MissionRequestList) {
                w.answer(new MissionCount(255, 190, 1, 0));
            } else if (message instanceof MissionRequest) {
                w.answer(new MissionItem(255, 190, 0, 3, 16, 0, 1, 0f, 0f, 0f, 0f, 47.5f, 8.25f, 30f, 0));
            }
        });
        MissionDownload download = MissionDownload.whole(wire.target(), MavMissionType.MISSION);

        assertThat(wire.runWhole(download)).isEqualTo(DONE);
        assertThat(download.isExact()).isFalse();
        assertThat(download.items()).extracting(MissionItemInt::x).containsExactly(475_000_000);
    }

    @Test
    void overlooksAQuestionThatALaterOneHasOvertaken() {
        wire.peer((w, message) -> {
            if (message instanceof MissionItemInt item && item.seq() == ITEMS - 1) {
                w.answer(new MissionRequestInt(255, 190, ITEMS - 2, 0));
            }
            vehicle(w, message);
        });

        assertThat(wire.runWhole(
                        new MissionUpload(wire.target(), MavMissionType.MISSION, items(), ExchangeObserver.NONE)))
                .isEqualTo(DONE);
        assertThat(wire.sent(MissionItemInt.class)).hasSize(ITEMS);
    }

    @Test
    void overlooksWhatIsSaidOfItemsThatCameTwiceWhenItBeginsToReadBack() {
        items().forEach(item -> held.put(item.seq(), item));
        wire.peer(this::vehicle);
        wire.answer(new MissionAck(255, 190, 13, 0));
        wire.answer(new MissionAck(255, 190, 1, 0));
        MissionDownload download = MissionDownload.whole(wire.target(), MavMissionType.MISSION);

        assertThat(wire.runWhole(download)).isEqualTo(DONE);
        assertThat(download.items()).hasSize(ITEMS);
    }

    @Test
    void waitsAsLongAsTheLinkHasComeToNeed() {
        wire.target().roundTrip().measured(10_000_000L);
        wire.chatter(true);
        MissionUpload upload = new MissionUpload(wire.target(), MavMissionType.MISSION, items(), ExchangeObserver.NONE);
        upload.start(wire.now());
        for (int measure = 0; measure < 20; measure++) {
            wire.target().roundTrip().measured(2_500_000_000L);
        }
        wire.run(upload, 9);

        assertThat(upload.outcome()).isNull();
        assertThat(wire.sent()).hasSizeLessThan(5);
    }
}
