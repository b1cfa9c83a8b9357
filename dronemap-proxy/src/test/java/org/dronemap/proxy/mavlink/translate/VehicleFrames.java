package org.dronemap.proxy.mavlink.translate;

import java.nio.ByteBuffer;
import java.util.concurrent.atomic.AtomicReference;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.jspecify.annotations.Nullable;

/** Frames as the components of one vehicle send them. */
final class VehicleFrames {
    private VehicleFrames() {}

    static Frame of(int componentId, Message message) {
        AtomicReference<@Nullable Frame> parsed = new AtomicReference<>();
        byte[] bytes = new FrameWriter(7, componentId, 2).frame(message);
        new FrameReader().read(ByteBuffer.wrap(bytes), parsed::set);
        Frame frame = parsed.get();
        if (frame == null) {
            throw new AssertionError("no frame of " + message);
        }
        return frame;
    }
}
