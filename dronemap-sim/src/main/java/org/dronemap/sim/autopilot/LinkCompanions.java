package org.dronemap.sim.autopilot;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.sim.flight.TextSeverity;

/**
 * The others on the link of a simulated vehicle: each sends a heartbeat every second, and texts when it is told to.
 * Owned by its vehicle.
 */
public final class LinkCompanions {
    private static final long BEAT_MILLIS = 1_000;

    private final int vehicle;
    private final int mavlinkVersion;
    private final Consumer<byte[]> link;
    private final Map<LinkCompanion, FrameWriter> present = new EnumMap<>(LinkCompanion.class);
    private final Map<LinkCompanion, TextSender> texts = new EnumMap<>(LinkCompanion.class);
    private long nextBeat;

    LinkCompanions(int vehicle, int mavlinkVersion, Consumer<byte[]> link) {
        this.vehicle = vehicle;
        this.mavlinkVersion = mavlinkVersion;
        this.link = link;
    }

    /** Who is there from now on. */
    public void set(List<LinkCompanion> companions) {
        present.clear();
        texts.clear();
        for (LinkCompanion companion : companions) {
            present.put(companion, new FrameWriter(companion.system(vehicle), companion.component(), mavlinkVersion));
            texts.put(companion, new TextSender(message -> send(companion, message)));
        }
    }

    public List<LinkCompanion> present() {
        return new ArrayList<>(present.keySet());
    }

    void step(long nowMillis) {
        if (nowMillis < nextBeat) {
            return;
        }
        nextBeat = nowMillis + BEAT_MILLIS;
        present.keySet().forEach(companion -> send(companion, companion.heartbeat()));
    }

    public void sendText(LinkCompanion companion, TextSeverity severity, String text) {
        TextSender sender = texts.get(companion);
        if (sender != null) {
            sender.send(severity, text);
        }
    }

    private void send(LinkCompanion companion, Message message) {
        FrameWriter writer = present.get(companion);
        if (writer != null) {
            link.accept(writer.frame(message));
        }
    }
}
