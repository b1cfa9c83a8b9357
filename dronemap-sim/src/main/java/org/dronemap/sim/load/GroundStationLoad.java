package org.dronemap.sim.load;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.Clock;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.signing.OutgoingSigner;
import org.dronemap.mavlink.signing.SigningClock;
import org.dronemap.mavlink.signing.SigningKey;

/**
 * Load test: many ground stations attached to the outlet, which count the messages of vehicles. Stuck ones attach by
 * TCP and never read. One thread.
 */
final class GroundStationLoad {
    private static final Heartbeat HEARTBEAT = new Heartbeat(6, 8, 0, 0, 4, 3);
    private static final int SYSTEM_ID = 250;
    private static final int HIGHEST_VEHICLE = 240;
    private static final int CONTROL_STATUS = 512;
    private static final int BUFFER_BYTES = 1 << 20;
    private static final int STUCK_BUFFER_BYTES = 4_096;
    private static final int LARGEST = 2_048;
    private static final long SECOND_NANOS = 1_000_000_000L;
    private static final long LATEST_NANOS = 20 * SECOND_NANOS;
    private static final long NAP_MILLIS = 20;

    private final SendSchedule pace;
    private final long fromNanos;
    private final long untilNanos;
    private final Selector selector = Selector.open();
    private final List<Station> stations = new ArrayList<>();
    private final List<StalledStation> stuck = new ArrayList<>();
    private final ByteBuffer buffer = ByteBuffer.allocateDirect(LARGEST);

    GroundStationLoad(LoadArguments arguments) throws IOException {
        pace = new SendSchedule(
                arguments.longInteger("--start-nanos"), arguments.integer("--vehicles"), arguments.integer("--rate"));
        fromNanos = arguments.longInteger("--from-nanos");
        untilNanos = arguments.longInteger("--until-nanos");
        String[] passphrases = arguments.text("--passphrases").split(",", -1);
        InetAddress here = InetAddress.getLoopbackAddress();
        InetSocketAddress udp = new InetSocketAddress(here, arguments.integer("--port"));
        InetSocketAddress tcp = new InetSocketAddress(here, arguments.integer("--tcp-port"));
        int clients = arguments.integer("--clients");
        for (int number = 0; number < clients; number++) {
            stations.add(new Station(udp, new StationSigner(passphrases[number % passphrases.length], number)));
        }
        for (int number = clients; number < clients + arguments.integer("--stuck"); number++) {
            stuck.add(new StalledStation(tcp, new StationSigner(passphrases[number % passphrases.length], number)));
        }
    }

    String run() throws IOException {
        long beat = System.nanoTime() - SECOND_NANOS;
        for (long now = System.nanoTime(); now < untilNanos || isAwaiting(now); now = System.nanoTime()) {
            if (now - beat >= SECOND_NANOS) {
                beat += SECOND_NANOS;
                for (Station station : stations) {
                    station.beat();
                }
                for (StalledStation one : stuck) {
                    one.beat();
                }
            }
            selector.select(NAP_MILLIS);
            for (SelectionKey key : selector.selectedKeys()) {
                ((Station) key.attachment()).read();
            }
            selector.selectedKeys().clear();
        }
        long[] counts = stations.stream()
                .mapToLong(station -> station.arrivals.frames())
                .sorted()
                .toArray();
        return "{\"clients\":" + counts.length + ",\"stuck\":" + stuck.size() + ",\"frames\":"
                + Arrays.stream(counts).sum() + ",\"fewest\":" + counts[0] + ",\"most\":" + counts[counts.length - 1]
                + "}";
    }

    /** What was lost never comes. */
    private boolean isAwaiting(long now) {
        return now < untilNanos + LATEST_NANOS && !stations.stream().allMatch(station -> station.arrivals.complete());
    }

    /** Signs what one of them says. */
    private static final class StationSigner {
        private final FrameWriter writer = new FrameWriter(SYSTEM_ID, 190, 2);
        private final OutgoingSigner signer;

        StationSigner(String passphrase, int link) {
            SigningKey key = new SigningKey(key(passphrase));
            signer = new OutgoingSigner(key, new SigningClock(Clock.systemUTC(), 0), link);
        }

        private static byte[] key(String passphrase) {
            try {
                return MessageDigest.getInstance("SHA-256").digest(passphrase.getBytes(StandardCharsets.UTF_8));
            } catch (NoSuchAlgorithmException e) {
                throw new IllegalStateException(e);
            }
        }

        ByteBuffer beat() {
            return ByteBuffer.wrap(writer.frame(HEARTBEAT, signer));
        }
    }

    private final class Station {
        private final DatagramChannel channel = DatagramChannel.open();
        private final StationSigner voice;
        private final ArrivalCounter arrivals = new ArrivalCounter(pace, fromNanos, untilNanos);

        Station(InetSocketAddress outlet, StationSigner voice) throws IOException {
            this.voice = voice;
            channel.setOption(StandardSocketOptions.SO_RCVBUF, BUFFER_BYTES);
            channel.connect(outlet);
            channel.configureBlocking(false);
            channel.register(selector, SelectionKey.OP_READ, this);
        }

        void beat() throws IOException {
            channel.write(voice.beat());
        }

        void read() throws IOException {
            while (true) {
                buffer.clear();
                if (channel.read(buffer) <= 0) {
                    return;
                }
                if (isOfAVehicle()) {
                    arrivals.came(buffer);
                }
            }
        }

        /** A datagram is a frame of MAVLink 2; who has control is said by the cloud. */
        private boolean isOfAVehicle() {
            int system = buffer.get(5) & 0xFF;
            int message = (buffer.get(7) & 0xFF) | ((buffer.get(8) & 0xFF) << 8) | ((buffer.get(9) & 0xFF) << 16);
            return system <= HIGHEST_VEHICLE && message != CONTROL_STATUS;
        }
    }

    private static final class StalledStation {
        private final SocketChannel channel = SocketChannel.open();
        private final StationSigner voice;

        StalledStation(InetSocketAddress outlet, StationSigner voice) throws IOException {
            this.voice = voice;
            channel.setOption(StandardSocketOptions.SO_RCVBUF, STUCK_BUFFER_BYTES);
            channel.connect(outlet);
        }

        void beat() throws IOException {
            channel.write(voice.beat());
        }
    }
}
