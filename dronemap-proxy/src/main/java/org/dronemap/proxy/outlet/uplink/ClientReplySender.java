package org.dronemap.proxy.outlet.uplink;

import org.dronemap.core.drone.DroneId;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Statustext;
import org.dronemap.proxy.outlet.client.ClientMessage;
import org.dronemap.proxy.outlet.client.OutletClient;

/**
 * Sends messages and texts to a ground station at the outlet in the name of a drone's autopilot. Owned by the outlet's
 * thread.
 */
record ClientReplySender(OutletClient client, DroneId drone, VehicleFrameCache vehicle) {
    private static final int WARNING = 4;
    private static final int CHUNK = 50;
    private static final int MOST_CHUNKS = 5;

    void send(Message message) {
        client.enqueue(new ClientMessage.ForVehicle(drone, vehicle.component(), message));
    }

    /** Says a sentence, in as many parts as that takes; many programs show ASCII alone. */
    void explain(String written) {
        String sentence = plain(written);
        int parts = Math.min(MOST_CHUNKS, (sentence.length() + CHUNK - 1) / CHUNK);
        int number = parts > 1 ? client.nextText() : 0;
        for (int part = 0; part < parts; part++) {
            String text = sentence.substring(part * CHUNK, Math.min(sentence.length(), (part + 1) * CHUNK));
            send(new Statustext(WARNING, text, number, part));
        }
    }

    private static String plain(String written) {
        return written.replaceAll("[\u201c\u201d]", "\"")
                .replaceAll("[\u2018\u2019]", "'")
                .replaceAll("[\u2010-\u2015\u2212]", "-")
                .replace("\u2026", "...");
    }
}
