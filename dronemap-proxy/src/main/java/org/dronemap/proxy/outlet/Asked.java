package org.dronemap.proxy.outlet;

import org.dronemap.core.drone.DroneId;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Statustext;

/** What a client asked of a drone that it sees and that is in contact. Owned by the outlet's thread. */
record Asked(OutletClient client, DroneId drone, VehicleTap vehicle, Frame frame) {
    private static final int WARNING = 4;
    private static final int CHUNK = 50;
    private static final int MOST_CHUNKS = 5;

    /** Answers in the name of the drone's autopilot. */
    void answer(Message message) {
        client.say(new Letter.ForVehicle(drone, vehicle.component(), message));
    }

    /** Who asked, as an answer is addressed. */
    int fromSystem() {
        return frame.systemId();
    }

    int fromComponent() {
        return frame.componentId();
    }

    /** Says why not, in as many parts as that takes. */
    void explain(String sentence) {
        int parts = Math.min(MOST_CHUNKS, (sentence.length() + CHUNK - 1) / CHUNK);
        int number = parts > 1 ? client.nextText() : 0;
        for (int part = 0; part < parts; part++) {
            String text = sentence.substring(part * CHUNK, Math.min(sentence.length(), (part + 1) * CHUNK));
            answer(new Statustext(WARNING, text, number, part));
        }
    }
}
