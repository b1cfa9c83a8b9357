package org.dronemap.proxy.endpoint;

import com.fazecast.jSerialComm.SerialPort;
import com.fazecast.jSerialComm.SerialPortInvalidPortException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.ArrayBlockingQueue;
import org.dronemap.core.time.Loop;
import org.dronemap.core.time.Time;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * An open serial device, such as a telemetry radio or a flight controller on a cable. Its peer is called after the
 * device, since there is no address. A device takes bytes as slowly as its rate, so frames wait in a queue of 64 for a
 * thread that writes; a frame that finds no room is dropped.
 */
final class SerialConnection implements OutboundConnection {
    private static final Logger LOG = LoggerFactory.getLogger(SerialConnection.class);
    private static final int READ_MILLIS = 200;
    private static final int MOST_WAITING = 64;
    private static final long WRITER_LOOKS_NANOS = 200_000_000;

    static {
        // Not a name that others could foresee, in a directory that everybody can write to.
        System.setProperty("jSerialComm.library.randomizeNativeName", "true");
    }

    private final SerialPort port;
    private final String device;
    private final ArrayBlockingQueue<byte[]> waiting = new ArrayBlockingQueue<>(MOST_WAITING);
    private final Loop writer;
    private volatile boolean closed;
    private byte[] chunk = new byte[0];

    private SerialConnection(SerialPort port, String device, Time time) {
        this.port = port;
        this.device = device;
        writer = time.loop("serial-out", this::write);
    }

    static OutboundConnection dial(EndpointUrl url, Time time) throws IOException {
        String device = url.path();
        if (!Files.exists(Path.of(device))) {
            throw new IOException("there is no device " + device + "; is it plugged in?");
        }
        SerialPort port;
        try {
            port = SerialPort.getCommPort(device);
        } catch (SerialPortInvalidPortException e) {
            throw new IOException(device + " is no serial device", e);
        }
        port.setComPortParameters(url.baud(), 8, SerialPort.ONE_STOP_BIT, SerialPort.NO_PARITY);
        port.setFlowControl(SerialPort.FLOW_CONTROL_DISABLED);
        port.setComPortTimeouts(SerialPort.TIMEOUT_READ_SEMI_BLOCKING, READ_MILLIS, 0);
        if (!port.openPort(0)) {
            throw new IOException(device + " cannot be opened (error " + port.getLastErrorCode()
                    + "); does another program hold it, and may this one use it (group dialout)?");
        }
        SerialConnection line = new SerialConnection(port, device, time);
        line.writer.start();
        return line;
    }

    @Override
    public PeerAddress address() {
        return new PeerAddress(device, 0);
    }

    @Override
    public boolean isLocal() {
        return true;
    }

    @Override
    public int read(ByteBuffer into, long patienceMillis) throws IOException {
        if (chunk.length != into.remaining()) {
            chunk = new byte[into.remaining()];
        }
        int count = port.readBytes(chunk, chunk.length);
        if (count < 0) {
            throw new IOException(device + " is gone");
        }
        into.put(chunk, 0, count);
        return count;
    }

    @Override
    public boolean send(byte[] frame) {
        boolean taken = !closed && waiting.offer(frame);
        if (taken) {
            writer.wake();
        }
        return taken;
    }

    @Override
    public int waiting() {
        return waiting.size();
    }

    /** May wait for the device. */
    private long write() {
        for (byte[] frame = waiting.poll(); frame != null && !closed; frame = waiting.poll()) {
            if (port.writeBytes(frame, frame.length) < 0) {
                LOG.debug("{} took no bytes", device);
            }
        }
        return WRITER_LOOKS_NANOS;
    }

    @Override
    public void close() {
        closed = true;
        writer.close();
        waiting.clear();
        // What is not sent yet would hold the closing up, for ever when nobody takes it.
        port.flushIOBuffers();
        port.closePort();
    }
}
