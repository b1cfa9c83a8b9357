package org.dronemap.sim.load;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.AsynchronousCloseException;
import java.nio.channels.DatagramChannel;

/** Load test: counts the datagrams that mavlink-router forwards, for comparison with the cloud. */
final class DatagramSink {
    private static final System.Logger LOG = System.getLogger(DatagramSink.class.getName());
    private static final int LARGEST = 65_535;
    private static final int BUFFER_BYTES = 4 << 20;

    private final DatagramChannel channel = DatagramChannel.open();
    private long received;
    private long bytes;

    DatagramSink(LoadArguments arguments) throws IOException {
        channel.setOption(StandardSocketOptions.SO_RCVBUF, BUFFER_BYTES);
        channel.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), arguments.integer("--port")));
    }

    String run() throws IOException, InterruptedException {
        Thread counter = new Thread(this::count, "sink");
        counter.start();
        byte[] untilItsEnd = System.in.readAllBytes();
        LOG.log(System.Logger.Level.DEBUG, "{0} bytes came before the end", untilItsEnd.length);
        channel.close();
        counter.join();
        return "{\"received\":" + received + ",\"bytes\":" + bytes + "}";
    }

    private void count() {
        ByteBuffer buffer = ByteBuffer.allocateDirect(LARGEST);
        try {
            while (true) {
                buffer.clear();
                channel.receive(buffer);
                received++;
                bytes += buffer.position();
            }
        } catch (AsynchronousCloseException e) {
            LOG.log(System.Logger.Level.DEBUG, "The end", e);
        } catch (IOException e) {
            throw new IllegalStateException("the sink broke", e);
        }
    }
}
