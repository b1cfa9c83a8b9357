package org.dronemap.proxy.endpoint;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.ReadableByteChannel;
import java.nio.channels.SelectableChannel;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;

/** Reads bytes from a non-blocking channel of an outbound connection with a timeout. One thread reads. */
final class TimedChannelReader implements Closeable {
    private final ReadableByteChannel channel;
    private final Selector selector;

    private TimedChannelReader(ReadableByteChannel channel, Selector selector) {
        this.channel = channel;
        this.selector = selector;
    }

    /** From now on the channel does not block. */
    static <C extends SelectableChannel & ReadableByteChannel> TimedChannelReader of(C channel) throws IOException {
        channel.configureBlocking(false);
        Selector selector = Selector.open();
        channel.register(selector, SelectionKey.OP_READ);
        return new TimedChannelReader(channel, selector);
    }

    /** Bytes read, 0 when none came in time, -1 at the end. */
    int read(ByteBuffer into, long patienceMillis) throws IOException {
        int count = channel.read(into);
        if (count == 0) {
            selector.select(patienceMillis);
            selector.selectedKeys().clear();
            count = channel.read(into);
        }
        return count;
    }

    /** Wakes who waits; the channel is its owner's to close. */
    @Override
    public void close() throws IOException {
        selector.close();
    }
}
