package org.dronemap.sim.load;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.StringReader;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.mavlink.message.Heartbeat;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The load that measurements are made with: its pace, its content, and who compares it with recordings. */
class LoadTest {
    private static final int STEPS = 40;

    @TempDir
    Path folder;

    @Test
    void spreadsVehiclesEvenlyAndKeepsThePaceForEver() {
        SendSchedule pace = new SendSchedule(1_000, 250, 200);
        assertThat(pace.dueNanos(0, 0)).isEqualTo(1_000);
        assertThat(pace.dueNanos(1, 0)).isEqualTo(21_000);
        assertThat(pace.dueNanos(0, 200)).isEqualTo(1_000_001_000L);
        assertThat(pace.dueNanos(249, 200L * 3_600)).isBetween(3_600_004_980_999L, 3_600_004_981_001L);
    }

    @Test
    void saysOnceASecondThatItIsArmedAndNumbersItsPositions() {
        List<Frame> frames = read(said(7, 20));
        assertThat(frames).hasSize(STEPS + 3).allMatch(Frame::verified);
        assertThat(frames.stream()
                        .filter(frame -> frame.messageId() == Heartbeat.ID)
                        .map(Heartbeat::decode)
                        .map(heartbeat -> (heartbeat.baseMode() & 0x80) != 0))
                .containsExactly(true, true, false, false, false);
        GlobalPositionInt position = GlobalPositionInt.decode(frames.get(4));
        assertThat(position.lat() - LoadFrames.LATITUDE_E7).isEqualTo(4);
        assertThat((position.lon() - LoadFrames.LONGITUDE_E7) / LoadFrames.VEHICLE_E7)
                .isEqualTo(7);
    }

    @Test
    void sendsAllOfItFromAPortOfEachVehiclesOwn() throws IOException {
        try (DatagramSocket server = new DatagramSocket(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0))) {
            server.setSoTimeout(5_000);
            String result = new VehicleLoadSender(arguments(
                            "--port", server.getLocalPort(), "--vehicles", 2, "--rate", 400, "--steps", STEPS))
                    .run(new BufferedReader(new StringReader(System.nanoTime() + "\n")), System.out);
            assertThat(result).contains("\"sent\":" + 2 * (STEPS + 3)).contains("\"refused\":0");
            List<Integer> ports = new ArrayList<>();
            for (int i = 0; i < 2 * (STEPS + 3); i++) {
                DatagramPacket packet = new DatagramPacket(new byte[300], 300);
                server.receive(packet);
                ports.add(packet.getPort());
            }
            assertThat(ports.stream().distinct()).hasSize(2);
        }
    }

    @Test
    void findsEveryFrameOfAWholeRecording() throws IOException {
        write("a.tlog", said(0, 20));
        write("b.tlog", said(1, 20));
        assertThat(check(2)).contains("\"missing\":0", "\"foreign\":0", "\"found\":" + 2 * (STEPS + 3));
    }

    @Test
    void missesAFrameThatIsNotThereAndOneThatWasChanged() throws IOException {
        List<byte[]> said = said(0, 20);
        said.remove(11);
        said.get(15)[20] ^= 1;
        write("a.tlog", said);
        assertThat(check(1)).contains("\"missing\":2");
    }

    @Test
    void takesADoubledFrameForForeign() throws IOException {
        List<byte[]> said = said(0, 20);
        said.add(12, said.get(11));
        write("a.tlog", said);
        assertThat(check(1)).contains("\"missing\":0", "\"foreign\":1");
    }

    @Test
    void tellsAFrameThatCameLateFromAForeignOne() throws IOException {
        List<byte[]> said = said(0, 20);
        said.add(15, said.remove(11));
        write("a.tlog", said);
        assertThat(check(1)).contains("\"missing\":0", "\"late\":1", "\"foreign\":0");
    }

    @Test
    void takesARecordingOfNoLoadVehicleForForeign() throws IOException {
        write("a.tlog", said(5, 20));
        assertThat(check(1)).contains("\"found\":0", "\"foreign\":" + (STEPS + 3));
    }

    @Test
    void floodsFromOneAddressWithWhatIsBrokenOrMeansNoGood() throws IOException {
        assertThat(read(flood("hostile"))).hasSizeGreaterThan(150).allMatch(Frame::verified);
        assertThat(read(flood("broken"))).hasSizeLessThan(20);
    }

    private static List<byte[]> flood(String kind) throws IOException {
        try (DatagramSocket server = new DatagramSocket(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0))) {
            server.setSoTimeout(5_000);
            long now = System.nanoTime();
            String result = new Flooder(arguments(
                            "--port",
                            server.getLocalPort(),
                            "--kind",
                            kind,
                            "--rate",
                            200,
                            "--seed",
                            1,
                            "--from-nanos",
                            now,
                            "--until-nanos",
                            now + 2_000_000_000L))
                    .run();
            assertThat(result).contains("\"refused\":0");
            List<byte[]> heard = new ArrayList<>();
            for (int i = 0; i < 200; i++) {
                DatagramPacket packet = new DatagramPacket(new byte[400], 400);
                server.receive(packet);
                heard.add(Arrays.copyOf(packet.getData(), packet.getLength()));
            }
            return heard;
        }
    }

    private static List<byte[]> said(int vehicle, int rate) {
        LoadFrames frames = new LoadFrames(vehicle, rate, false);
        List<byte[]> all = new ArrayList<>();
        for (int step = 0; step < STEPS; step++) {
            all.add(frames.next());
        }
        for (int again = 0; again < 3; again++) {
            all.add(frames.disarmed());
        }
        return all;
    }

    private static List<Frame> read(List<byte[]> raw) {
        FrameReader reader = new FrameReader();
        List<Frame> frames = new ArrayList<>();
        raw.forEach(bytes -> reader.read(ByteBuffer.wrap(bytes), frames::add));
        return frames;
    }

    private void write(String name, List<byte[]> frames) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        long micros = 1_772_600_767_000_000L;
        for (byte[] frame : frames) {
            out.write(ByteBuffer.allocate(8).putLong(micros).array());
            out.write(frame);
            micros += 50_000;
        }
        Files.write(folder.resolve(name), out.toByteArray());
    }

    private String check(int vehicles) throws IOException {
        return new RecordingChecker(
                        arguments("--folder", folder, "--vehicles", vehicles, "--rate", 20, "--steps", STEPS))
                .run();
    }

    private static LoadArguments arguments(Object... words) {
        return new LoadArguments(Arrays.stream(words).map(String::valueOf).toList());
    }
}
