package org.dronemap.proxy.endpoint;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import org.jspecify.annotations.Nullable;

/**
 * A bounded queue of datagrams read off a socket and not yet processed, so that bursts do not overflow the socket.
 * Bounded in bytes and number: what finds no room is left to the kernel, which counts what it drops. Owned by the
 * endpoint's thread.
 */
final class DatagramQueue {
    /** A jumbo frame's worth; what is longer is cut, and counted as broken. */
    static final int LARGEST_DATAGRAM = 9_000;

    private final int largest;
    private final ByteBuffer bytes;
    private final int mask;
    private final @Nullable InetSocketAddress[] senders;
    private final int[] starts;
    private final int[] lengths;
    private int next;
    private int taken;
    private int worked;

    /** Works on one datagram; the buffer is used again. */
    interface Handler {
        void received(InetSocketAddress from, ByteBuffer datagram);
    }

    /** {@code most}, a power of two, is how many datagrams may wait. */
    DatagramQueue(int capacityBytes, int most) {
        this(capacityBytes, most, LARGEST_DATAGRAM);
    }

    /** {@code largest}: bytes of the largest datagram that is taken whole. */
    DatagramQueue(int capacityBytes, int most, int largest) {
        this.largest = largest;
        if (Integer.bitCount(most) != 1 || capacityBytes < 2 * largest) {
            throw new IllegalArgumentException(
                    "room for a power of two datagrams and two of the largest: " + most + ", " + capacityBytes);
        }
        bytes = ByteBuffer.allocateDirect(capacityBytes);
        mask = most - 1;
        senders = new InetSocketAddress[most];
        starts = new int[most];
        lengths = new int[most];
    }

    /** Datagrams that wait. */
    int waiting() {
        return taken - worked;
    }

    /** Takes all that the socket has, as far as there is room. */
    void readFrom(DatagramChannel channel) throws IOException {
        while (hasRoom()) {
            bytes.limit(next + largest).position(next);
            SocketAddress from = channel.receive(bytes);
            if (from == null) {
                return;
            }
            if (from instanceof InetSocketAddress address) {
                int slot = taken++ & mask;
                senders[slot] = address;
                starts[slot] = next;
                lengths[slot] = bytes.position() - next;
                next = bytes.position();
            }
        }
    }

    /** Room for the largest in one piece; what waits may begin behind the next one's place. */
    private boolean hasRoom() {
        if (waiting() == 0) {
            // From the beginning again: the same few places are near at hand.
            next = 0;
            taken = 0;
            worked = 0;
            return true;
        }
        if (waiting() > mask) {
            return false;
        }
        int oldest = starts[worked & mask];
        if (oldest >= next) {
            return oldest - next > largest;
        }
        if (next + largest <= bytes.capacity()) {
            return true;
        }
        if (oldest <= largest) {
            return false;
        }
        next = 0;
        return true;
    }

    /** Works on the oldest; false when none waits. */
    boolean process(Handler work) {
        if (waiting() == 0) {
            return false;
        }
        int slot = worked & mask;
        InetSocketAddress from = senders[slot];
        senders[slot] = null;
        bytes.limit(starts[slot] + lengths[slot]).position(starts[slot]);
        worked++;
        if (from != null) {
            work.received(from, bytes);
        }
        return true;
    }
}
