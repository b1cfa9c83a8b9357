package org.dronemap.proxy.endpoint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.awaitility.core.ConditionFactory;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class DatagramQueueTest {
    private static final Duration PATIENCE = Duration.ofSeconds(30);
    private static final int MOST = 16;

    private final DatagramQueue intake = new DatagramQueue(40_000, MOST);
    private final List<ByteBuffer> worked = new ArrayList<>();
    private DatagramChannel socket;
    private DatagramChannel vehicle;

    @BeforeEach
    void open() throws IOException {
        socket = DatagramChannel.open();
        socket.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
        socket.configureBlocking(false);
        vehicle = DatagramChannel.open();
        vehicle.connect(socket.getLocalAddress());
    }

    @AfterEach
    void close() throws IOException {
        socket.close();
        vehicle.close();
    }

    @Test
    void keepsOrderAndBytesHoweverLongDatagramsAndWaitsAre() throws IOException {
        Random chance = new Random(7);
        List<ByteBuffer> sent = new ArrayList<>();
        for (int round = 0; round < 300; round++) {
            sent.add(send(chance));
            patiently().until(() -> isTaken(sent.size()));
            if (chance.nextInt(3) == 0) {
                workOff();
            }
        }
        while (worked.size() < sent.size()) {
            assertThat(workOff()).isTrue();
        }

        assertThat(worked).isEqualTo(sent);
    }

    @Test
    void leavesToTheSocketWhatFindsNoRoom() throws IOException {
        Random chance = new Random(1);
        for (int i = 0; i < MOST + 4; i++) {
            send(chance, 40);
        }
        patiently().until(() -> {
            intake.readFrom(socket);
            return intake.waiting() == MOST;
        });

        intake.readFrom(socket);
        assertThat(intake.waiting()).isEqualTo(MOST);
        patiently().until(() -> isTaken(MOST + 4));
    }

    @Test
    void wantsRoomThatCanBeCounted() {
        assertThatThrownBy(() -> new DatagramQueue(40_000, 15)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new DatagramQueue(10_000, 16)).isInstanceOf(IllegalArgumentException.class);
    }

    /** Looks at once and often: a datagram on loopback takes no time. */
    private static ConditionFactory patiently() {
        return await().atMost(PATIENCE).pollDelay(Duration.ZERO).pollInterval(Duration.ofMillis(1));
    }

    /** Makes room when there is none. */
    private boolean isTaken(int sent) throws IOException {
        intake.readFrom(socket);
        return worked.size() + intake.waiting() == sent || (workOff() && worked.size() + intake.waiting() == sent);
    }

    private ByteBuffer send(Random chance) throws IOException {
        return send(chance, 1 + chance.nextInt(DatagramQueue.LARGEST_DATAGRAM));
    }

    private ByteBuffer send(Random chance, int length) throws IOException {
        byte[] datagram = new byte[length];
        chance.nextBytes(datagram);
        vehicle.write(ByteBuffer.wrap(datagram));
        return ByteBuffer.wrap(datagram);
    }

    private boolean workOff() throws IOException {
        InetSocketAddress expected = (InetSocketAddress) vehicle.getLocalAddress();
        return intake.process((from, datagram) -> {
            assertThat(from).isEqualTo(expected);
            ByteBuffer copy = ByteBuffer.allocate(datagram.remaining());
            copy.put(datagram).flip();
            worked.add(copy);
        });
    }
}
