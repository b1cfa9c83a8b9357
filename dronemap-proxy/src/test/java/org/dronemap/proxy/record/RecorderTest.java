package org.dronemap.proxy.record;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.dronemap.core.cloud.EpochGuard;
import org.dronemap.core.cloud.SendAuthority;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.recording.Recording;
import org.dronemap.core.recording.RecordingPolicy;
import org.dronemap.core.time.RealTime;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Attitude;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.tlog.TlogReader;
import org.dronemap.proxy.TestCloud;
import org.dronemap.proxy.session.FrameTap;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Flights as files: when they begin and end, what is in them, and what a crash or a full disk leaves. */
class RecorderTest {
    private static final Duration PATIENCE = Duration.ofSeconds(10);
    private static final DroneId DRONE = new DroneId("d1");
    private static final Instant START = Instant.parse("2026-03-04T05:06:07Z");

    @TempDir
    Path directory;

    private final TestRecordingStore store = new TestRecordingStore();
    private final StoreWriter journal = new StoreWriter(new RealTime());
    private final ManualClock clock = new ManualClock(START);
    private final AtomicLong freeBytes = new AtomicLong(Long.MAX_VALUE);
    private final FrameWriter vehicle = new FrameWriter(1, 1, 2);
    private final FrameWriter cloud = new FrameWriter(255, 190, 2);
    private final List<byte[]> expected = new ArrayList<>();
    private Recorder recorder;

    @BeforeEach
    void make() {
        recorder = recorder(RecordingPolicy.DEFAULT);
    }

    private Recorder recorder(RecordingPolicy policy) {
        return recorder(policy, store);
    }

    private Recorder recorder(RecordingPolicy policy, TestRecordingStore kept) {
        return new Recorder(
                directory,
                policy,
                new Recorder.Dependencies(kept, journal, drone -> "Copter 1"),
                new RealTime(clock),
                freeBytes::get);
    }

    @AfterEach
    void close() {
        recorder.close();
        journal.close();
    }

    @Test
    void keepsTheSecondsBeforeArmingAndBothDirectionsByteForByte() throws IOException {
        recorder.start();
        FrameTap tap = recorder.open(1);
        tap.bound(DRONE);
        hears(tap, heartbeat(false), false);
        clock.pass(20);
        hears(tap, heartbeat(false), false);
        clock.pass(3);
        hears(tap, new Attitude(1, 0f, 0f, 0f, 0f, 0f, 0f), true);
        says(tap, new CommandLong(1, 1, 400, 0, 1f, 0f, 0f, 0f, 0f, 0f, 0f), true);
        hears(tap, heartbeat(true), true);
        clock.pass(60);
        hears(tap, heartbeat(false), true);
        clock.pass(4);
        hears(tap, new Attitude(2, 0f, 0f, 0f, 0f, 0f, 0f), true);
        clock.pass(2);
        hears(tap, new Attitude(3, 0f, 0f, 0f, 0f, 0f, 0f), false);

        Recording done = awaitEnd();
        assertThat(done.state()).isEqualTo(Recording.State.COMPLETE);
        assertThat(done.notice()).isNull();
        List<TlogReader.Timed> records = read(done);
        assertThat(records).extracting(record -> record.frame().bytes()).containsExactlyElementsOf(withFirst(records));
        assertThat(done.frames()).isEqualTo(records.size());
        assertThat(done.bytes()).isEqualTo(Files.size(file(done)));
        assertThat(done.end()).isEqualTo(START.plusSeconds(87));
        assertThat(records.get(records.size() - 1).micros())
                .isEqualTo(START.plusSeconds(87).toEpochMilli() * 1000);
    }

    /** The heartbeat from the second half of what came before may be in it as well: seconds before are at least five. */
    private List<byte[]> withFirst(List<TlogReader.Timed> records) {
        List<byte[]> whole = new ArrayList<>();
        records.subList(0, records.size() - expected.size())
                .forEach(record -> whole.add(record.frame().bytes()));
        assertThat(whole.size()).isLessThanOrEqualTo(2);
        whole.addAll(expected);
        return whole;
    }

    @Test
    void recordsNothingOfADroneThatIsNeverArmed() throws IOException {
        recorder.start();
        FrameTap tap = recorder.open(1);
        tap.bound(DRONE);
        for (int i = 0; i < 100; i++) {
            hears(tap, heartbeat(false), false);
            clock.pass(1);
        }
        recorder.flush();
        assertThat(recorder.archive().recordings()).isEmpty();
        assertThat(directory).isEmptyDirectory();
    }

    @Test
    void recordsFromTheFirstMessageWhenAlwaysOn() throws IOException {
        recorder.close();
        recorder = recorder(new RecordingPolicy(RecordingPolicy.When.ALWAYS, 1_000_000, 0));
        recorder.start();
        FrameTap tap = recorder.open(1);
        hears(tap, heartbeat(false), true);
        tap.bound(DRONE);
        hears(tap, heartbeat(false), true);
        tap.ended();
        Recording done = awaitEnd();
        assertThat(read(done)).hasSize(2);
        assertThat(done.state()).isEqualTo(Recording.State.COMPLETE);
    }

    @Test
    void saysThatContactWasLostWhileArmed() throws IOException {
        recorder.start();
        FrameTap tap = armed();
        tap.ended();
        Recording done = awaitEnd();
        assertThat(done.state()).isEqualTo(Recording.State.INCOMPLETE);
        assertThat(done.notice()).contains("Contact was lost");
    }

    @Test
    void goesOnInOneFileWhenTheDroneComesBackFromAnotherAddress() throws IOException {
        recorder.start();
        FrameTap first = armed();
        clock.pass(2);
        FrameTap second = recorder.open(1);
        hears(second, heartbeat(true), true);
        second.bound(DRONE);
        clock.pass(2);
        hears(second, heartbeat(false), true);
        says(first, new Heartbeat(6, 8, 0, 0, 4, 3), true);
        recorder.flush();
        clock.pass(6);
        Recording done = awaitEnd();
        says(first, new Heartbeat(6, 8, 0, 0, 4, 3), false);
        recorder.flush();
        assertThat(recorder.archive().recordings()).hasSize(1);
        assertThat(read(done)).hasSize(4);
    }

    @Test
    void leavesTheLastSecondsInTheFileWhenTimeRunsOutInTheMiddleOfARound() throws IOException {
        recorder.start();
        FrameTap tap = armed();
        recorder.flush();
        hears(tap, heartbeat(false), true);
        clock.passAfterTheNextLookOf("recorder", 10);
        Recording done = awaitEnd();
        recorder.flush();
        assertThat(recorder.archive().recordings()).hasSize(1);
        assertThat(read(done)).hasSize(2);
    }

    @Test
    void countsWhatTheDiskWasTooSlowForAndSaysSo() throws IOException {
        FrameTap tap = armed();
        Message attitude = new Attitude(1, 1f, 1f, 1f, 1f, 1f, 1f);
        long sent = 1;
        // Nobody writes yet: more than may wait for the disk.
        for (; sent < 40_000; sent++) {
            hears(tap, attitude, false);
        }
        hears(tap, heartbeat(false), false);
        sent++;
        clock.pass(10);
        recorder.start();
        Recording done = awaitEnd();
        assertThat(done.drops()).isPositive();
        assertThat(done.frames() + done.drops()).isEqualTo(sent);
        assertThat(done.state()).isEqualTo(Recording.State.INCOMPLETE);
        assertThat(done.notice()).contains(done.drops() + " messages are missing");
        assertThat(read(done)).hasSize((int) done.frames());
    }

    @Test
    void stopsBeforeTheDiskIsFullAndSaysSo() throws IOException {
        recorder.start();
        FrameTap tap = armed();
        recorder.flush();
        freeBytes.set(1_000);
        TestCloud.await(
                PATIENCE,
                () -> recorder.archive().recordings().stream().anyMatch(recording -> recording.notice() != null),
                () -> "nothing was said");
        hears(tap, heartbeat(false), false);
        clock.pass(10);
        Recording done = awaitEnd();
        assertThat(done.notice()).contains("less than 200 MB").contains("1 messages are missing");
        assertThat(read(done)).hasSize(1);
    }

    @Test
    void mendsWhatACrashLeftBehind() throws IOException {
        recorder.start();
        armed();
        recorder.flush();
        Recording cut = recorder.archive().recordings().get(0);
        Files.write(file(cut), new byte[] {0, 5, 4, 3, 2, 1, 0, 0, (byte) 0xFD, 40, 0, 7}, StandardOpenOption.APPEND);
        Files.copy(file(cut), directory.resolve("20260101T000000Z_lost-one.tlog"));
        // What was known at the crash; the one that "crashed" still lives, and goes on saving.
        TestRecordingStore known = new TestRecordingStore();
        known.save(cut);

        Recorder next = recorder(RecordingPolicy.DEFAULT, known);
        next.start();
        Recording mended = next.archive().recording(cut.id()).orElseThrow();
        assertThat(mended.state()).isEqualTo(Recording.State.INCOMPLETE);
        assertThat(mended.notice()).contains("The server stopped");
        assertThat(mended.frames()).isEqualTo(1);
        assertThat(mended.bytes()).isEqualTo(Files.size(file(cut)));
        assertThat(read(mended)).hasSize(1);
        Recording adopted =
                next.archive().recording("20260101T000000Z_lost-one").orElseThrow();
        assertThat(adopted.drone().value()).isEqualTo("lost-one");
        assertThat(adopted.frames()).isEqualTo(1);
        next.close();
    }

    @Test
    void makesRoomByRemovingTheOldestAndSaysSo() throws IOException {
        for (int day = 1; day <= 3; day++) {
            Instant when = START.minus(Duration.ofDays(10 - day));
            Files.write(directory.resolve("r" + day + ".tlog"), new byte[600]);
            store.save(
                    new Recording("r" + day, DRONE, "Copter 1", when, when, 600, 1, 0, Recording.State.COMPLETE, null));
        }
        recorder.close();
        recorder = recorder(new RecordingPolicy(RecordingPolicy.When.FLIGHTS, 1_300, 0));
        recorder.start();
        TestCloud.await(PATIENCE, () -> recorder.archive().room().removed() == 1, () -> "nothing was removed");
        assertThat(store.recordings()).extracting(Recording::id).containsExactly("r3", "r2");
        assertThat(directory.resolve("r1.tlog")).doesNotExist();
        assertThat(recorder.archive().room().notice()).contains("oldest");
        assertThat(recorder.archive().room().usedBytes()).isEqualTo(1_200);
    }

    @Test
    void removesWhatIsOlderThanAsked() throws IOException {
        for (int days = 1; days <= 3; days++) {
            Instant when = START.minus(Duration.ofDays(days));
            store.save(
                    new Recording("r" + days, DRONE, "Copter 1", when, when, 0, 0, 0, Recording.State.COMPLETE, null));
        }
        recorder.close();
        recorder = recorder(new RecordingPolicy(RecordingPolicy.When.FLIGHTS, 1_300, 2));
        clock.pass(60);
        recorder.start();
        TestCloud.await(PATIENCE, () -> recorder.archive().room().removed() == 2, () -> "nothing was removed");
        assertThat(store.recordings()).extracting(Recording::id).containsExactly("r1");
    }

    @Test
    void deletesWhatHasEndedAndRefusesWhatGoesOn() throws IOException {
        recorder.start();
        FrameTap tap = armed();
        recorder.flush();
        String id = recorder.archive().recordings().get(0).id();
        assertThat(recorder.archive().delete(id))
                .hasValueSatisfying(why -> assertThat(why).contains("goes on"));
        hears(tap, heartbeat(false), false);
        clock.pass(10);
        Recording done = awaitEnd();
        assertThat(recorder.archive().delete(id)).isEmpty();
        assertThat(directory).isEmptyDirectory();
        assertThat(recorder.archive().recordings()).isEmpty();
        assertThat(recorder.archive().delete(id))
                .hasValueSatisfying(why -> assertThat(why).contains("There is no recording"));
    }

    @Test
    void notesForEachFrameThatWentOutWhichCommandEpochAndUserItWasFor() throws IOException {
        recorder.start();
        FrameTap tap = recorder.open(1);
        tap.bound(DRONE);
        says(tap, new Heartbeat(6, 8, 0, 0, 4, 3), true);
        hears(tap, heartbeat(true), true);
        byte[] arm = cloud.frame(new CommandLong(1, 1, 400, 0, 1f, 0f, 0f, 0f, 0f, 0f, 0f));
        tap.sent(arm, new SendAuthority(new CommandId("arm-it-now"), 7L, "ann", EpochGuard.NONE));
        recorder.flush();

        String id = recorder.archive().recordings().get(0).id();
        byte[] tlog = Files.readAllBytes(recorder.archive().file(id).orElseThrow());
        List<String> lines = Files.readAllLines(recorder.archive().sent(id).orElseThrow());
        assertThat(lines)
                .startsWith("offset\tcommand\tepoch\tby", "0\t-\t-\tdronemap")
                .hasSize(3);
        String[] armed = lines.get(2).split("\t", -1);
        assertThat(armed).endsWith("arm-it-now", "7", "ann");
        int offset = Integer.parseInt(armed[0]) + Long.BYTES;
        assertThat(Arrays.copyOfRange(tlog, offset, offset + arm.length)).isEqualTo(arm);
    }

    @Test
    void forgetsNotesOfWhatTheRecordingDoesNotHoldAnyMore() throws IOException {
        Path notes = directory.resolve("notes");
        Files.writeString(notes, SentFrameIndex.HEADER + "0\t-\t-\tdronemap\n200\tc\t7\tann\n12");

        SentFrameIndex.repair(notes, 200);

        assertThat(notes).hasContent(SentFrameIndex.HEADER + "0\t-\t-\tdronemap\n");
    }

    private FrameTap armed() {
        FrameTap tap = recorder.open(1);
        tap.bound(DRONE);
        hears(tap, heartbeat(true), true);
        return tap;
    }

    private static Heartbeat heartbeat(boolean armed) {
        return new Heartbeat(2, 3, armed ? 0x81 : 1, 4, 4, 3);
    }

    private void hears(FrameTap tap, Message message, boolean kept) {
        byte[] raw = vehicle.frame(message);
        new FrameReader().read(ByteBuffer.wrap(raw), tap::received);
        if (kept) {
            expected.add(raw);
        }
    }

    private void says(FrameTap tap, Message message, boolean kept) {
        byte[] raw = cloud.frame(message);
        tap.sent(raw, SendAuthority.HOUSEKEEPING);
        if (kept) {
            expected.add(raw);
        }
    }

    private Recording awaitEnd() {
        return TestCloud.await(
                PATIENCE,
                () -> store.recordings().stream()
                        .filter(recording -> recording.end() != null)
                        .findFirst(),
                () -> "no recording has ended: " + recorder.archive().recordings());
    }

    private Path file(Recording recording) {
        return directory.resolve(recording.id() + ".tlog");
    }

    private List<TlogReader.Timed> read(Recording recording) throws IOException {
        TlogReader reader = new TlogReader(new ByteArrayInputStream(Files.readAllBytes(file(recording))));
        List<TlogReader.Timed> records = new ArrayList<>();
        for (TlogReader.Timed record = reader.next(); record != null; record = reader.next()) {
            records.add(record);
        }
        assertThat(reader.counts().brokenBytes()).isZero();
        assertThat(records).extracting(TlogReader.Timed::frame).allMatch(Frame::verified);
        return records;
    }
}
