package org.dronemap.proxy.record;

import org.dronemap.core.cloud.SendAuthority;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/**
 * Listener for all text messages to and from one ROSLink robot, such as the recorder. Secrets are blanked out before. A
 * null text was left out; then {@code bytes} says how long it was. Any thread; returns at once.
 */
public interface TextMessageTap {
    /** Hears nothing. */
    TextMessageTap NONE = new TextMessageTap() {
        @Override
        public void received(@Nullable String text, int bytes) {}

        @Override
        public void sent(@Nullable String text, int bytes, SendAuthority mandate) {}

        @Override
        public void working(boolean now) {}

        @Override
        public void bound(DroneId drone) {}

        @Override
        public void ended() {}
    };

    /** A message came from the drone. */
    void received(@Nullable String text, int bytes);

    /** A message went to it by that mandate. */
    void sent(@Nullable String text, int bytes, SendAuthority mandate);

    /** Whether there is something to record: it is armed, moves, or is told what to do. */
    void working(boolean now);

    /** From now on the session speaks for this drone. */
    void bound(DroneId drone);

    /** The session is over. */
    void ended();
}
