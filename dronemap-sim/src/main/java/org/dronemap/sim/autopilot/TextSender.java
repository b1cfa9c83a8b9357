package org.dronemap.sim.autopilot;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.function.Consumer;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Statustext;
import org.dronemap.sim.flight.TextSeverity;

/**
 * Sends texts as STATUSTEXT, those that are too long for one in pieces with a number that counts anew at each boot.
 * Owned by its vehicle.
 */
final class TextSender {
    private static final int PIECE = 50;

    private final Consumer<Message> out;
    private int lastId;

    TextSender(Consumer<Message> out) {
        this.out = out;
    }

    void send(TextSeverity severity, String text) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        if (bytes.length <= PIECE) {
            out.accept(new Statustext(severity.number(), text, 0, 0));
            return;
        }
        lastId = lastId % 0xFFFF + 1;
        // A text that fills its last piece ends with an empty one: only a zero says that nothing follows.
        for (int piece = 0; piece * PIECE <= bytes.length; piece++) {
            byte[] part = Arrays.copyOfRange(bytes, piece * PIECE, Math.min(bytes.length, (piece + 1) * PIECE));
            out.accept(new Statustext(severity.number(), new String(part, StandardCharsets.UTF_8), lastId, piece));
        }
    }
}
