package org.dronemap.core.history;

import org.jspecify.annotations.Nullable;

/**
 * How well things are remembered at the moment.
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
