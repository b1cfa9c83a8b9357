package org.dronemap.ws.server;

import java.time.Duration;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.history.FlightRegistry;
import org.dronemap.core.history.FlightStore;
import org.dronemap.core.history.HistoryMaintenance;
import org.dronemap.core.history.HistoryPolicy;
import org.dronemap.core.history.HistoryRecorder;
import org.dronemap.core.history.TelemetryStore;
import org.dronemap.core.history.TelemetryWriter;
import org.dronemap.core.time.Time;

/** Builds and starts what records telemetry, events and flights of all drones to the store. */
final class HistoryBuilder {
    private static final Duration FLIGHTS_EVERY = Duration.ofSeconds(1);
    private static final Duration TIDY_EVERY = Duration.ofHours(1);
    private static final String LETTERS = "abcdefghjkmnpqrstuvwxyz23456789";
    private static final int LETTERS_OF_AN_ID = 12;

    private final HistoryPolicy policy;
    private final TelemetryStore telemetry;
    private final TelemetryWriter writer;
    private final ShutdownSequence closing;
    private final Time time;

    /**
     * What is opened is handed to {@code closing}. The writer is opened here, before what tells of drones, and so closed
     * after it: what that tells to the last is written, too.
     */
    HistoryBuilder(HistoryPolicy policy, TelemetryStore telemetry, ShutdownSequence closing, Time time) {
        this.policy = policy;
        this.telemetry = telemetry;
        this.closing = closing;
        this.time = time;
        this.writer = new TelemetryWriter(telemetry, TelemetryWriter.BatchSettings.DEFAULT, time);
        closing.add("the telemetry", writer);
    }

    /** From now on. */
    HistoryRecorder open(FlightStore flightStore, CloudManager cloud) {
        HistoryMaintenance keeper = new HistoryMaintenance(telemetry, policy.retention(), time);
        FlightRegistry flights = new FlightRegistry(flightStore, FLIGHTS_EVERY, time);
        closing.add("the keeper of old telemetry", keeper);
        closing.add("the flights", flights);
        HistoryRecorder history = new HistoryRecorder(
                new HistoryRecorder.Persistence(telemetry, writer, flights, keeper), policy, time.clock(), this::newId);
        keeper.start(TIDY_EVERY);
        writer.start();
        flights.start();
        history.start();
        cloud.addListener(history);
        return history;
    }

    private String newId() {
        StringBuilder id = new StringBuilder();
        for (int i = 0; i < LETTERS_OF_AN_ID; i++) {
            id.append(LETTERS.charAt(time.random().nextInt(LETTERS.length())));
        }
        return id.toString();
    }
}
