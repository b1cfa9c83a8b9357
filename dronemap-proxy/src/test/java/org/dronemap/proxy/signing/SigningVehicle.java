package org.dronemap.proxy.signing;

import java.nio.ByteBuffer;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.access.LinkKey;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.signing.OutgoingSigner;
import org.dronemap.mavlink.signing.SigningClock;
import org.dronemap.mavlink.signing.SigningKey;

/** The other side of a link: real frames of system 7, signed or not. */
final class SigningVehicle {
    static final int SYSTEM_ID = 7;
    private static final Heartbeat BEAT = new Heartbeat(2, 3, 81, 4, 4, 3);

    private final FrameWriter writer = new FrameWriter(SYSTEM_ID, 1, 2);
    private final SigningClock clock;

    SigningVehicle(InstantSource wall) {
        clock = new SigningClock(wall, 0);
    }

    Frame unsigned() {
        return unsigned(BEAT);
    }

    Frame unsigned(Message message) {
        return frame(writer.frame(message));
    }

    Frame signed(LinkKey key) {
        return signed(key, 0);
    }

    Frame signed(LinkKey key, int linkId) {
        return frame(writer.frame(BEAT, new OutgoingSigner(new SigningKey(key.secret()), clock, linkId)));
    }

    static Frame frame(byte[] bytes) {
        List<Frame> frames = new ArrayList<>();
        new FrameReader().read(ByteBuffer.wrap(bytes), frames::add);
        return frames.get(0);
    }

    static LinkKey key(int first) {
        byte[] secret = new byte[LinkKey.BYTES];
        for (int i = 0; i < secret.length; i++) {
            secret[i] = (byte) (first + i);
        }
        return new LinkKey(secret);
    }
}
