package org.dronemap.core.history;

import org.jspecify.annotations.Nullable;

/**
 * Health of history recording: current trouble, and points and events written, dropped and waiting.
 *
 * @param trouble a sentence; null: all is written down as it comes
 * @param written points and events since the start
 * @param dropped points and events that are missing for ever, since the start
 * @param waiting points and events that are not written yet
 */
public record HistoryHealth(@Nullable String trouble, long written, long dropped, int waiting) {
    public boolean isUp() {
        return trouble == null;
    }
}
