package org.dronemap.sim.load;

import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Base64;
import java.util.Random;
import java.util.stream.Collectors;

/**
 * Load test: measures the latency of positions in the state stream, from when each was due to be sent. Reads the
 * WebSocket itself, so that no library's threads are measured.
 */
final class StreamLatencyWatcher {
    private static final int READ_MILLIS = 200;
    private static final int TEXT = 1;
    private static final int CLOSE = 8;
    private static final int PING = 9;
    private static final int PONG = 10;

    private final SendSchedule pace;
    private final long fromNanos;
    private final long untilNanos;
    private final Socket socket;
    private final DataInputStream in;
    private final OutputStream out;
    private final LatencyPercentiles age = new LatencyPercentiles();
    private final LatencyPercentiles[] ageByHost;
    private final int[] lastStep;
    private long messages;
    private long bytes;

    StreamLatencyWatcher(LoadArguments arguments) throws IOException {
        pace = new SendSchedule(
                arguments.longInteger("--start-nanos"), arguments.integer("--vehicles"), arguments.integer("--rate"));
        fromNanos = arguments.longInteger("--from-nanos");
        untilNanos = arguments.longInteger("--until-nanos");
        ageByHost = new LatencyPercentiles[Math.toIntExact((long) arguments.number("--hosts", 1))];
        Arrays.setAll(ageByHost, host -> new LatencyPercentiles());
        lastStep = new int[pace.vehicles()];
        Arrays.fill(lastStep, -1);
        socket = new Socket(InetAddress.getLoopbackAddress(), arguments.integer("--port"));
        socket.setTcpNoDelay(true);
        in = new DataInputStream(new BufferedInputStream(socket.getInputStream(), 1 << 18));
        out = socket.getOutputStream();
        performHandshake(arguments.integer("--port"), arguments.text("--key"));
        socket.setSoTimeout(READ_MILLIS);
    }

    String run() throws IOException {
        while (System.nanoTime() < untilNanos) {
            frame();
        }
        socket.close();
        return "{\"messages\":" + messages + ",\"bytes\":" + bytes + ",\"vehicles\":" + seen() + ",\"age\":"
                + age.json() + ",\"ageByHost\":["
                + Arrays.stream(ageByHost).map(LatencyPercentiles::json).collect(Collectors.joining(",")) + "]}";
    }

    private long seen() {
        return Arrays.stream(lastStep).filter(step -> step >= 0).count();
    }

    private void performHandshake(int port, String key) throws IOException {
        byte[] nonce = new byte[16];
        new Random().nextBytes(nonce);
        out.write(("GET /stream HTTP/1.1\r\nHost: 127.0.0.1:" + port + "\r\nUpgrade: websocket\r\n"
                        + "Connection: Upgrade\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: "
                        + Base64.getEncoder().encodeToString(nonce) + "\r\nAuthorization: Bearer " + key + "\r\n\r\n")
                .getBytes(StandardCharsets.US_ASCII));
        StringBuilder answer = new StringBuilder();
        while (answer.indexOf("\r\n\r\n") < 0) {
            answer.append((char) in.readUnsignedByte());
        }
        if (!answer.toString().startsWith("HTTP/1.1 101")) {
            throw new IOException("The stream refused: " + answer.toString().split("\r\n", 2)[0]);
        }
    }

    private void frame() throws IOException {
        int first;
        try {
            first = in.readUnsignedByte();
        } catch (SocketTimeoutException e) {
            return;
        }
        long now = System.nanoTime();
        socket.setSoTimeout(0);
        long length = in.readUnsignedByte() & 0x7F;
        if (length == 126) {
            length = in.readUnsignedShort();
        } else if (length == 127) {
            length = in.readLong();
        }
        byte[] payload = in.readNBytes(Math.toIntExact(length));
        socket.setSoTimeout(READ_MILLIS);
        switch (first & 0x0F) {
            case TEXT -> message(new String(payload, StandardCharsets.ISO_8859_1), now);
            case PING -> answer(PONG, payload);
            case CLOSE ->
                throw new IOException("The stream was closed: " + new String(payload, StandardCharsets.UTF_8));
            default -> {}
        }
    }

    /** A client's frames are masked; a mask of zeros changes nothing. */
    private void answer(int kind, byte[] payload) throws IOException {
        byte[] frame = new byte[6 + payload.length];
        frame[0] = (byte) (0x80 | kind);
        frame[1] = (byte) (0x80 | payload.length);
        System.arraycopy(payload, 0, frame, 6, payload.length);
        out.write(frame);
    }

    private void message(String json, long now) {
        if (!json.startsWith("{\"type\":\"drone\"")) {
            return;
        }
        int at = json.indexOf("\"position\":{");
        if (at < 0) {
            return;
        }
        long step = number(json, "\"latitude\":", at) - LoadFrames.LATITUDE_E7;
        long vehicle = (number(json, "\"longitude\":", at) - LoadFrames.LONGITUDE_E7) / LoadFrames.VEHICLE_E7;
        if (vehicle < 0 || vehicle >= lastStep.length) {
            return;
        }
        boolean measured = now >= fromNanos && now < untilNanos;
        if (measured) {
            messages++;
            bytes += json.length();
        }
        // The same position comes again when another fact of the drone changed.
        if (step > lastStep[(int) vehicle]) {
            lastStep[(int) vehicle] = (int) step;
            if (measured) {
                long nanos = now - pace.dueNanos((int) vehicle, step);
                age.add(nanos);
                ageByHost[(int) vehicle % ageByHost.length].add(nanos);
            }
        }
    }

    private static long number(String json, String name, int from) {
        int start = json.indexOf(name, from) + name.length();
        int end = start;
        while (end < json.length() && "+-.0123456789E".indexOf(json.charAt(end)) >= 0) {
            end++;
        }
        return start == end ? -1 : Math.round(Double.parseDouble(json.substring(start, end)) * 1e7);
    }
}
