package org.dronemap.proxy.mavlink.procedure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Random;
import java.util.function.IntPredicate;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.VehicleLogSink;
import org.dronemap.core.drone.VehicleLog;
import org.dronemap.mavlink.message.LogEntry;
import org.dronemap.mavlink.message.LogRequestData;
import org.dronemap.mavlink.message.LogRequestEnd;
import org.dronemap.mavlink.message.LogRequestList;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class LogTransferTest {
    private static final Outcome DONE = new Outcome.Succeeded();
    private static final int BYTES = 100_000;

    private final TestWire wire = new TestWire();
    private final LogVehicle vehicle = new LogVehicle(BYTES, 5);
    private final LogVehicle.Memory memory = new LogVehicle.Memory();

    private LogDownload download() {
        wire.peer(vehicle::take);
        return new LogDownload(wire.target(), new VehicleLog(3, null, BYTES), memory, ExchangeObserver.NONE);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 4, 5, 17})
    void listsWhateverTheVehicleCountsFromThoughHalfIsLost(int last) {
        LogVehicle counting = new LogVehicle(BYTES, last == 0 ? 1 : 5);
        counting.last = last;
        wire.lossy(0.5, new Random(4));
        wire.peer(counting::take);
        LogListDownload listing = new LogListDownload(wire.target(), ExchangeObserver.NONE);

        assertThat(wire.runWhole(listing)).isEqualTo(DONE);
        assertThat(listing.logs()).hasSize(counting.count);
        assertThat(listing.logs().get(counting.count - 1).number()).isEqualTo(last);
        assertThat(counting.dead).isFalse();
    }

    /** {@code counted}: how many the vehicle says that it has. */
    private LogListDownload listOf(int counted, int lastNumber, IntPredicate there) {
        wire.chatter(true);
        wire.peer((w, message) -> {
            if (message instanceof LogRequestList list) {
                for (int id = list.start(); id <= Math.min(list.end(), lastNumber); id++) {
                    if (there.test(id)) {
                        w.answer(new LogEntry(id, counted, lastNumber, 0, 100));
                    }
                }
            }
        });
        return new LogListDownload(wire.target(), ExchangeObserver.NONE);
    }

    private List<Integer> numbers(LogListDownload listing) {
        listing.start(wire.now());
        assertThat(wire.run(listing, 14)).isEqualTo(DONE);
        return listing.logs().stream().map(VehicleLog::number).toList();
    }

    @Test
    void deletedOnesAreNotWaitedFor() {
        LogListDownload listing = listOf(12, 31, id -> id >= 20 && id != 22 && id != 23 && id != 27);

        assertThat(numbers(listing)).containsExactly(20, 21, 24, 25, 26, 28, 29, 30, 31);
        assertThat(listing.incomplete())
                .contains("The vehicle says that it keeps 12 logs and lists 9 of them; it does not list number 22, 23,"
                        + " 27, which may have been deleted.");
    }

    @Test
    void theLastOneMayBeDeletedToo() {
        LogListDownload listing = listOf(5, 9, id -> id >= 5 && id < 9);

        assertThat(numbers(listing)).containsExactly(5, 6, 7, 8);
        assertThat(listing.incomplete()).get().asString().contains("number 9");
    }

    @Test
    void aCountWithoutTheDeletedOnesIsRightAsWell() {
        wire.fault(MessageFault.LOST, 1);
        LogListDownload listing = listOf(4, 9, id -> id == 4 || id == 5 || id == 8 || id == 9);

        assertThat(numbers(listing)).containsExactly(4, 5, 8, 9);
        assertThat(listing.incomplete()).isEmpty();
    }

    @Test
    void oneThatCountsLessThanItListsLosesNone() {
        wire.peer((w, message) -> {
            if (message instanceof LogRequestList) {
                for (int id = 1; id <= 5; id++) {
                    wire.answer(new LogEntry(id, 3, 5, 1_700_000_000L, 1_000));
                }
            }
        });

        assertThat(numbers(new LogListDownload(wire.target(), ExchangeObserver.NONE)))
                .containsExactly(1, 2, 3, 4, 5);
    }

    @Test
    void aNewOneThatIsBegunMeanwhileTakesThePlaceOfTheOldest() {
        wire.peer((w, message) -> {
            if (message instanceof LogRequestList) {
                wire.answer(new LogEntry(1, 3, 3, 1_700_000_000L, 1_000));
                for (int id : new int[] {4, 2, 3}) {
                    wire.answer(new LogEntry(id, 3, 4, 1_700_000_000L, 1_000));
                }
            }
        });

        assertThat(numbers(new LogListDownload(wire.target(), ExchangeObserver.NONE)))
                .containsExactly(2, 3, 4);
    }

    @Test
    void isContentWithAVehicleThatHasNoLogs() {
        LogVehicle empty = new LogVehicle(0, 0);
        wire.peer(empty::take);
        LogListDownload listing = new LogListDownload(wire.target(), ExchangeObserver.NONE);

        assertThat(wire.runWhole(listing)).isEqualTo(DONE);
        assertThat(listing.logs()).isEmpty();
        assertThat(wire.sent(LogRequestList.class)).hasSize(1);
    }

    @Test
    void fetchesALogByteForByteThoughATenthIsLost() {
        wire.lossy(0.1, new Random(8));
        LogDownload download = download();
        download.start(wire.now());

        assertThat(wire.run(download, 600)).isEqualTo(DONE);
        assertThat(memory.content).isEqualTo(vehicle.content);
        assertThat(wire.sent(LogRequestEnd.class)).hasSize(1);
    }

    @Test
    void goesOnAfterABreakOfTheLink() {
        LogDownload download = download();
        wire.lossy(0.3, new Random(8));
        download.start(wire.now());
        wire.run(download, 0.1);
        wire.cut(true);
        assertThat(wire.run(download, 50)).isNull();
        wire.cut(false);
        wire.lossy(0, new Random(8));

        assertThat(wire.run(download, 60)).isEqualTo(DONE);
        assertThat(memory.content).isEqualTo(vehicle.content);
        assertThat(vehicle.poured).isLessThan(BYTES / 90 * 3 / 2);
    }

    @Test
    void beginsWhereAnEarlierAttemptEnded() {
        LogDownload first = download();
        wire.lossy(0.4, new Random(8));
        first.start(wire.now());
        wire.run(first, 0.1);
        wire.cut(true);
        assertThat(wire.run(first, 90)).isInstanceOf(Outcome.TimedOut.class);
        assertThat(memory.interrupted).isTrue();
        wire.cut(false);
        wire.lossy(0, new Random(8));
        int had = memory.kept.cardinality();
        assertThat(had).isPositive();
        vehicle.poured = 0;

        assertThat(wire.runWhole(download())).isEqualTo(DONE);
        assertThat(memory.content).isEqualTo(vehicle.content);
        assertThat(vehicle.poured).isEqualTo((BYTES + 89) / 90 - had);
    }

    @Test
    void fetchesAgainWhatFoundNoRoom() {
        memory.noRoomYet.set(7);
        memory.noRoomYet.set(700, 720);

        assertThat(wire.runWhole(download())).isEqualTo(DONE);
        assertThat(memory.content).isEqualTo(vehicle.content);
    }

    @Test
    void isDoneOnlyWhenTheWholeLogIsSafe() {
        memory.slow = true;
        LogDownload download = download();
        download.start(wire.now());
        assertThat(wire.run(download, 60)).isNull();
        memory.state = VehicleLogSink.State.WRITTEN;

        assertThat(wire.run(download, 1)).isEqualTo(DONE);
    }

    @Test
    void saysThatTheDiskIsFull() {
        memory.slow = true;
        LogDownload download = download();
        download.start(wire.now());
        wire.run(download, 60);
        memory.state = VehicleLogSink.State.FAILED;

        assertThat(wire.run(download, 1)).isInstanceOf(Outcome.Failed.class);
        assertThat(memory.interrupted).isTrue();
    }

    @Test
    void takesTheWordOfTheVehicleWhereTheLogEndsBeforeItsSize() {
        wire.peer((w, message) -> {
            vehicle.take(w, message);
            if (message instanceof LogRequestData data && data.ofs() + data.count() > BYTES) {
                w.answer(new org.dronemap.mavlink.message.LogData(3, BYTES, 0, new int[90]));
            }
        });
        LogDownload download =
                new LogDownload(wire.target(), new VehicleLog(3, null, BYTES + 4_000), memory, ExchangeObserver.NONE);

        assertThat(wire.runWhole(download)).isEqualTo(DONE);
        assertThat(memory.content).isEqualTo(vehicle.content);
    }

    @Test
    void tellsTheVehicleToStopWhenNobodyWantsItAnyMore() {
        LogDownload download = download();
        wire.lossy(0.5, new Random(1));
        download.start(wire.now());
        wire.run(download, 0.2);
        download.cancel(wire.now());

        assertThat(wire.sent(LogRequestEnd.class)).hasSize(1);
        assertThat(memory.interrupted).isTrue();
    }
}
