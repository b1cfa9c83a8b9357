package org.dronemap.ws.testserver;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketException;
import java.nio.charset.StandardCharsets;

/** A client of a port that says just the bytes it is told to say. */
public final class RawClient implements AutoCloseable {
    private static final int PATIENCE_MILLIS = 30_000;

    private final Socket socket;

    public RawClient(int port) {
        this(port, "127.0.0.1");
    }

    /** {@code from}: an address of this machine that it speaks from, as a literal. */
    public RawClient(int port, String from) {
        try {
            socket = new Socket(InetAddress.getLoopbackAddress(), port, InetAddress.getByName(from), 0);
            socket.setSoTimeout(PATIENCE_MILLIS);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** False when the other side does not want any more. */
    public boolean say(byte[] bytes) {
        try {
            OutputStream out = socket.getOutputStream();
            out.write(bytes);
            out.flush();
            return true;
        } catch (IOException closed) {
            return false;
        }
    }

    public boolean say(String text) {
        return say(text.getBytes(StandardCharsets.UTF_8));
    }

    /** All that is said until the other side closes. */
    public String hearAll() {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        try {
            InputStream in = socket.getInputStream();
            for (int value = in.read(); value >= 0; value = in.read()) {
                all.write(value);
            }
        } catch (SocketException reset) {
            // closed, only less politely
        } catch (IOException e) {
            throw new UncheckedIOException("nothing more came, and it was not closed", e);
        }
        return all.toString(StandardCharsets.UTF_8);
    }

    /** The first line, without waiting for what follows. */
    public String hearLine() {
        StringBuilder line = new StringBuilder();
        try {
            InputStream in = socket.getInputStream();
            for (int value = in.read(); value >= 0 && value != '\n'; value = in.read()) {
                line.append((char) value);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return line.toString().strip();
    }

    /** True once the other side has closed; asks without waiting. */
    public boolean isClosedByServer() {
        try {
            socket.setSoTimeout(1);
            InputStream in = socket.getInputStream();
            while (in.read() >= 0) {
                // whatever was said before
            }
            return true;
        } catch (java.net.SocketTimeoutException open) {
            return false;
        } catch (IOException closed) {
            return true;
        }
    }

    @Override
    public void close() {
        try {
            socket.close();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
