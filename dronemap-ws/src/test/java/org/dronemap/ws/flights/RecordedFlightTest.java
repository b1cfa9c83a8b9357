package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneId;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.ws.command.CommandRequest;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.LinkFrameLog;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.VehicleSpec;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RejectionKind;
import org.dronemap.ws.recording.RecordingService;
import org.dronemap.ws.recording.RecordingView;
import org.dronemap.ws.recording.ReplayView;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Flights recorded: the file is what went over the wire, byte for byte. */
class RecordedFlightTest {
    private static final int CLOUD = 255;
    private static final int ARMED = 128;
    private static final CommandRequest ARM = CommandRequests.arm();

    private final Laboratory lab = new Laboratory(1);
    private final Pilot ann = lab.pilot("ann", Role.OPERATOR);
    private final LabDrone copter = lab.add(VehicleSpec.COPTER);
    private final LinkFrameLog log = copter.wire().log();

    /** One record of a file: microseconds since 1970 and a frame, read by the letter of the format. */
    private record Kept(long micros, byte[] frame) {
        int sender() {
            return frame[0] == (byte) 0xFD ? frame[5] & 0xFF : frame[3] & 0xFF;
        }

        String hex() {
            return HexFormat.of().formatHex(frame);
        }

        boolean saysArmed() {
            // A heartbeat of version 2 has its base mode behind the custom mode, the type and the autopilot.
            return frame[7] == Heartbeat.ID && frame[8] == 0 && frame[9] == 0 && (frame[10 + 6] & ARMED) != 0;
        }
    }

    @BeforeEach
    void isReady() {
        lab.ready(copter);
    }

    @AfterEach
    void close() {
        lab.close();
    }

    private RecordingService service() {
        return lab.server().office().recordings();
    }

    private RecordingView recording(String state) {
        return lab.until(
                "its recording is " + state,
                Duration.ofSeconds(60),
                () -> newest().filter(recording -> recording.state().equals(state)));
    }

    private Optional<RecordingView> newest() {
        return service().recordings(ann.principal(), copter.id().value()).recordings().stream()
                .findFirst();
    }

    private byte[] file(String id) throws IOException {
        return Files.readAllBytes(service().download(ann.principal(), id).file());
    }

    private static List<Kept> records(byte[] tlog) {
        List<Kept> found = new ArrayList<>();
        int at = 0;
        while (at < tlog.length) {
            long micros = ByteBuffer.wrap(tlog, at, Long.BYTES).getLong();
            at += Long.BYTES;
            boolean second = tlog[at] == (byte) 0xFD;
            assertThat(second || tlog[at] == (byte) 0xFE)
                    .as("a frame begins at byte %d", at)
                    .isTrue();
            assertThat(second && (tlog[at + 2] & 1) != 0)
                    .as("a signature was kept")
                    .isFalse();
            int length = (second ? 10 : 6) + (tlog[at + 1] & 0xFF) + 2;
            found.add(new Kept(micros, Arrays.copyOfRange(tlog, at, at + length)));
            at += length;
        }
        return found;
    }

    private static List<String> hex(List<Kept> kept, boolean up) {
        return kept.stream()
                .filter(record -> (record.sender() != CLOUD) == up)
                .map(Kept::hex)
                .toList();
    }

    private List<String> wire(boolean up) {
        return log.frames(up).stream()
                .map(passed -> HexFormat.of().formatHex(passed.frame().bytes()))
                .toList();
    }

    @Test
    void aFlightIsRecordedByteForByteInBothDirections() throws IOException {
        lab.goOn(Duration.ofSeconds(5));
        List<CommandView> given = new ArrayList<>();
        for (CommandRequest each : List.of(ARM, CommandRequests.takeOff(8.0), CommandRequests.land())) {
            given.add(ann.outcome(copter, each));
        }
        assertThat(given).extracting(command -> command.outcome().result()).containsOnly("succeeded");
        lab.until("it is down", Duration.ofMinutes(2), copter::isDown);
        RecordingView done = recording("complete");

        byte[] tlog = file(done.id());
        List<Kept> kept = records(tlog);
        assertThat(done.frames()).isEqualTo(kept.size());
        assertThat(done.bytes()).isEqualTo(tlog.length);
        assertThat(kept).extracting(Kept::micros).isSorted();
        List<String> up = hex(kept, true);
        List<String> down = hex(kept, false);
        assertThat(up).hasSizeGreaterThan(100);
        assertThat(down).hasSizeGreaterThan(10);
        assertThat(Collections.indexOfSubList(wire(true), up))
                .as("what the vehicle said")
                .isNotNegative();
        assertThat(Collections.indexOfSubList(wire(false), down))
                .as("what it was told")
                .isNotNegative();
        assertThat(sentFor(done.id(), kept, given)).containsExactly("arm", "land", "takeOff");
        long armed =
                kept.stream().filter(Kept::saysArmed).findFirst().orElseThrow().micros();
        assertThat(armed - kept.get(0).micros()).as("the seconds before arming").isGreaterThan(3_000_000);
    }

    /** Types of the commands for which something was sent, as noted beside the recording. */
    private Set<String> sentFor(String recording, List<Kept> kept, List<CommandView> given) throws IOException {
        List<String> lines =
                Files.readAllLines(service().sent(ann.principal(), recording).file());
        assertThat(lines.get(0)).isEqualTo("offset\tcommand\tepoch\tby");
        List<String> offsets = new ArrayList<>();
        long at = 0;
        for (Kept record : kept) {
            if (record.sender() == CLOUD) {
                offsets.add(String.valueOf(at));
            }
            at += Long.BYTES + record.frame().length;
        }
        List<String[]> noted =
                lines.stream().skip(1).map(line -> line.split("\t", -1)).toList();
        assertThat(noted).extracting(line -> line[0]).isEqualTo(offsets);
        Set<String> types = new TreeSet<>();
        for (String[] line : noted) {
            if (!line[1].equals("-") && !line[3].equals("dronemap")) {
                CommandView command = given.stream()
                        .filter(each -> each.id().equals(line[1]))
                        .findFirst()
                        .orElseThrow();
                assertThat(line[2]).isEqualTo(String.valueOf(command.epoch()));
                assertThat(line[3]).isEqualTo(command.by());
                types.add(command.type());
            }
        }
        return types;
    }

    @Test
    void aRecordingIsPlayedAndDeleted() throws IOException {
        ann.does(copter, ARM).does(copter, CommandRequests.disarm());
        RecordingView done = recording("complete");
        Pilot viewer = lab.pilot("looks", Role.VIEWER);
        assertThat(service().download(viewer.principal(), done.id()).file()).isNotEmptyFile();
        assertThatThrownBy(() -> service().delete(viewer.principal(), done.id(), true))
                .isInstanceOfSatisfying(
                        Rejection.class, refused -> assertThat(refused.kind()).isEqualTo(RejectionKind.FORBIDDEN));

        ReplayView replay = service().replay(ann.principal(), done.id(), 10.0);
        String shown = lab.until("it is played", Duration.ofSeconds(5), () -> shown(replay.id()));
        assertThat(lab.server().drones().drone(ann.principal(), shown).replay()).isTrue();
        lab.server().office().replays().remove(ann.principal(), replay.id());
        lab.until(
                "its drone has gone",
                Duration.ofSeconds(1),
                () -> lab.server().house().cloud().drone(new DroneId(shown)).isEmpty());

        assertThatThrownBy(() -> service().delete(ann.principal(), done.id(), false))
                .isInstanceOfSatisfying(
                        InvalidInput.class, unsure -> assertThat(unsure.field()).isEqualTo("confirm"));
        service().delete(ann.principal(), done.id(), true);
        assertThat(newest()).isEmpty();
        assertThatThrownBy(() -> service().recording(ann.principal(), done.id()))
                .isInstanceOfSatisfying(
                        Rejection.class, refused -> assertThat(refused.kind()).isEqualTo(RejectionKind.UNKNOWN));
    }

    private Optional<String> shown(String replay) {
        return lab.server().office().replays().replay(ann.principal(), replay).drones().stream()
                .findFirst();
    }

    @Test
    void aCrashLeavesARecordingThatCanBeRead() throws IOException {
        ann.does(copter, ARM);
        RecordingView before = lab.until(
                "some of it is written",
                Duration.ofSeconds(30),
                () -> newest().filter(recording -> recording.state().equals("running") && recording.frames() >= 200));

        lab.crashServer();
        lab.startServer();

        RecordingView mended = service().recording(ann.principal(), before.id());
        assertThat(mended.state()).isEqualTo("incomplete");
        assertThat(mended.notice()).contains("server stopped");
        assertThat(mended.frames()).isGreaterThanOrEqualTo(before.frames());
        assertThat(records(file(mended.id()))).hasSize((int) mended.frames());
    }
}
