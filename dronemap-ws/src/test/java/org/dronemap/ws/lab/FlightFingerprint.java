package org.dronemap.ws.lab;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import java.util.function.LongSupplier;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.store.memory.MemoryStores;

/** All frames of all wires, with their times, as one number that two equal flights have in common. */
final class FlightFingerprint {
    private static final int MOST_OPERATIONS = 1_000;
    private static final int MOST_COMMANDS = 10_000;
    private static final int MOST_ENTRIES = 1_000_000;

    private final LongSupplier nanos;
    private final MessageDigest digest;
    private long frames;

    FlightFingerprint(LongSupplier nanos) {
        this.nanos = nanos;
        try {
            digest = MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }

    void said(String vehicle, byte[] bytes) {
        add('>', vehicle, bytes);
    }

    void told(String vehicle, byte[] bytes) {
        add('<', vehicle, bytes);
    }

    private void add(char way, String vehicle, byte[] bytes) {
        frames++;
        digest.update((byte) way);
        digest.update(vehicle.getBytes(StandardCharsets.UTF_8));
        digest.update(ByteBuffer.allocate(Long.BYTES).putLong(nanos.getAsLong()).array());
        digest.update(bytes);
    }

    /** Something else that equal flights have in common. */
    void note(String text) {
        digest.update(text.getBytes(StandardCharsets.UTF_8));
    }

    /** Journals, commands of those drones and virtual drones, as they were kept. */
    void note(MemoryStores stores, List<DroneId> drones) {
        for (String kind : List.of("missionRun", "follow", "dispatch", "recovery")) {
            for (SavedOperation operation : stores.operations().latest(OrganisationId.HOME, kind, MOST_OPERATIONS)) {
                note(operation.toString());
                stores.operations().journal(operation.id(), 0, MOST_ENTRIES).forEach(entry -> note(entry.toString()));
            }
        }
        for (DroneId drone : drones) {
            stores.commands().commandsOf(drone, MOST_COMMANDS).forEach(command -> note(command.toString()));
        }
        stores.virtualDrones().virtualDrones().forEach(drone -> note(drone.toString()));
    }

    long frames() {
        return frames;
    }

    /** SHA-256 of all so far; nothing can be added any more. */
    String sum() {
        return HexFormat.of().formatHex(digest.digest());
    }
}
